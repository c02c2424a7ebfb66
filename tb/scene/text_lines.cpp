// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/text_lines.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "tb/read_number.h"
#include "tb/usage_error.h"

namespace blysk::scene {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

void append_utf8(std::string& to, std::uint32_t code) {
  const auto tail = [&](int shift) { to += static_cast<char>(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) {
    to += static_cast<char>(code);
  } else if (code < 0x800) {
    to += static_cast<char>(0xC0U | (code >> 6));
    tail(0);
  } else if (code < 0x10000) {
    to += static_cast<char>(0xE0U | (code >> 12));
    tail(6);
    tail(0);
  } else {
    to += static_cast<char>(0xF0U | (code >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

std::string from_utf16(std::string_view bytes, bool big_endian) {
  const auto unit = [&](std::size_t at) {
    const auto first = static_cast<std::uint8_t>(bytes[at]);
    const auto second = static_cast<std::uint8_t>(bytes[at + 1]);
    return static_cast<std::uint32_t>(big_endian ? first << 8 | second : second << 8 | first);
  };
  std::string text;
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    std::uint32_t code = unit(at);
    if (code >= 0xD800 && code < 0xDC00 && at + 3 < bytes.size()) {
      const std::uint32_t low = unit(at + 2);
      if (low >= 0xDC00 && low < 0xE000) {
        code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
        at += 2;
      }
    }
    append_utf8(text, code);
  }
  return text;
}

}  // namespace

std::string read_file(const std::string& path) {
  constexpr std::size_t kMost = std::size_t{1} << 32;
  struct close_stream {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  errno = 0;
  const std::unique_ptr<std::FILE, close_stream> file(std::fopen(path.c_str(), "rb"));
  if (!file) throw file_error(path, 0, "cannot be read (" + system_reason() + ")");
  std::string bytes;
  std::vector<char> part(std::size_t{1} << 20);
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), file.get())) {
    bytes.append(part.data(), size);
    if (bytes.size() > kMost) throw file_error(path, 0, "has more than 4 GiB, expected less");
  }
  if (std::ferror(file.get()) != 0) throw file_error(path, 0, "cannot be read (" + system_reason() + ")");
  return bytes;
}

std::string decoded(const std::string& path, std::string bytes) {
  const auto begins = [&](std::string_view mark) {
    return std::string_view(bytes).substr(0, mark.size()) == mark;
  };
  const bool has_pair = bytes.size() >= 2;
  if (begins("\xEF\xBB\xBF")) {
    bytes.erase(0, 3);
  } else if (begins("\xFF\xFE") || (has_pair && bytes[0] != 0 && bytes[1] == 0)) {
    bytes = from_utf16(std::string_view(bytes).substr(begins("\xFF\xFE") ? 2 : 0), false);
  } else if (begins("\xFE\xFF") || (has_pair && bytes[0] == 0 && bytes[1] != 0)) {
    bytes = from_utf16(std::string_view(bytes).substr(begins("\xFE\xFF") ? 2 : 0), true);
  }
  if (const auto zero = bytes.find('\0'); zero != std::string::npos) {
    std::size_t line = 1;
    for (std::size_t i = 0; i < zero; ++i) line += bytes[i] == '\n' ? 1U : 0U;
    throw file_error(path, line, "holds a zero byte, expected text");
  }
  return bytes;
}

std::string_view text_lines::take_part() {
  const auto end = rest_.find_first_of("\r\n");
  std::string_view part = rest_.substr(0, end);
  const bool is_pair = end != std::string_view::npos && rest_.substr(end, 2) == "\r\n";
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + (is_pair ? 2 : 1));
  ++next_number_;
  return part;
}

namespace {

bool holds_name(std::string_view keyword) {
  static constexpr std::array<std::string_view, 5> kNaming{"newmtl", "usemtl", "mtllib", "o", "g"};
  return std::ranges::find(kNaming, keyword) != kNaming.end();
}

bool is_blank_at(std::string_view text, std::size_t at) {
  return at >= text.size() || kBlanks.find(text[at]) != std::string_view::npos;
}

/// The text in front of its comment.
std::string_view without_comment(std::string_view text, bool holds_name) {
  std::size_t at = text.find('#');
  // The place before the first is npos, beyond the end.
  while (holds_name && at != std::string_view::npos &&
         !(is_blank_at(text, at - 1) && is_blank_at(text, at + 1)))
    at = text.find('#', at + 1);
  return text.substr(0, at);
}

}  // namespace

bool text_lines::next() {
  while (!rest_.empty()) {
    number_ = next_number_;
    std::string_view line = take_part();
    std::string_view words = line;
    const bool has_name = holds_name(take_word(words));
    line = without_comment(line, has_name);
    if (line.ends_with('\\')) {
      joined_.clear();
      while (line.ends_with('\\')) {
        joined_.append(line.substr(0, line.size() - 1)).append(" ");
        if (rest_.empty()) {
          line = {};
          break;
        }
        line = without_comment(take_part(), has_name);
      }
      joined_.append(line);
      line = joined_;
    }
    value_ = trimmed(line);
    keyword_ = take_word(value_);
    if (!keyword_.empty()) return true;
  }
  return false;
}

std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text = trimmed(text.substr(word.size()));
  return word;
}

std::optional<double> number_of(std::string_view word) {
  // The words "inf" and "nan" of a program whose numbers broke are none.
  if (word.find_first_not_of("0123456789.eE+-") != std::string_view::npos) return {};
  return read_real(word);
}

}  // namespace blysk::scene
