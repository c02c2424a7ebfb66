// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/rows.h"

#include <fmt/compile.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "tb/read_number.h"

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

/// The nearest code, ties up: x 2^f is exact, and its fraction too.
std::int64_t nearest_code(double value, double scale) {
  const double scaled = value * scale;
  const double whole = std::floor(scaled);
  return static_cast<std::int64_t>(whole) + (scaled - whole >= 0.5 ? 1 : 0);
}

std::int64_t parse_integer(csv_reader& rows, std::size_t column, const field_range& range) {
  const auto value = read_integer(rows.fields()[column]);
  if (!value || *value < range.low || *value > range.high) throw rows.error(column, range.expected());
  return *value;
}

/// A row as a program writes it, in the order of the columns and without blanks; false, and nothing said, for any other.
bool parse_plain_row(std::string_view text, const std::vector<field_range>& ranges, std::size_t row,
                     const std::vector<elements>& block) {
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto take = [&](auto& value) {
    const auto [next, error] = std::from_chars(at, end, value);
    at = next;
    return error == std::errc{};
  };
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const field_range& range = ranges[i];
    if (i > 0 && (at == end || *at++ != ',')) return false;
    std::int64_t code = 0;
    if (range.frac == 0) {
      if (!take(code) || code < range.low || code > range.high) return false;
    } else {
      double value = 0;
      if (!take(value) || !(value >= range.real_low && value <= range.real_high)) return false;
      code = nearest_code(value, range.scale);
    }
    block[i].put(row, code);
  }
  return at == end;
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

std::string results_header(const std::vector<port>& ports, row_kind kind) {
  return (kind == row_kind::pixels ? "line,pixel" : stimulus_header(ports)) + "," +
         column_names(ports, port::role::result);
}

class stimulus_reader::row_parser {
 public:
  row_parser(const std::vector<port>& ports, bool clamps) : clamps_(clamps) {
    for (const port& each : of_role(ports, port::role::data)) ranges_.emplace_back(*each.carries);
  }

  std::size_t width() const { return ranges_.size(); }
  std::uint64_t clamped() const { return clamped_; }

  /// \throws usage_error if the row is wrong
  void parse(csv_reader& rows, std::size_t row, const std::vector<elements>& block) {
    if (rows.is_plain() && parse_plain_row(rows.text(), ranges_, row, block)) return;
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const field_range& range = ranges_[i];
      block[i].put(row, range.frac == 0 ? parse_integer(rows, i, range)
                                        : nearest_code(parse_real(rows, i, range), range.scale));
    }
  }

 private:
  double parse_real(csv_reader& rows, std::size_t column, const field_range& range) {
    const auto value = read_real(rows.fields()[column]);
    if (value && *value >= range.real_low && *value <= range.real_high) return *value;
    const bool is_near =
        value && *value >= range.real_low - kClampReach && *value <= range.real_high + kClampReach;
    if (!is_near) throw rows.error(column, range.expected());
    if (!clamps_) throw rows.error(column, range.expected() + ", or --clamp, which takes the nearest");
    ++clamped_;
    return std::clamp(*value, range.real_low, range.real_high);
  }

  std::vector<field_range> ranges_;
  bool clamps_;
  std::uint64_t clamped_ = 0;
};

stimulus_reader::stimulus_reader(csv_reader& rows, std::vector<port> ports, bool clamps)
    : rows_(rows), ports_(std::move(ports)), parser_(std::make_unique<row_parser>(ports_, clamps)) {}

stimulus_reader::~stimulus_reader() = default;

std::uint64_t stimulus_reader::clamped() const {
  return parser_->clamped();
}

void stimulus_reader::read(columns& block) {
  if (block.width() != parser_->width()) block = columns(ports_, port::role::data);
  block.resize(kRowsPerBlock);
  const std::vector<elements> places(block.begin(), block.end());
  std::size_t size = 0;
  while (size < kRowsPerBlock && (size == 0 ? rows_.next() : rows_.next_at_hand()))
    parser_->parse(rows_, size++, places);
  block.resize(size);
}

void append_rows(fmt::memory_buffer& text, const std::vector<port>& ports, const row_block& block,
                 row_kind kind) {
  if (block.writes.size() == 0) return;
  std::vector<field_writer> fields;
  const auto add = [&](port::role role, const columns& from) {
    const std::vector<port> of = of_role(ports, role);
    for (std::size_t i = 0; i < of.size(); ++i) fields.emplace_back(from[i], of[i].carries->frac);
  };
  if (kind == row_kind::writes) add(port::role::data, block.writes);
  add(port::role::result, block.computed);
  const std::size_t size = text.size();
  text.resize(size + block.computed.size() * (fields.size() + 2) * kLongestField);
  char* to = text.data() + size;
  const auto put_row = [&](std::size_t row) {
    for (const field_writer& each : fields) {
      to = each.put(to, row);
      *to++ = ',';
    }
    to[-1] = '\n';
  };
  if (kind == row_kind::writes) {
    for (std::size_t row = 0; row < block.computed.size(); ++row) put_row(row);
  } else {
    std::size_t row = 0;
    for (std::size_t line = 0; line < block.pixels.size(); ++line) {
      for (std::int64_t pixel = 0; pixel < block.pixels[line]; ++pixel, ++row) {
        to = put_integer(to, block.first_line + line);
        *to++ = ',';
        to = put_integer(to, static_cast<std::uint64_t>(pixel));
        *to++ = ',';
        put_row(row);
      }
    }
  }
  text.resize(static_cast<std::size_t>(to - text.data()));
}

}  // namespace blysk::cli
