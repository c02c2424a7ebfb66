// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/ply_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tb/line_reader.h"
#include "tb/read_number.h"
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
  bool is_of_vertices;  ///< a list of their indices
};

struct element {
  std::string_view name;
  std::uint64_t count;
  std::vector<property> properties;
};

struct header {
  std::string_view format;
  std::size_t lines = 0;  ///< of the header
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
  const std::string_view name = take_word(rest);
  const bool is_of_vertices = of.name == "face" && (name == "vertex_indices" || name == "vertex_index");
  of.properties.push_back({count, item, is_list && is_of_vertices});
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
    ++found.lines;
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

std::string missing(std::uint64_t at, const element& of) {
  return fmt::format("has {} of {} elements '{}', expected all of them", at, of.count, shown(of.name));
}

constexpr std::uint64_t kAnyIndex = ~std::uint64_t{0};

/// What is wrong with a value that is no index, or one of a vertex.
std::string fault_of_index(std::int64_t index, std::uint64_t vertices) {
  if (vertices == kAnyIndex || (index >= 0 && static_cast<std::uint64_t>(index) < vertices)) return {};
  return fmt::format("vertex {} does not exist, expected less than {}", index, vertices);
}

/// The values of an element in a line of text.
std::string fault_of_line(std::string_view line, const element& of, std::uint64_t vertices) {
  const auto take = [&](const type& item, std::uint64_t most) -> std::string {
    const std::string_view word = take_word(line);
    if (word.empty()) return fmt::format("ends within element '{}', expected more values", shown(of.name));
    const bool is_real = item.name == "float" || item.name == "double";
    if (is_real) return read_real(word) ? "" : fmt::format("has '{}', expected a number", shown(word));
    const auto value = whole<std::int64_t>(word);
    return value ? fault_of_index(*value, most) : fmt::format("has '{}', expected an integer", shown(word));
  };
  for (const property& each : of.properties) {
    std::uint64_t count = 1;
    if (each.count != nullptr) {
      const std::string_view word = take_word(line);
      const auto length = whole<std::uint64_t>(word);
      if (!length) return fmt::format("has '{}', expected the length of a list", shown(word));
      count = *length;
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      if (std::string fault = take(*each.item, each.is_of_vertices ? vertices : kAnyIndex); !fault.empty())
        return fault;
    }
  }
  if (!line.empty())
    return fmt::format("has '{}' behind element '{}', expected nothing", shown(line), shown(of.name));
  return {};
}

std::optional<ply_fault> fault_of_text(const header& of, std::uint64_t vertices) {
  std::string_view rest = of.body;
  std::size_t number = of.lines;
  const auto next = [&] {
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      std::string_view line = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      ++number;
      const std::size_t begin = line.find_first_not_of(" \t\r");
      if (begin == std::string_view::npos) continue;
      return line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
    }
    return std::string_view();
  };
  for (const element& each : of.elements) {
    for (std::uint64_t i = 0; !each.properties.empty() && i < each.count; ++i) {
      const std::string_view line = next();
      if (line.empty()) return ply_fault{0, missing(i, each)};
      if (const std::string fault = fault_of_line(line, each, vertices); !fault.empty())
        return ply_fault{number, fault};
    }
  }
  return {};
}

/// Takes the values of a binary body one by one.
class body_reader {
 public:
  body_reader(std::string_view text, bool is_big) : text_(text), is_big_(is_big) {}

  /// An integer; of a real number its bits. None: the text ends before it.
  std::optional<std::int64_t> take(const type& of) {
    if (text_.size() < of.bytes) return std::nullopt;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < of.bytes; ++i) {
      const auto byte = static_cast<unsigned char>(text_[i]);
      value |= std::uint64_t{byte} << 8 * (is_big_ ? of.bytes - 1 - i : i);
    }
    text_.remove_prefix(of.bytes);
    const std::size_t unused = 64 - 8 * of.bytes;
    return of.is_signed ? static_cast<std::int64_t>(value << unused) >> unused
                        : static_cast<std::int64_t>(value);
  }

 private:
  std::string_view text_;
  bool is_big_;
};

std::string fault_of_element(body_reader& from, const element& of, std::uint64_t at, std::uint64_t vertices) {
  for (const property& each : of.properties) {
    std::int64_t count = 1;
    if (each.count != nullptr) {
      const auto length = from.take(*each.count);
      if (!length || *length < 0 || each.count->name == "float" || each.count->name == "double")
        return missing(at, of);
      count = *length;
    }
    for (std::int64_t i = 0; i < count; ++i) {
      const auto value = from.take(*each.item);
      if (!value) return missing(at, of);
      if (std::string fault = fault_of_index(*value, each.is_of_vertices ? vertices : kAnyIndex);
          !fault.empty())
        return fault;
    }
  }
  return {};
}

}  // namespace

std::optional<ply_fault> fault_of_ply(std::string_view text) {
  const std::optional<header> found = read_header(text);
  if (!found) return {};
  const auto strips = std::ranges::find(found->elements, "tristrips", &element::name);
  if (strips != found->elements.end() && strips->count > 0)
    return ply_fault{0, "has element 'tristrips', which is not read, expected faces"};
  const auto vertex = std::ranges::find(found->elements, "vertex", &element::name);
  const std::uint64_t vertices = vertex == found->elements.end() ? kAnyIndex : vertex->count;
  if (found->format == "ascii") return fault_of_text(*found, vertices);
  const bool is_big = found->format == "binary_big_endian";
  if (!is_big && found->format != "binary_little_endian") return {};
  body_reader body(found->body, is_big);
  for (const element& each : found->elements) {
    for (std::uint64_t i = 0; !each.properties.empty() && i < each.count; ++i) {
      if (const std::string fault = fault_of_element(body, each, i, vertices); !fault.empty())
        return ply_fault{0, fault};
    }
  }
  return {};
}

}  // namespace blysk::scene
