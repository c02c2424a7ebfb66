// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/rows.h"

#include <fmt/compile.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "tb/cli/digits.h"

namespace blysk::cli {
namespace {

/// What a field of a column may be.
struct field_range {
  explicit field_range(const wire_format& format)
      : frac(format.frac),
        low(format.min),
        high(format.max),
        scale(std::ldexp(1.0, format.frac)),
        real_low(static_cast<double>(low) / scale),
        real_high(static_cast<double>(high) / scale) {}

  std::string expected() const {
    return frac == 0 ? fmt::format("an integer {}..{}", low, high)
                     : fmt::format("a real number in [{}, {}]", real_low, real_high);
  }

  int frac;
  std::int64_t low, high;
  double scale, real_low, real_high;
};

/// Elements of a column, whatever their storage.
class elements {
 public:
  explicit elements(column& of)
      : kind_(of.kind()), data_(of.visit([](auto& v) -> void* { return v.data(); })) {}

  void put(std::size_t row, std::int64_t value) const {
    switch (kind_) {
      case storage::u8:
        static_cast<std::uint8_t*>(data_)[row] = static_cast<std::uint8_t>(value);
        break;
      case storage::u16:
        static_cast<std::uint16_t*>(data_)[row] = static_cast<std::uint16_t>(value);
        break;
      case storage::u32:
        static_cast<std::uint32_t*>(data_)[row] = static_cast<std::uint32_t>(value);
        break;
      case storage::i32:
        static_cast<std::int32_t*>(data_)[row] = static_cast<std::int32_t>(value);
        break;
      case storage::i64:
        static_cast<std::int64_t*>(data_)[row] = value;
        break;
      case storage::f64:
        static_cast<double*>(data_)[row] = static_cast<double>(value);
        break;
    }
  }

 private:
  storage kind_;
  void* data_;
};

std::int64_t parse_integer(csv_reader& rows, std::size_t column, const field_range& range) {
  const std::string_view field = rows.fields()[column];
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || value < range.low || value > range.high)
    throw rows.error(column, range.expected());
  return value;
}

/// The nearest code, ties up: x 2^f is exact, and its fraction too.
std::int64_t nearest_code(double value, double scale) {
  const double scaled = value * scale;
  const double whole = std::floor(scaled);
  return static_cast<std::int64_t>(whole) + (scaled - whole >= 0.5 ? 1 : 0);
}

double parse_real(csv_reader& rows, std::size_t column, const field_range& range) {
  const std::string_view field = rows.fields()[column];
  double value = 0;
  auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error ==
      std::errc::result_out_of_range) {  // too large, or so small that it is 0: strtod tells them apart
    value = std::strtod(std::string(field).c_str(), nullptr);
    error = std::errc{};
  }
  if (error != std::errc{} || end != field.data() + field.size() ||
      !(value >= range.real_low && value <= range.real_high)) {
    throw rows.error(column, range.expected());
  }
  return value;
}

/// Reads the digits before `end`; false if there is anything else.
bool take(const char*& at, char end, std::int64_t& value) {
  const short_number number = read_short(at, end);
  value = number.value;
  at += number.digits + 1;
  return number.digits != 0;
}

/// Reads "0.5" before `end`, and the like: one digit, a point, up to seven digits.
bool take_real(const char*& at, char end, double& value) {
  static constexpr std::array<std::uint32_t, 8> powers_of_ten{1,      10,      100,       1000,
                                                              10'000, 100'000, 1'000'000, 10'000'000};
  const auto whole = static_cast<std::uint32_t>(at[0] - '0');
  if (whole > 9 || at[1] != '.') return false;
  const short_number decimals = read_short(at + 2, end);
  const std::uint32_t unit = powers_of_ten[decimals.digits];
  value = static_cast<double>(whole * unit + decimals.value) / unit;  // rounded once, as the whole field is
  at += 2 + decimals.digits + 1;
  return decimals.digits != 0;
}

/// A row without blanks whose numbers are short, as most are; false, and nothing said, for any other.
bool parse_plain_row(std::string_view text, const std::vector<field_range>& ranges, std::size_t row,
                     const std::vector<elements>& block) {
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const field_range& range = ranges[i];
    const char separator = i + 1 < ranges.size() ? ',' : *end;
    std::int64_t code = 0;
    if (range.frac == 0) {
      if (!take(at, separator, code) || code < range.low || code > range.high) return false;
    } else {
      double value = 0;
      if (!take_real(at, separator, value) || value < range.real_low || value > range.real_high) return false;
      code = nearest_code(value, range.scale);
    }
    block[i].put(row, code);
  }
  return at == end + 1;
}

/// Any row, field by field.
/// \throws usage_error if it is wrong
void parse_row(csv_reader& rows, const std::vector<field_range>& ranges, std::size_t row,
               const std::vector<elements>& block) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const std::int64_t code = ranges[i].frac == 0
                                  ? parse_integer(rows, i, ranges[i])
                                  : nearest_code(parse_real(rows, i, ranges[i]), ranges[i].scale);
    block[i].put(row, code);
  }
}

/// Room for a field: 20 integer and 36 fraction digits with sign, point and separator, or 3 + 17 digits with an exponent,
/// and what put_fixed() writes beyond its end.
constexpr std::size_t kLongestField = 64;

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

/// raw 2^-fraction as a decimal number, exact, without trailing zeros; fraction 0..36. Up to 40 bytes beyond its end are
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

/// Appends a column's element to the row.
class field_writer {
 public:
  field_writer(const column& of, int fraction)
      : kind_(of.kind()),
        fraction_(fraction),
        data_(of.visit([](const auto& v) -> const void* { return v.data(); })) {}

  char* put(char* to, std::size_t row) const {
    switch (kind_) {
      case storage::u8:
        return put_raw(to, element<std::uint8_t>(row));
      case storage::u16:
        return put_raw(to, element<std::uint16_t>(row));
      case storage::u32:
        return put_raw(to, element<std::uint32_t>(row));
      case storage::i32:
        return put_raw(to, element<std::int32_t>(row));
      case storage::i64:
        return put_raw(to, element<std::int64_t>(row));
      case storage::f64:
        break;
    }
    return fmt::format_to(to, FMT_COMPILE("{}"), element<double>(row));
  }

 private:
  template <class T>
  T element(std::size_t row) const {
    return static_cast<const T*>(data_)[row];
  }
  char* put_raw(char* to, std::int64_t raw) const {
    return fraction_ == 0 && raw >= 0 ? put_integer(to, static_cast<std::uint64_t>(raw))
                                      : put_fixed(to, raw, fraction_);
  }

  storage kind_;
  int fraction_;
  const void* data_;
};

}  // namespace

std::string stimulus_header(const std::vector<port>& ports) {
  return column_names(ports, port::role::data);
}

std::string results_header(const std::vector<port>& ports) {
  return stimulus_header(ports) + "," + column_names(ports, port::role::result);
}

void read_block(csv_reader& rows, const std::vector<port>& ports, columns& block) {
  std::vector<field_range> ranges;
  for (const port& each : of_role(ports, port::role::data)) ranges.emplace_back(*each.carries);
  if (block.width() != ranges.size()) block = columns(ports, port::role::data);
  block.resize(kRowsPerBlock);
  const std::vector<elements> places(block.begin(), block.end());
  std::size_t size = 0;
  for (; size < kRowsPerBlock && rows.next(); ++size) {
    if (!parse_plain_row(rows.text(), ranges, size, places)) parse_row(rows, ranges, size, places);
  }
  block.resize(size);
}

void append_rows(fmt::memory_buffer& text, const std::vector<port>& ports, const row_block& block) {
  if (block.writes.size() == 0) return;
  std::vector<field_writer> fields;
  const auto add = [&](port::role role, const columns& from) {
    const std::vector<port> of = of_role(ports, role);
    for (std::size_t i = 0; i < of.size(); ++i) fields.emplace_back(from[i], of[i].carries->frac);
  };
  add(port::role::data, block.writes);
  add(port::role::result, block.computed);
  const std::size_t size = text.size();
  text.resize(size + block.writes.size() * fields.size() * kLongestField);
  char* to = text.data() + size;
  for (std::size_t row = 0; row < block.writes.size(); ++row) {
    for (const field_writer& each : fields) {
      to = each.put(to, row);
      *to++ = ',';
    }
    to[-1] = '\n';
  }
  text.resize(static_cast<std::size_t>(to - text.data()));
}

}  // namespace blysk::cli
