// SPDX-License-Identifier: Apache-2.0
/// Running error analysis: the steps of a formula in 50 digits, and beside the value what those very steps may
/// lose in `float` or `double`.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "tb/golden/pi.h"
#include "tb/golden/referee.h"

namespace blysk::golden {

/// Thrown by a comparison that rounding may turn: the bound then covers one branch only.
struct undecided {};

/// A number in 50 digits and a bound on the absolute error of the same number computed in Real. Each operation
/// carries the errors of its operands on, exactly rather than to first order, and adds its own: 1 roundoff for
/// a correctly rounded one, 2 for a function of the mathematical library (glibc states below 1 ulp for those
/// used), and a spacing of the subnormal numbers. An operation on exact operands whose result Real holds adds
/// nothing.   Wilkinson, Rounding Errors in Algebraic Processes, 1963
template <class Real>
class bounded {
 public:
  bounded() = default;
  bounded(int exact) : value_(exact) {}
  bounded(Real exact) : value_(exact) {}
  bounded(referee value, referee error) : value_(std::move(value)), error_(std::move(error)) {}

  const referee& value() const { return value_; }
  const referee& error() const { return error_; }

  friend bounded operator-(const bounded& a) { return {-a.value_, a.error_}; }
  friend bounded operator+(const bounded& a, const bounded& b) {
    return rounded(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend bounded operator-(const bounded& a, const bounded& b) { return a + -b; }
  friend bounded operator*(const bounded& a, const bounded& b) {
    return rounded(a.value_ * b.value_,
                   abs(a.value_) * b.error_ + abs(b.value_) * a.error_ + a.error_ * b.error_);
  }
  friend bounded operator/(const bounded& a, const bounded& b) {
    const referee least = abs(b.value_) - b.error_;
    if (!(least > 0)) throw undecided();
    const referee quotient = a.value_ / b.value_;
    return rounded(quotient, (a.error_ + abs(quotient) * b.error_) / least);
  }

  friend bool operator<(const bounded& a, const bounded& b) {
    const referee error = a.error_ + b.error_;
    if (error > 0 && abs(a.value_ - b.value_) <= error) throw undecided();
    return a.value_ < b.value_;
  }
  friend bool operator>(const bounded& a, const bounded& b) { return b < a; }
  friend bool operator<=(const bounded& a, const bounded& b) { return !(b < a); }
  friend bool operator==(const bounded& a, const bounded& b) { return !(a < b) && !(b < a); }

  // These never decide: neither falls apart where its arguments meet, and the larger error covers both.
  friend bounded min(const bounded& a, const bounded& b) { return extreme(a, b, a.value_ < b.value_); }
  friend bounded max(const bounded& a, const bounded& b) { return extreme(a, b, a.value_ > b.value_); }
  friend bounded clamp(const bounded& x, const bounded& low, const bounded& high) {
    return min(max(x, low), high);
  }

  friend bounded sqrt(const bounded& x) {
    return monotone(x, 1, [](const referee& y) { return y > 0 ? sqrt(y) : referee(0); });
  }
  friend bounded exp(const bounded& x) {
    return monotone(x, 2, [](const referee& y) { return exp(y); });
  }
  friend bounded expm1(const bounded& x) {
    return monotone(x, 2, [](const referee& y) { return expm1(y); });
  }
  friend bounded log(const bounded& x) {
    return monotone(x, 2, [](const referee& y) { return log(y); });
  }
  friend bounded log1p(const bounded& x) {
    return monotone(x, 2, [](const referee& y) { return log1p(y); });
  }
  friend bounded asin(const bounded& x) {
    return monotone(x, 2, [](const referee& y) { return asin(y < 1 ? y : referee(1)); });
  }
  friend bounded sin(const bounded& x) {
    return rounded(sin(x.value_), abs(cos(x.value_)) * x.error_ + x.error_ * x.error_ / 2, 2);
  }
  friend bounded cos(const bounded& x) {
    return rounded(cos(x.value_), abs(sin(x.value_)) * x.error_ + x.error_ * x.error_ / 2, 2);
  }
  /// x >= 0 to a power that is exact.
  friend bounded pow(const bounded& x, const bounded& power) {
    return monotone(x, 2, [&](const referee& y) { return y > 0 ? pow(y, power.value_) : referee(0); });
  }

 private:
  static bounded rounded(const referee& value, const referee& inherited, int roundings = 1) {
    if (inherited == 0 && referee(static_cast<Real>(value)) == value) return {value, referee(0)};
    return {value, inherited + roundings * roundoff<Real>() * (abs(value) + inherited) +
                       referee(std::numeric_limits<Real>::denorm_min())};
  }

  template <class Function>
  static bounded monotone(const bounded& x, int roundings, const Function& f) {
    const referee value = f(x.value_);
    if (x.error_ == 0) return rounded(value, referee(0), roundings);
    const referee above = abs(f(x.value_ + x.error_) - value);
    const referee below = abs(f(x.value_ - x.error_) - value);
    return rounded(value, above > below ? above : below, roundings);
  }

  static bounded extreme(const bounded& a, const bounded& b, bool first) {
    const bounded& taken = first ? a : b;
    const bool apart = abs(a.value_ - b.value_) > a.error_ + b.error_;
    return {taken.value_, apart || a.error_ + b.error_ == 0 ? taken.error_
                          : a.error_ > b.error_             ? a.error_
                                                            : b.error_};
  }

  referee value_ = 0;
  referee error_ = 0;
};

/// pi, which Real rounds.
template <>
inline bounded<float> pi() {
  return {pi<referee>(), pi<referee>() * roundoff<float>()};
}
template <>
inline bounded<double> pi() {
  return {pi<referee>(), pi<referee>() * roundoff<double>()};
}

}  // namespace blysk::golden

template <class Real>
struct std::numeric_limits<blysk::golden::bounded<Real>> {
  static Real epsilon() { return std::numeric_limits<Real>::epsilon(); }
};
