// SPDX-License-Identifier: Apache-2.0
/// Bit-accurate model of the quadratic device: the blocks' laws composed on plain integers.
#pragma once

#include "rtl_sysc/formats.h"
#include "tb/engine.h"

namespace blysk::bit {

/// Results of one write, raw integers on the nets of the same name.
struct quadratic_result {
  std::int64_t brdf, red, green, blue;
};

/// [P] fig. 1 from register outputs to 25, 26, 27: the laws in the netlist's order.
template <class F>
[[gnu::always_inline]] inline constexpr quadratic_result quadratic(const wired_constants& wired, std::int64_t n,
                                                                   std::int64_t cos_delta, std::int64_t red_ks,
                                                                   std::int64_t green_ks, std::int64_t blue_ks) {
  constexpr std::int64_t carry28 = 1;
  constexpr std::int64_t carry30 = 0;
  const std::int64_t a = F::add15::law(F::mul6::law(n, wired.slope), wired.offset, carry30);
  const std::int64_t diff = F::add9::law(F::mul7::law(cos_delta, cos_delta), F::inv8::law(cos_delta), carry28);
  const std::int64_t parabola = F::add11::law(F::mul10::law(a, diff), cos_delta, carry30);
  const std::int64_t brdf = F::quant11::law(parabola);
  return {brdf, F::mul_colour::law(brdf, red_ks), F::mul_colour::law(brdf, green_ks),
          F::mul_colour::law(brdf, blue_ks)};
}

/// Engine over whole batches; one generic binary, wider vectors where the processor has them.
/// \throws std::invalid_argument for options that no device has
std::unique_ptr<engine> make_quadratic(const device_options& options);

}  // namespace blysk::bit
