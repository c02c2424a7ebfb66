// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/rows.h"

#include <fmt/compile.h>

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

void append_text(fmt::memory_buffer& text, const char* data, std::size_t size) {
  text.append(data, data + size);
}

void append_integer(fmt::memory_buffer& text, std::uint64_t value) {
  const fmt::format_int digits(value);
  append_text(text, digits.data(), digits.size());
}

void append_write(fmt::memory_buffer& text, const batch& block, std::size_t i, int fraction) {
  append_integer(text, block.n[i]);
  text.push_back(',');
  append_fixed(text, block.cos_delta[i], fraction);
  for (const std::uint8_t colour : {block.red_ks[i], block.green_ks[i], block.blue_ks[i]}) {
    text.push_back(',');
    append_integer(text, colour);
  }
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

void append_fixed(fmt::memory_buffer& text, std::int64_t raw, int fraction) {
  if (raw < 0) text.push_back('-');
  const auto magnitude = static_cast<std::uint64_t>(raw < 0 ? -raw : raw);
  append_integer(text, magnitude >> fraction);
  const std::uint64_t mask = (std::uint64_t{1} << fraction) - 1;
  std::uint64_t rest = magnitude & mask;
  if (rest == 0) return;
  text.push_back('.');
  constexpr std::uint64_t kGroup = 100'000'000;  // eight digits at a time; 2^24 of them fit 64 bits
  while (rest != 0) {
    rest *= kGroup;
    const fmt::format_int digits(kGroup + (rest >> fraction));  // the leading one keeps the zeros
    append_text(text, digits.data() + 1, digits.size() - 1);
    rest &= mask;
  }
  std::size_t size = text.size();
  while (text[size - 1] == '0') --size;
  text.resize(size);
}

void append_row(fmt::memory_buffer& text, const batch& block, const results& raw, std::size_t i,
                int fraction) {
  append_write(text, block, i, fraction);
  for (const std::int64_t value : {raw.brdf[i], raw.red[i], raw.green[i], raw.blue[i]}) {
    text.push_back(',');
    append_fixed(text, value, fraction);
  }
  text.push_back('\n');
}

void append_row(fmt::memory_buffer& text, const batch& block, double brdf, std::size_t i, int fraction) {
  append_write(text, block, i, fraction);
  fmt::format_to(std::back_inserter(text), FMT_COMPILE(",{},{},{},{}\n"), brdf, brdf * block.red_ks[i],
                 brdf * block.green_ks[i], brdf * block.blue_ks[i]);
}

}  // namespace blysk::cli
