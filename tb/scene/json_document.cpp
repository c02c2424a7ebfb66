// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/json_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>
#include <vector>

#include "tb/line_reader.h"
#include "tb/usage_error.h"

namespace blysk::scene {
namespace {

using nlohmann::json;

/// Characters of a text; how far the parser has read is seen from outside.
class read_characters {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  /// \param reached  the place behind the last character that was read
  read_characters(const char* at, const char*& reached) : at_(at), reached_(&reached) {}

  reference operator*() const { return *at_; }
  read_characters& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  read_characters operator++(int) {
    const read_characters before = *this;
    ++*this;
    return before;
  }
  bool operator==(const read_characters& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  const char** reached_;
};

/// An object or array that is open.
struct open_value {
  std::string place;
  bool is_array;
  std::size_t elements = 0;
  std::string key;  ///< the last one
  std::set<std::string> keys;
};

/// Reads a text and notes the lines.
class parser {
 public:
  parser(const std::string& path, const std::string& text)
      : path_(path), text_(text), reached_(text.data()) {}

  json_document parse() {
    const auto watch = [this](int, json::parse_event_t event, const json& found) {
      take(event, found);
      return true;
    };
    try {
      const char* end_reached = nullptr;
      made_.root = json::parse(read_characters(text_.data(), reached_),
                               read_characters(text_.data() + text_.size(), end_reached), watch);
    } catch (const json::parse_error& error) {
      fail_at(error.byte - (error.byte > 0 ? 1 : 0));
    } catch (const json::out_of_range&) {
      throw file_error(path_, line(),
                       "has a number beyond 1.8e308, expected a scene as docs/scenes.md has it");
    }
    return std::move(made_);
  }

 private:
  void take(json::parse_event_t event, const json& found) {
    using is = json::parse_event_t;
    switch (event) {
      case is::key:
        open_.back().key = found.get<std::string>();
        if (!open_.back().keys.insert(open_.back().key).second)
          throw file_error(
              path_, line(),
              fmt::format("has '{}' twice in one object, expected it once", shown(open_.back().key)));
        note();
        break;
      case is::object_start:
      case is::array_start: {
        if (open_.empty() || is_in_array()) note();
        const std::string here = place();
        open_.push_back({here, event == is::array_start, 0, {}, {}});
        break;
      }
      case is::object_end:
      case is::array_end:
        open_.pop_back();
        if (is_in_array()) ++open_.back().elements;
        break;
      case is::value:
        if (open_.empty() || is_in_array()) note();
        if (is_in_array()) ++open_.back().elements;
        break;
    }
  }

  bool is_in_array() const { return !open_.empty() && open_.back().is_array; }

  /// Of the value that comes; nothing for the whole, and for what is too deep to be named.
  std::string place() const {
    if (open_.empty() || open_.size() > json_document::kDeepest) return {};
    const open_value& in = open_.back();
    return in.is_array ? element_place(in.place, in.elements) : member_place(in.place, in.key);
  }

  void note() {
    if (open_.size() <= json_document::kDeepest) made_.lines[place()] = line();
  }

  /// Of the last character but the one that was read to see where a number ends.
  std::size_t line() {
    const char* const last = reached_ > text_.data() ? reached_ - 1 : reached_;
    line_ += static_cast<std::size_t>(std::count(counted_, last, '\n'));
    counted_ = last;
    return line_;
  }

  [[noreturn]] void fail_at(std::size_t byte) const {
    const std::string_view before = std::string_view(text_).substr(0, byte);
    const auto line = static_cast<std::size_t>(1 + std::ranges::count(before, '\n'));
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
    const std::string_view rest = std::string_view(text_).substr(before.size());
    throw file_error(
        path_, line,
        fmt::format("is no JSON here, expected a scene as docs/scenes.md has it; column {} has {}", column,
                    rest.empty() ? "the end of the file"
                                 : fmt::format("'{}'", shown(rest.substr(0, rest.find_first_of("\r\n"))))));
  }

  const std::string& path_;
  const std::string& text_;
  const char* reached_;
  const char* counted_ = text_.data();  ///< lines before it are counted
  std::size_t line_ = 1;
  std::vector<open_value> open_;
  json_document made_;
};

}  // namespace

std::string member_place(const std::string& of, const std::string& key) {
  return of.empty() ? key : of + "." + key;
}

std::string element_place(const std::string& of, std::size_t index) {
  return fmt::format("{}[{}]", of, index);
}

json_document parse_document(const std::string& path, const std::string& text) {
  return parser(path, text).parse();
}

}  // namespace blysk::scene
