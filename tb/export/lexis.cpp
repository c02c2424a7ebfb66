// SPDX-License-Identifier: Apache-2.0
#include "tb/export/lexis.h"

#include <fmt/format.h>

namespace blysk::verilog {

std::string range_text(int width) {
  return width == 1 ? "" : fmt::format("[{}:0] ", width - 1);
}

std::string literal(wide_int value, int width) {
  wide_int rest = value & ((wide_int{1} << width) - 1);
  std::string digits;
  do {
    digits.insert(digits.begin(), static_cast<char>('0' + static_cast<int>(rest % 10)));
    rest /= 10;
  } while (rest != 0);
  return fmt::format("{}'d{}", width, digits);
}

std::string signed_literal(wide_int value, int width) {
  const std::string magnitude = literal(value < 0 ? -value : value, width);
  const std::size_t base = magnitude.find('\'') + 1;
  return fmt::format("{}{}s{}", value < 0 ? "-" : "", magnitude.substr(0, base), magnitude.substr(base));
}

std::string comment(const std::string& note) {
  return note.empty() ? "" : fmt::format("  // {}", note);
}

std::string file_text(const std::string& title, const std::string& content) {
  return fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "{}"
      "`default_nettype none\n\n"
      "{}\n"
      "`default_nettype wire\n",
      title, content);
}

std::string declaration_text(const netlist::declaration& name) {
  static constexpr const char* kWords[] = {"input  ", "output ", ""};
  return fmt::format("{}{} {}{}{}", kWords[static_cast<int>(name.where)], name.is_reg ? "reg " : "wire",
                     name.bits.is_signed ? "signed " : "", range_text(name.bits.width), name.name);
}

std::string phrase::within(binding loosest) const {
  return rank <= loosest ? text : fmt::format("({})", text);
}

phrase concatenate(const phrase& high, const phrase& low) {
  const auto inner = [](const phrase& part) {
    return part.is_concatenation ? part.text.substr(1, part.text.size() - 2) : part.text;
  };
  return {fmt::format("{{{}, {}}}", inner(high), inner(low)), phrase::primary, true};
}

std::string slice(const std::string& name, int width, int high, int low) {
  if (low == 0 && high == width - 1) return name;
  return high == low ? fmt::format("{}[{}]", name, high) : fmt::format("{}[{}:{}]", name, high, low);
}

}  // namespace blysk::verilog
