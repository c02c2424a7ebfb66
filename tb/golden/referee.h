// SPDX-License-Identifier: Apache-2.0
/// 50-digit references, and errors counted in roundoffs.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

namespace blysk::golden {

/// 50 decimal digits; no expression templates, so that ternaries and auto stay safe.
using referee =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// Half the distance from 1 to the next number: one rounding's largest relative error.
template <class Real>
referee roundoff() {
  return referee(std::numeric_limits<Real>::epsilon()) / 2;
}

/// Unit in the last place of a number: the spacing of Real's numbers from the power of two at or below it.
/// One ulp is 1 to 2 roundoffs, relatively: 2 at a power of two.
template <class Real>
referee ulp_of(const referee& x) {
  if (x == 0) return referee(std::numeric_limits<Real>::denorm_min());
  const int exponent = std::max(ilogb(x), std::numeric_limits<Real>::min_exponent - 1);
  return ldexp(referee(std::numeric_limits<Real>::epsilon()), exponent);
}

/// What a count of roundoffs allows: bounds are first order, and every intermediate stays within 2^-11 of its exact value,
/// so the higher orders add less than 2^-10 of the bound. The worst, both in float: the slope of the rational lobe,
/// 60 / 0.27 roundoffs, 1.3e-5; the angle-based lobe where it leaves the normal numbers, whose condition number is
/// 2 * 88 there, 22 * 176 roundoffs, 2.3e-4. Below the normal numbers one spacing of theirs comes on top.
template <class Real>
referee allowed_error(const referee& roundoffs) {
  return roundoffs * roundoff<Real>() * (1 + referee(1) / 1024) +
         referee(std::numeric_limits<Real>::denorm_min());
}

}  // namespace blysk::golden
