// SPDX-License-Identifier: Apache-2.0
/// Identities in 50 digits, where double precision would hide a difference.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace blysk::claims::literal {

using real = boost::multiprecision::cpp_bin_float_50;

inline double as_double(const real& x) {
  return static_cast<double>(x);
}

/// Largest |f(n)| over n = first..1000.
template <class F>
double largest_gap(int first, const F& f) {
  real result = 0;
  for (int n = first; n <= 1000; ++n) result = std::max(result, real(abs(real(f(n)))));
  return as_double(result);
}

}  // namespace blysk::claims::literal
