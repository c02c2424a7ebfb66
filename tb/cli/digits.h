// SPDX-License-Identifier: Apache-2.0
/// Eight decimal digits side by side in a word, the first in the lowest byte: read without a branch for each.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace blysk::cli {

constexpr std::uint64_t in_every_byte(std::uint64_t byte) {
  return byte * 0x01'01'01'01'01'01'01'01;
}

constexpr std::uint64_t load_eight(const char* from) {
  std::uint64_t word = 0;
  for (int i = 0; i < 8; ++i) word |= std::uint64_t{static_cast<unsigned char>(from[i])} << (8 * i);
  return word;
}

/// Whether each byte is 0..9.
constexpr bool are_digits(std::uint64_t digits) {
  return (((digits + in_every_byte(0x7f - 9)) | digits) & in_every_byte(0x80)) == 0;
}

/// The number that the digits spell: neighbours are joined to 0..99, those to 0..9999, and those.
constexpr std::uint64_t number_of(std::uint64_t digits) {
  digits = (digits * 10 + (digits >> 8)) & 0x00ff'00ff'00ff'00ff;
  digits = (digits * 100 + (digits >> 16)) & 0x0000'ffff'0000'ffff;
  return (digits * 10'000 + (digits >> 32)) & 0xffff'ffff;
}

/// One to seven digits.
struct short_number {
  std::uint32_t value = 0;
  std::size_t digits = 0;  ///< 0: there was something else
};

/// Reads up to the character `end`.
/// \param from  eight characters that can be read
constexpr short_number read_short(const char* from, char end) {
  const std::uint64_t characters = load_eight(from);
  const std::uint64_t differs = characters ^ in_every_byte(static_cast<unsigned char>(end));
  // The subtraction sets the top bit of the lowest byte that is 0, and of none below.
  const std::uint64_t ends = (differs - in_every_byte(1)) & ~differs & in_every_byte(0x80);
  const int bits = std::countr_zero(ends) & ~7;  // of the digits; 64 if there is no end
  if (bits == 0 || bits == 64) return {};
  const std::uint64_t digits = (characters ^ in_every_byte('0')) << (64 - bits);
  if (!are_digits(digits)) return {};
  return {static_cast<std::uint32_t>(number_of(digits)), static_cast<std::size_t>(bits) / 8};
}

}  // namespace blysk::cli
