// SPDX-License-Identifier: Apache-2.0
/// The tables of [A]: printed and measured.
#pragma once

#include <array>
#include <string_view>

#include "tb/claims/claim.h"
#include "tb/claims/sweep.h"

namespace blysk::claims {

inline constexpr std::array kLevels{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};  ///< Q
inline constexpr int kPowers = 5;                                                  ///< k = 1..5

/// Exponents of the training set.
inline constexpr std::array kTrainingExponents{1, 2, 3, 4, 5, 7, 10, 20, 50, 100, 200, 500, 1000};

/// By Q and k.
template <class T>
using by_level_and_power = std::array<std::array<T, kPowers>, kLevels.size()>;
using cells = by_level_and_power<double>;

/// Table 1, %: largest relative error of the angle-based lobe against cos^n, n in [k + 1; 1000].
const cells& table1(epicentre where);

/// The same at one exponent, as a share of 1.
double angle_error(double n, double k, double q, epicentre where);

/// Table 2, 10^-3: largest |coef 2 pi Int - 1|, n in [k + 1; 1000].
const cells& table2();

/// What table 1 or 2 prints, from the rows A-T1-0.1 .. or A-T2-0.1 ..
const by_level_and_power<demand>& printed_cells(int number);

/// How many cells meet what is printed, and the largest miss in units of the last printed digit.
struct reproduction {
  int met = 0;
  int within_a_unit = 0;
  double largest_miss = 0;
};

reproduction reproduce(const cells& measured, const by_level_and_power<demand>& printed);

}  // namespace blysk::claims
