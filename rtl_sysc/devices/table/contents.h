// SPDX-License-Identifier: Apache-2.0
/// The words of the read-only memories of table, by integer arithmetic.
#pragma once

#include "rtl_sysc/devices/word_arithmetic.h"

#include <array>
#include <cstddef>

namespace blysk {

/// e^(-i/32), rounded to nearest, at i = 0..255, and 0 at i = 256, where the lobe ends. The root e^(-1/32) has 59 fraction
/// bits; its error grows to less than 2^-50.
/// \param bits  fraction bits of the result, 1..24
constexpr std::int64_t decay_word(std::uint64_t i, int bits) {
  const std::uint64_t root = 558724919503713764;  // e^(-1/32) * 2^59
  return i < 256 ? rounded_word(unit_power(root, i), bits) : 0;
}

/// Lines of e^-t over t in [0, 8), one for each of 256 segments of length 1/32: [0] begins, [1] changes until the next begin,
/// so that a line ends where the next one begins.
template <int Bits>
struct decay_words {
  using table = std::array<std::int64_t, 256>;

  static constexpr std::array<table, 2> make() {
    std::array<table, 2> all{};
    for (std::size_t i = 0; i < 256; ++i) {
      all[0][i] = decay_word(i, Bits);
      all[1][i] = decay_word(i + 1, Bits) - all[0][i];
    }
    return all;
  }

  static constexpr std::array<table, 2> words = make();
};

}  // namespace blysk
