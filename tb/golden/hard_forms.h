// SPDX-License-Identifier: Apache-2.0
/// Each formula that loses digits as it is printed, beside the form that keeps them: what the tests, the table and
/// the plots of stability show.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace blysk::golden {

/// Errors at one point, in ulp of the exact value.
struct loss {
  double literal = 0;  ///< infinite where the literal form is not finite
  double stable = 0;
  double bound = 0;  ///< of the stable form, by running error analysis

  /// How far the literal form is outside what the stable one is sure to keep.
  double factor() const { return literal > 0 ? literal / bound : 0; }
};

/// A formula in one argument, the others fixed.
struct hard_form {
  std::string name;      ///< of its plot
  std::string literal;   ///< as printed
  std::string stable;    ///< as computed
  std::string argument;  ///< what varies, and what is fixed
  std::vector<double> points;
  std::function<loss(double)> in_float;
  std::function<loss(double)> in_double;
  /// What the step that cancels predicts for the literal form at the worst point, in roundoffs; 0 where it loses
  /// nothing. A rounding is somewhere between nothing and its worst, so tests ask for a quarter.
  double predicted_float;
  double predicted_double;
};

/// The point where the literal form is furthest outside the stable form's bound; its `stable` is the largest of all.
loss worst_of(const hard_form& form, const std::function<loss(double)>& at);

const std::vector<hard_form>& hard_forms();

/// Least number of fraction bits for which no cosine, rounded to them, moves cos^n by more than half an 8-bit step,
/// 1/510: found by rounding, for each number of bits, the cosines halfway between all codes.
int cosine_bits(int n);

}  // namespace blysk::golden
