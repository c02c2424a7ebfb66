// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/whole_number.h"

#include <fmt/format.h>

#include <charconv>
#include <string>

#include "tb/line_reader.h"

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

}  // namespace blysk::cli
