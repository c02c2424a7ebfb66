// SPDX-License-Identifier: Apache-2.0
#include "tb/usage_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace blysk {
namespace {

struct character {
  char32_t code;
  std::size_t size;  // bytes; 0 if they are no UTF-8
};

/// The first character of a text that is not empty. Overlong forms, surrogates and codes above 10FFFF are no UTF-8.
character first_character(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < size) return {first, 0};
  char32_t code = first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {first, 0};
    code = code << 6 | (byte(i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least[size] || code > 0x10FFFF || is_surrogate) return {first, 0};
  return {code, size};
}

bool is_printable(char32_t code) {
  struct range {
    char32_t first, last;
  };
  // Controls, separators and blanks other than U+0020, what Unicode's property Default_Ignorable_Code_Point holds, and annotations.
  constexpr std::array<range, 21> hidden{{{0x00, 0x1F},          // C0
                                          {0x7F, 0xA0},          // DEL, C1, blank that does not break
                                          {0x00AD, 0x00AD},      // soft hyphen
                                          {0x034F, 0x034F},      // joiner of graphemes
                                          {0x061C, 0x061C},      // Arabic letter mark
                                          {0x115F, 0x1160},      // Hangul fillers
                                          {0x1680, 0x1680},      // Ogham blank
                                          {0x17B4, 0x17B5},      // Khmer vowels that are not shown
                                          {0x180B, 0x180F},      // Mongolian selectors and separator
                                          {0x2000, 0x200F},      // blanks; of no width; marks of direction
                                          {0x2028, 0x202F},      // separators of lines; embedding, override
                                          {0x205F, 0x206F},      // blank; word joiner; isolates
                                          {0x3000, 0x3000},      // ideographic blank
                                          {0x3164, 0x3164},      // Hangul filler
                                          {0xFE00, 0xFE0F},      // variation selectors
                                          {0xFEFF, 0xFEFF},      // byte order mark
                                          {0xFFA0, 0xFFA0},      // Hangul filler of half width
                                          {0xFFF0, 0xFFFB},      // unassigned; interlinear annotation
                                          {0x1BCA0, 0x1BCA3},    // controls of shorthand
                                          {0x1D173, 0x1D17A},    // controls of music
                                          {0xE0000, 0xE0FFF}}};  // tags, selectors
  return std::none_of(hidden.begin(), hidden.end(),
                      [code](const range& r) { return code >= r.first && code <= r.last; });
}

}  // namespace

usage_error file_error(const std::string& path, std::size_t line, std::string_view what) {
  const std::string_view name = path.empty() ? std::string_view("''") : std::string_view(path);
  return usage_error(line == 0 ? fmt::format("{}: {}", name, what)
                               : fmt::format("{}:{}: {}", name, line, what));
}

std::string system_reason() {
  return errno != 0 ? std::strerror(errno) : "unknown reason";
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto [code, size] = first_character(text);
    const std::string_view bytes = text.substr(0, std::max<std::size_t>(size, 1));
    if (size != 0 && is_printable(code)) {
      result += bytes;
    } else if (bytes.size() == 1) {
      result += fmt::format("\\x{:02X}", static_cast<std::uint8_t>(bytes[0]));
    } else if (code <= 0xFFFF) {
      result += fmt::format("\\u{:04X}", static_cast<std::uint32_t>(code));
    } else {
      result += fmt::format("\\U{:08X}", static_cast<std::uint32_t>(code));
    }
    text.remove_prefix(bytes.size());
  }
  return result;
}

}  // namespace blysk
