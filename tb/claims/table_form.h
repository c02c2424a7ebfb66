// SPDX-License-Identifier: Apache-2.0
/// The modified Schlick lobe as [T] table 3.2 and section 3.4 print it; its a is given nowhere.
#pragma once

#include <cmath>
#include <string_view>

#include "tb/golden/errors.h"

namespace blysk::claims {

/// cos^a x / (n - n cos x + cos x).
struct table_form {
  static constexpr std::string_view kName = "schlick-modified-e";

  double n, a;

  double operator()(double c) const { return std::pow(c, a) / (n * (1 - c) + c); }
};

/// The form with the a in [0, n] that makes the largest relative error in an epicentre least.
/// \param n  specular exponent, 1..1000
table_form best_table_form(golden::epicentre where, int n);

/// Largest relative error of best_table_form in its epicentre.
double table_form_error(golden::epicentre where, int n);

}  // namespace blysk::claims
