// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/rows.h"

#include <fmt/compile.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>

#include "tb/cli/digits.h"

namespace blysk::cli {
namespace {

constexpr std::uint32_t kLargestExponent = 1000;
constexpr std::uint32_t kLargestColour = 255;

/// A row of the stimulus.
struct stimulus {
  std::uint32_t n = 0;
  double cos_delta = 0;
  std::uint32_t red_ks = 0, green_ks = 0, blue_ks = 0;
};

std::uint32_t parse_integer(csv_reader& rows, std::size_t column, std::uint32_t low, std::uint32_t high) {
  const std::string_view field = rows.fields()[column];
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || value < low || value > high) {
    throw rows.error(column, fmt::format("an integer {}..{}", low, high));
  }
  return value;
}

double parse_cosine(csv_reader& rows, std::size_t column) {
  const std::string_view field = rows.fields()[column];
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || !(value >= 0 && value <= 1)) {
    throw rows.error(column, "a real number in [0, 1]");
  }
  return value;
}

/// Any row, field by field.
/// \throws usage_error if it is wrong
stimulus parse_row(csv_reader& rows) {
  return {parse_integer(rows, 0, 1, kLargestExponent), parse_cosine(rows, 1),
          parse_integer(rows, 2, 0, kLargestColour), parse_integer(rows, 3, 0, kLargestColour),
          parse_integer(rows, 4, 0, kLargestColour)};
}

/// Reads the digits before `end`; false if there is anything else.
bool take(const char*& at, char end, std::uint32_t& value) {
  const short_number number = read_short(at, end);
  value = number.value;
  at += number.digits + 1;
  return number.digits != 0;
}

/// Reads "0.5," and the like: one digit, a point, up to seven digits.
bool take_cosine(const char*& at, double& value) {
  static constexpr std::array<std::uint32_t, 8> powers_of_ten{1,      10,      100,       1000,
                                                              10'000, 100'000, 1'000'000, 10'000'000};
  const auto whole = static_cast<std::uint32_t>(at[0] - '0');
  if (whole > 1 || at[1] != '.') return false;
  const short_number decimals = read_short(at + 2, ',');
  const std::uint32_t unit = powers_of_ten[decimals.digits];
  value = static_cast<double>(whole * unit + decimals.value) / unit;  // rounded once, as the whole field is
  at += 2 + decimals.digits + 1;
  return decimals.digits != 0;
}

/// A row without blanks whose numbers are short, as most are; false, and nothing said, for any other.
bool parse_plain_row(std::string_view text, stimulus& row) {
  const char* at = text.data();
  const char* const end = at + text.size();
  return take(at, ',', row.n) && take_cosine(at, row.cos_delta) && take(at, ',', row.red_ks) &&
         take(at, ',', row.green_ks) && take(at, *end, row.blue_ks) && at == end + 1 &&
         row.n - 1 < kLargestExponent && row.cos_delta <= 1 &&
         std::max({row.red_ks, row.green_ks, row.blue_ks}) <= kLargestColour;
}

/// Room for the longest row: n, three colours, cos and the results of up to 6 integer and 24 fraction digits with sign
/// and point, or 3 + 17 digits with an exponent, the separators, and what put_fixed() writes beyond its end.
constexpr std::size_t kLongestRow = 256;

/// 0000 to 9999 as text, the first digit in the lowest byte.
constexpr auto kFourDigits = [] {
  std::array<std::uint32_t, 10'000> texts{};
  for (std::uint32_t value = 0; value < texts.size(); ++value) {
    for (const std::uint32_t unit : {1U, 10U, 100U, 1000U})
      texts[value] = texts[value] << 8 | ('0' + value / unit % 10);
  }
  return texts;
}();

/// Writes four bytes.
void put_text(char* to, std::uint32_t text) {
  for (int i = 0; i < 4; ++i) to[i] = static_cast<char>(text >> (8 * i));
}

char* put_integer(char* to, std::uint64_t value) {
  if (value >= kFourDigits.size()) return std::to_chars(to, to + 20, value).ptr;
  const int digits = 1 + (value > 9) + (value > 99) + (value > 999);
  put_text(to, kFourDigits[value] >> (8 * (4 - digits)));
  return to + digits;
}

/// raw 2^-fraction as a decimal number, exact, without trailing zeros; fraction 0..24. Up to 24 bytes beyond its end are
/// written.
char* put_fixed(char* to, std::int64_t raw, int fraction) {
  if (raw < 0) *to++ = '-';
  const auto magnitude = static_cast<std::uint64_t>(raw < 0 ? -raw : raw);
  to = put_integer(to, magnitude >> fraction);
  const std::uint64_t one = std::uint64_t{1} << fraction;
  std::uint64_t rest = magnitude & (one - 1);
  *to = '.';
  for (int decimals = 0; decimals < fraction; decimals += 4) {
    rest *= 10'000;
    put_text(to + 1 + decimals, kFourDigits[rest >> fraction]);
    rest &= one - 1;
  }
  const int decimals = fraction - std::countr_zero(magnitude | one);  // an odd number times 2^-k has k
  return decimals == 0 ? to : to + 1 + decimals;
}

char* put_write(char* to, const batch& writes, std::size_t i, int fraction) {
  to = put_integer(to, writes.n[i]);
  *to++ = ',';
  to = put_fixed(to, writes.cos_delta[i], fraction);
  for (const std::uint8_t colour : {writes.red_ks[i], writes.green_ks[i], writes.blue_ks[i]}) {
    *to++ = ',';
    to = put_integer(to, colour);
  }
  return to;
}

/// Puts the results of write i, each after a comma.
char* put_results(char* to, const batch&, const results& raw, std::size_t i, int fraction) {
  for (const std::int64_t value : {raw.brdf[i], raw.red[i], raw.green[i], raw.blue[i]}) {
    *to++ = ',';
    to = put_fixed(to, value, fraction);
  }
  return to;
}

char* put_results(char* to, const batch& writes, const std::vector<double>& brdf, std::size_t i, int) {
  return fmt::format_to(to, FMT_COMPILE(",{},{},{},{}"), brdf[i], brdf[i] * writes.red_ks[i],
                        brdf[i] * writes.green_ks[i], brdf[i] * writes.blue_ks[i]);
}

}  // namespace

void read_block(csv_reader& rows, int fraction, batch& block) {
  const double scale = std::ldexp(1.0, fraction);
  block.resize(kRowsPerBlock);
  std::size_t size = 0;
  for (; size < kRowsPerBlock && rows.next(); ++size) {
    stimulus row;
    if (!parse_plain_row(rows.text(), row)) row = parse_row(rows);
    block.n[size] = static_cast<std::uint16_t>(row.n);
    block.cos_delta[size] = static_cast<std::uint32_t>(row.cos_delta * scale + 0.5);
    block.red_ks[size] = static_cast<std::uint8_t>(row.red_ks);
    block.green_ks[size] = static_cast<std::uint8_t>(row.green_ks);
    block.blue_ks[size] = static_cast<std::uint8_t>(row.blue_ks);
  }
  block.resize(size);
}

void append_rows(fmt::memory_buffer& text, const row_block& block, int fraction) {
  const batch& writes = block.writes;
  const std::size_t size = text.size();
  text.resize(size + writes.size() * kLongestRow);
  char* to = text.data() + size;
  std::visit(
      [&](const auto& computed) {
        for (std::size_t i = 0; i < writes.size(); ++i) {
          to = put_write(to, writes, i, fraction);
          to = put_results(to, writes, computed, i, fraction);
          *to++ = '\n';
        }
      },
      block.computed);
  text.resize(static_cast<std::size_t>(to - text.data()));
}

}  // namespace blysk::cli
