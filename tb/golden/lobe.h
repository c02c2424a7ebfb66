// SPDX-License-Identifier: Apache-2.0
/// The lobes of lobe_formulas.h as values: one list that the registry, the span calls, the measurements and the
/// tests go through.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "tb/golden/lobe_formulas.h"

namespace blysk::golden {

/// Every function of (n, cos) with a name of its own.
enum class lobe {
  blinn,
  blinn_normalised,
  schlick,
  schlick_modified,
  schlick_modified_a,
  schlick_modified_b,
  schlick_modified_c,
  quadratic_exact,
  quadratic_published,
  quadratic_derived,
  quadratic_energy_safe,
  cosine_quadratic,
  cosine_quadratic_energy,
  cosine_quadratic_energy_safe,
  lyon_2,
  lyon_4,
  lyon_8,
  gx,
  rational,
};

struct named_lobe {
  lobe which;
  std::string_view name;  ///< as in the registry
};

/// Every lobe, in the order of the enumeration.
inline constexpr std::array kLobes{
    named_lobe{lobe::blinn, "blinn"},
    named_lobe{lobe::blinn_normalised, "blinn-normalised"},
    named_lobe{lobe::schlick, "schlick"},
    named_lobe{lobe::schlick_modified, "schlick-modified"},
    named_lobe{lobe::schlick_modified_a, "schlick-modified-a"},
    named_lobe{lobe::schlick_modified_b, "schlick-modified-b"},
    named_lobe{lobe::schlick_modified_c, "schlick-modified-c"},
    named_lobe{lobe::quadratic_exact, "quadratic-exact"},
    named_lobe{lobe::quadratic_published, "quadratic-published"},
    named_lobe{lobe::quadratic_derived, "quadratic-derived"},
    named_lobe{lobe::quadratic_energy_safe, "quadratic-energy-safe"},
    named_lobe{lobe::cosine_quadratic, "cosine-quadratic"},
    named_lobe{lobe::cosine_quadratic_energy, "cosine-quadratic-energy"},
    named_lobe{lobe::cosine_quadratic_energy_safe, "cosine-quadratic-energy-safe"},
    named_lobe{lobe::lyon_2, "lyon-2"},
    named_lobe{lobe::lyon_4, "lyon-4"},
    named_lobe{lobe::lyon_8, "lyon-8"},
    named_lobe{lobe::gx, "gx"},
    named_lobe{lobe::rational, "rational"},
};

constexpr std::string_view name_of(lobe which) {
  return std::ranges::find(kLobes, which, &named_lobe::which)->name;
}

/// Calls use(f) with f(c) the given lobe at exponent n; what depends on n alone is computed once, before.
/// \return  what use returns
template <class Real, class Use>
[[gnu::always_inline]] inline auto with_lobe(lobe which, const Real& n, Use use) {
  switch (which) {
    case lobe::blinn:
      break;
    case lobe::blinn_normalised:
      return use([n](const Real& c) { return blinn_normalised(n, c); });
    case lobe::schlick:
      return use([n](const Real& c) { return schlick(n, c); });
    case lobe::schlick_modified:
      return use([n](const Real& c) { return schlick_modified(schlick_reading::d, n, c); });
    case lobe::schlick_modified_a:
      return use([n](const Real& c) { return schlick_modified(schlick_reading::a, n, c); });
    case lobe::schlick_modified_b:
      return use([n](const Real& c) { return schlick_modified(schlick_reading::b, n, c); });
    case lobe::schlick_modified_c:
      return use([n](const Real& c) { return schlick_modified(schlick_reading::c, n, c); });
    case lobe::quadratic_exact:
      return use([a = coefficient(coefficient_line::exact, n)](const Real& c) { return quadratic(a, c); });
    case lobe::quadratic_published:
      return use(
          [a = coefficient(coefficient_line::published, n)](const Real& c) { return quadratic(a, c); });
    case lobe::quadratic_derived:
      return use([a = coefficient(coefficient_line::derived, n)](const Real& c) { return quadratic(a, c); });
    case lobe::quadratic_energy_safe:
      return use([a = coefficient(coefficient_line::derived, n)](const Real& c) {
        return quadratic_energy_safe(a, c);
      });
    case lobe::cosine_quadratic:
      return use([n](const Real& c) { return cosine_quadratic(n, c); });
    case lobe::cosine_quadratic_energy:
      return use([n](const Real& c) { return cosine_quadratic_energy(n, c); });
    case lobe::cosine_quadratic_energy_safe:
      return use([n](const Real& c) { return cosine_quadratic_energy_safe(n, c); });
    case lobe::lyon_2:
      return use([n](const Real& c) { return lyon<2>(n, c); });
    case lobe::lyon_4:
      return use([n](const Real& c) { return lyon<4>(n, c); });
    case lobe::lyon_8:
      return use([n](const Real& c) { return lyon<8>(n, c); });
    case lobe::gx:
      return use([n](const Real& c) { return gx(n, c); });
    case lobe::rational:
      return use(rational_lobe<Real>(n));
  }
  return use([n](const Real& c) { return blinn(n, c); });
}

/// The lobe at one point, unchecked.
/// \param n  specular exponent, [1, 1000]
/// \param c  cos(delta), [0, 1]
template <class Real>
Real evaluate(lobe which, const Real& n, const Real& c) {
  return with_lobe(which, n, [&](const auto& f) { return Real(f(c)); });
}

/// The lobe over a whole picture: out[i] = evaluate(which, n, cosines[i]), bit for bit.
/// One binary holds the loop for several vector widths and takes the widest that the processor has; the
/// lobes that need a power or a trigonometric function stay scalar.
/// \param cosines  each in [0, 1]
/// \param out      as long as cosines, and not overlapping them
/// \throws std::domain_error  n outside [1, 1000], or the lengths differ
void evaluate(lobe which, double n, std::span<const double> cosines, std::span<double> out);
void evaluate(lobe which, float n, std::span<const float> cosines, std::span<float> out);

}  // namespace blysk::golden
