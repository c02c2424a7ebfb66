// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/table_form.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>

namespace blysk::claims {

using namespace golden;
namespace {

/// The form over c^n with b = n - a: c^-b / (n (1 - c) + c). From 1 at c = 1 it falls, as the angle grows, to its one
/// minimum at c = b n / ((n - 1)(1 + b)) and rises from there on; a larger b raises it everywhere.
struct quotient {
  double n, edge;

  double at(double b, double c) const { return std::pow(c, -b) / (n * (1 - c) + c); }
  double shortfall(double b) const { return 1 - at(b, std::clamp(b * n / ((n - 1) * (1 + b)), edge, 1.0)); }
  double excess(double b) const { return at(b, edge) - 1; }
};

}  // namespace

table_form best_table_form(epicentre where, int n) {
  if (n == 1) return {1, 1};  // cos x itself
  const quotient q{static_cast<double>(n), epicentre_edge(where, n)};
  // The excess rises with b and the shortfall falls: the larger of both is least where they are equal.
  const auto [low, high] =
      boost::math::tools::bisect([&](double b) { return q.excess(b) - q.shortfall(b); }, 0.0, n - 1.0,
                                 boost::math::tools::eps_tolerance<double>());
  return {q.n, q.n - (low + high) / 2};
}

double table_form_error(epicentre where, int n) {
  if (n == 1) return 0;
  const quotient q{static_cast<double>(n), epicentre_edge(where, n)};
  return q.shortfall(q.n - best_table_form(where, n).a);
}

}  // namespace blysk::claims
