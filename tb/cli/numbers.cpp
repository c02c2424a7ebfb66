// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>

#include "tb/line_reader.h"
#include "tb/read_number.h"

namespace blysk::cli {

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
  const auto judge = [least, most](std::string& text) -> std::string {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size() && least <= value && value <= most) {
      text = std::to_string(value);  // "010" is ten to us, but eight to the reader
      return {};
    }
    return fmt::format("is '{}', expected a whole number from {} to {}", shown(text), least, most);
  };
  return CLI::Validator(judge, fmt::format("{}..{}", least, most));
}

CLI::Validator real_number(double least, double most) {
  const bool is_bounded = std::isfinite(least) && std::isfinite(most);
  const std::string range = is_bounded ? fmt::format("{}..{}", least, most) : "";
  const std::string expected = is_bounded ? fmt::format(" from {} to {}", least, most) : "";
  const auto judge = [=](std::string& text) -> std::string {
    const std::optional<double> value = read_real(text);
    if (!value || (is_bounded && !(*value >= least && *value <= most)))
      return fmt::format("is '{}', expected a number{}", shown(text), expected);
    text = fmt::format("{}", *value);
    return {};
  };
  return CLI::Validator(judge, range);
}

}  // namespace blysk::cli
