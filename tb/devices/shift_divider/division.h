// SPDX-License-Identifier: Apache-2.0
/// Bit-accurate division by shifts for any number of them.
#pragma once

#include <cstdint>
#include <vector>

#include "rtl_sysc/devices/shift_divider/formats.h"
#include "tb/device.h"

namespace blysk::shift_divider_device {

/// The words of the ROM for any number of steps.
inline std::vector<std::int64_t> reciprocals(int steps) {
  std::vector<std::int64_t> words(std::size_t{run_length::max} + 1, 0);
  for (std::size_t k = 1; k < words.size(); ++k) words[k] = rounded_ratio(1, k, steps);
  return words;
}

/// The blocks' laws in the order of the clock edges.
/// \return  the increment, raw, with `steps` fraction bits
inline std::int64_t divide(std::int64_t difference, std::int64_t digits, int steps) {
  const int width = steps + 1;
  std::int64_t sum = law::first_bit(digits, width) != 0 ? law::move_up(difference, steps) : 0;
  std::int64_t shifted = law::move_up(difference, steps - 1);
  for (int step = 1; step <= steps; ++step) {
    digits = law::other_bits(digits, width);
    if (law::first_bit(digits, width) != 0) sum = law::add<std::int64_t>(sum, 0, shifted, 0, 0);
    shifted = law::halve(shifted);
  }
  return sum;
}

/// The word length "steps".
/// \throws std::invalid_argument if it is missing, outside 1..48, or not the only one
int steps_of(const word_lengths& bits);

/// Run lengths with one digit, from 2 on.
std::vector<std::int64_t> powers_of_two();

}  // namespace blysk::shift_divider_device
