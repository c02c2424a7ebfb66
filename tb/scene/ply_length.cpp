// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/ply_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tb/line_reader.h"
#include "tb/scene/text_lines.h"

namespace blysk::scene {
namespace {

struct type {
  std::string_view name, other_name;
  std::size_t bytes;
  bool is_signed;
};

constexpr std::array kTypes{type{"char", "int8", 1, true},     type{"uchar", "uint8", 1, false},
                            type{"short", "int16", 2, true},   type{"ushort", "uint16", 2, false},
                            type{"int", "int32", 4, true},     type{"uint", "uint32", 4, false},
                            type{"float", "float32", 4, true}, type{"double", "float64", 8, true}};

const type* find_type(std::string_view name) {
  for (const type& each : kTypes) {
    if (name == each.name || name == each.other_name) return &each;
  }
  return nullptr;
}

struct property {
  const type* count;  ///< of a list's length; null: no list
  const type* item;
};

struct element {
  std::string_view name;
  std::uint64_t count;
  std::vector<property> properties;
};

struct header {
  std::string_view format;
  std::vector<element> elements;
  std::string_view body;
};

template <class T>
std::optional<T> whole(std::string_view word) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

bool take_property(std::string_view rest, element& of) {
  const std::string_view first = take_word(rest);
  const bool is_list = first == "list";
  const type* const count = is_list ? find_type(take_word(rest)) : nullptr;
  const type* const item = find_type(is_list ? take_word(rest) : first);
  of.properties.push_back({count, item});
  return item != nullptr && (count != nullptr || !is_list);
}

std::optional<header> read_header(std::string_view text) {
  header found;
  bool is_first = true;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::string_view keyword = take_word(line);
    if (is_first && keyword != "ply") return std::nullopt;
    is_first = false;
    if (keyword == "end_header") {
      found.body = text;
      return found;
    }
    if (keyword == "format") {
      found.format = take_word(line);
    } else if (keyword == "element") {
      const std::string_view name = take_word(line);
      const auto count = whole<std::uint64_t>(take_word(line));
      if (!count) return std::nullopt;
      found.elements.push_back({name, *count, {}});
    } else if (keyword == "property") {
      if (found.elements.empty() || !take_property(line, found.elements.back())) return std::nullopt;
    }
  }
  return std::nullopt;
}

/// Takes the values of a body one by one.
class body_reader {
 public:
  body_reader(std::string_view text, bool is_ascii, bool is_big)
      : text_(text), is_ascii_(is_ascii), is_big_(is_big) {}

  /// A length of a list. None: the text ends before it, or it is no length.
  std::optional<std::uint64_t> length(const type& of) {
    if (is_ascii_) return whole<std::uint64_t>(word());
    if (text_.size() < of.bytes || of.name == "float" || of.name == "double") return std::nullopt;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < of.bytes; ++i) {
      const auto byte = static_cast<unsigned char>(text_[i]);
      value |= std::uint64_t{byte} << 8 * (is_big_ ? of.bytes - 1 - i : i);
    }
    text_.remove_prefix(of.bytes);
    return value;
  }

  /// Whether so many values of a type are there.
  bool skip(std::uint64_t count, const type& of) {
    if (!is_ascii_) {
      if (count > text_.size() / of.bytes) return false;
      text_.remove_prefix(count * of.bytes);
      return true;
    }
    for (; count > 0; --count) {
      if (word().empty()) return false;
    }
    return true;
  }

 private:
  std::string_view word() {
    constexpr std::string_view kBlanks = " \t\r\n";
    const std::size_t begin = std::min(text_.find_first_not_of(kBlanks), text_.size());
    const std::size_t end = std::min(text_.find_first_of(kBlanks, begin), text_.size());
    const std::string_view found = text_.substr(begin, end - begin);
    text_.remove_prefix(end);
    return found;
  }

  std::string_view text_;
  bool is_ascii_, is_big_;
};

bool skip_element(body_reader& from, const element& of) {
  for (const property& each : of.properties) {
    std::uint64_t count = 1;
    if (each.count != nullptr) {
      const auto length = from.length(*each.count);
      if (!length) return false;
      count = *length;
    }
    if (!from.skip(count, *each.item)) return false;
  }
  return true;
}

}  // namespace

std::string missing_of_ply(std::string_view text) {
  const std::optional<header> found = read_header(text);
  if (!found) return {};
  const bool is_ascii = found->format == "ascii";
  const bool is_big = found->format == "binary_big_endian";
  if (!is_ascii && !is_big && found->format != "binary_little_endian") return {};
  body_reader body(found->body, is_ascii, is_big);
  for (const element& each : found->elements) {
    if (each.properties.empty()) continue;
    for (std::uint64_t i = 0; i < each.count; ++i) {
      if (!skip_element(body, each))
        return fmt::format("has {} of {} elements '{}', expected all of them", i, each.count,
                           shown(each.name));
    }
  }
  return {};
}

}  // namespace blysk::scene
