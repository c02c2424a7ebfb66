// SPDX-License-Identifier: Apache-2.0
#include "tb/read_number.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

namespace blysk {
namespace {

std::string_view without_plus(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  return text;
}

}  // namespace

std::optional<double> read_real(std::string_view text) {
  text = without_plus(text);
  const char* const last = text.data() + text.size();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (end != last || error == std::errc::invalid_argument) return std::nullopt;
  // Out of range is too large, or so small that it is 0: strtod tells them apart.
  return error == std::errc{} ? value : std::strtod(std::string(text).c_str(), nullptr);
}

std::optional<std::int64_t> read_integer(std::string_view text) {
  const std::string_view digits = without_plus(text);
  const char* const last = digits.data() + digits.size();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), last, value);
  if (end == last && error == std::errc{}) return value;
  const std::optional<double> real = read_real(text);
  constexpr double kExact = 0x1p53;  // whole numbers up to here are doubles
  if (!real || *real != std::floor(*real) || std::abs(*real) > kExact) return std::nullopt;
  return static_cast<std::int64_t>(*real);
}

}  // namespace blysk
