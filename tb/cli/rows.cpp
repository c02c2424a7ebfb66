// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/rows.h"

#include <fmt/compile.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>

namespace blysk::cli {
namespace {

std::int64_t parse_integer(const csv_reader& rows, std::size_t column, int low, int high) {
  const std::string_view field = rows.fields()[column];
  int value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || value < low || value > high) {
    throw rows.error(column, fmt::format("an integer {}..{}", low, high));
  }
  return value;
}

/// cos(delta) as the code that register 2 takes.
std::uint32_t parse_cosine(const csv_reader& rows, std::size_t column, double scale) {
  const std::string_view field = rows.fields()[column];
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || !(value >= 0 && value <= 1)) {
    throw rows.error(column, "a real number in [0, 1]");
  }
  return static_cast<std::uint32_t>(std::floor(value * scale + 0.5));
}

/// A row is written here and appended as a whole. The longest: 5 integers of up to 4 digits, cos and the results of up to
/// 6 integer and 24 fraction digits with sign and point, or 3 + 17 digits with an exponent, and the separators.
constexpr std::size_t kLongestRow = 256;

char* put_integer(char* to, std::uint64_t value) {
  return std::to_chars(to, to + 20, value).ptr;
}

/// The eight decimal digits of value < 10^8, the first in the lowest byte, each 0..9: halves are divided by 10^4, 10^2
/// and 10 side by side.
constexpr std::uint64_t eight_digits(std::uint64_t value) {
  const std::uint64_t fours = (value / 10000) | (value % 10000) << 32;
  const std::uint64_t hundreds = (fours * 10486 >> 20) & 0x7f'0000'007f;  // / 100, exact below 10^4
  const std::uint64_t twos = hundreds | (fours - 100 * hundreds) << 16;
  const std::uint64_t tens = (twos * 103 >> 10) & 0x0f'000f'000f'000f;  // / 10, exact below 100
  return tens | (twos - 10 * tens) << 8;
}
static_assert(eight_digits(12345678) == 0x08'07'06'05'04'03'02'01 &&
              eight_digits(99990009) == 0x09'00'00'00'09'09'09'09);

/// raw 2^-fraction as a decimal number, exact, without trailing zeros; fraction 0..24.
char* put_fixed(char* to, std::int64_t raw, int fraction) {
  if (raw < 0) *to++ = '-';
  const auto magnitude = static_cast<std::uint64_t>(raw < 0 ? -raw : raw);
  to = put_integer(to, magnitude >> fraction);
  const std::uint64_t mask = (std::uint64_t{1} << fraction) - 1;
  std::uint64_t rest = magnitude & mask;
  if (rest == 0) return to;
  *to++ = '.';
  for (;;) {
    rest *= 100'000'000;  // eight digits at a time; 2^24 of them fit 64 bits
    const std::uint64_t digits = eight_digits(rest >> fraction);
    const std::uint64_t text = digits + 0x30'30'30'30'30'30'30'30;
    for (int i = 0; i < 8; ++i) to[i] = static_cast<char>(text >> (8 * i));
    rest &= mask;
    if (rest == 0) return to + (64 - std::countl_zero(digits) + 7) / 8;  // the last digit is not 0
    to += 8;
  }
}

char* put_write(char* to, const batch& block, std::size_t i, int fraction) {
  to = put_integer(to, block.n[i]);
  *to++ = ',';
  to = put_fixed(to, block.cos_delta[i], fraction);
  for (const std::uint8_t colour : {block.red_ks[i], block.green_ks[i], block.blue_ks[i]}) {
    *to++ = ',';
    to = put_integer(to, colour);
  }
  return to;
}

}  // namespace

void read_block(csv_reader& rows, int fraction, batch& block) {
  const double scale = std::ldexp(1.0, fraction);
  block.resize(0);
  while (block.size() < kRowsPerBlock && rows.next()) {
    block.n.push_back(static_cast<std::uint16_t>(parse_integer(rows, 0, 1, 1000)));
    block.cos_delta.push_back(parse_cosine(rows, 1, scale));
    block.red_ks.push_back(static_cast<std::uint8_t>(parse_integer(rows, 2, 0, 255)));
    block.green_ks.push_back(static_cast<std::uint8_t>(parse_integer(rows, 3, 0, 255)));
    block.blue_ks.push_back(static_cast<std::uint8_t>(parse_integer(rows, 4, 0, 255)));
  }
}

void append_row(fmt::memory_buffer& text, const batch& block, const results& raw, std::size_t i,
                int fraction) {
  std::array<char, kLongestRow> row;
  char* end = put_write(row.data(), block, i, fraction);
  for (const std::int64_t value : {raw.brdf[i], raw.red[i], raw.green[i], raw.blue[i]}) {
    *end++ = ',';
    end = put_fixed(end, value, fraction);
  }
  *end++ = '\n';
  text.append(row.data(), end);
}

void append_row(fmt::memory_buffer& text, const batch& block, double brdf, std::size_t i, int fraction) {
  std::array<char, kLongestRow> row;
  text.append(row.data(), put_write(row.data(), block, i, fraction));
  fmt::format_to(std::back_inserter(text), FMT_COMPILE(",{},{},{},{}\n"), brdf, brdf * block.red_ks[i],
                 brdf * block.green_ks[i], brdf * block.blue_ks[i]);
}

}  // namespace blysk::cli
