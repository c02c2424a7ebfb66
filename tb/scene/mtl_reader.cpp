// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "tb/line_reader.h"
#include "tb/scene/obj_reader.h"
#include "tb/scene/text_lines.h"
#include "tb/usage_error.h"

namespace blysk::scene {
namespace {

/// A reader of one line of a material.
class mtl_line {
 public:
  mtl_line(const std::string& path, const text_lines& line)
      : path_(path), keyword_(line.keyword()), rest_(line.value()), number_(line.number()) {}

  /// What stands behind the numbers that were read.
  std::string_view rest() const { return rest_; }

  /// Passes over a word that may stand before the numbers.
  void skip(std::string_view word) {
    std::string_view behind = rest_;
    if (take_word(behind) == word) rest_ = behind;
  }

  double number() {
    const std::string_view word = take_word(rest_);
    const auto value = number_of(word);
    if (!value) {
      throw file_error(path_, number_,
                       fmt::format("{} is '{}', expected a number", shown(keyword_), shown(word)));
    }
    return *value;
  }

  /// Three numbers, or one for all. The colours of measured spectra and of CIE XYZ are dropped.
  std::optional<rgb> colour(std::vector<std::string>& notes) {
    if (rest_.starts_with("spectral") || rest_.starts_with("xyz")) {
      notes.push_back(fmt::format("{} {} dropped, RGB is read", keyword_, take_word(rest_)));
      rest_ = {};
      return {};
    }
    rgb values{};
    values.fill(number());
    if (!rest_.empty()) {
      values[1] = number();
      values[2] = number();
    }
    return values;
  }

 private:
  const std::string& path_;
  std::string_view keyword_, rest_;
  std::size_t number_;
};

/// A line that a renderer of all effects would not see either: Ni 1 refracts nothing, Tf 1 filters nothing.
bool is_neutral(std::string_view keyword, std::string_view value) {
  if (keyword != "Ni" && keyword != "Tf") return false;
  bool is_one = !value.empty();
  while (!value.empty()) is_one = number_of(take_word(value)) == 1.0 && is_one;
  return is_one;
}

/// Gives a property its value, and notes what is not taken.
template <class Value>
void take_value(mtl_line& of, std::string_view keyword, const Value& value, Value& to,
                std::vector<std::string>& notes) {
  if (!value) return;  // dropped, and said
  if (to) notes.push_back(fmt::format("{} given again, the last one taken", keyword));
  if (!of.rest().empty()) notes.push_back(fmt::format("'{}' behind {} dropped", shown(of.rest()), keyword));
  to = value;
}

void read_property(const std::string& path, const text_lines& line, raw_material& to) {
  mtl_line of(path, line);
  const std::string_view keyword = line.keyword();
  if (keyword == "Ka" || keyword == "Kd" || keyword == "Ks" || keyword == "Ke") {
    std::optional<rgb>& share = keyword == "Ka"   ? to.ka
                                : keyword == "Kd" ? to.kd
                                : keyword == "Ks" ? to.ks
                                                  : to.ke;
    take_value(of, keyword, of.colour(to.notes), share, to.notes);
  } else if (keyword == "Ns" || keyword == "illum") {
    take_value(of, keyword, std::optional(of.number()), keyword == "Ns" ? to.n : to.illum, to.notes);
  } else if (keyword == "d" || keyword == "Tr") {
    of.skip("-halo");
    const double opacity = of.number();
    if (!of.rest().empty() || opacity != (keyword == "d" ? 1.0 : 0.0))
      to.notes.push_back(fmt::format("{} {} dropped, surfaces are opaque", keyword, shown(line.value())));
  } else if (!is_neutral(keyword, line.value())) {
    to.notes.push_back(fmt::format("{} dropped", printable(keyword)));
  }
}

}  // namespace

std::vector<raw_material> read_mtl(const std::string& path, const std::string& text) {
  std::vector<raw_material> materials;
  text_lines line(text);
  while (line.next()) {
    if (line.keyword() == "newmtl") {
      materials.emplace_back().name = line.value();
    } else if (materials.empty()) {
      throw file_error(
          path, line.number(),
          fmt::format("'{}' before the first newmtl, expected newmtl", printable(line.keyword())));
    } else {
      read_property(path, line, materials.back());
    }
  }
  return materials;
}

}  // namespace blysk::scene
