// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/obj_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include "tb/line_reader.h"
#include "tb/scene/mesh_builder.h"
#include "tb/scene/text_lines.h"
#include "tb/usage_error.h"

namespace blysk::scene {
namespace {

class obj_reader {
 public:
  obj_reader(const std::string& path, const open_library& open, std::vector<std::string>& messages)
      : path_(path), open_(open), messages_(messages) {}

  mesh read(const std::string& text) {
    text_lines line(text);
    while (line.next()) {
      number_ = line.number();
      read_line(line.keyword(), line.value());
    }
    check_last("vertex", highest_vertex_, built_.positions.size());
    check_last("normal", highest_normal_, built_.normals.size());
    check_last("texture coordinate", highest_texture_, textures_);
    add_faces();
    if (built_.triangles() == 0) throw file_error(path_, 0, "has no triangle with an area, expected one");
    report_dropped();
    return std::move(built_).finish(messages_);
  }

 private:
  /// An index that was used, and where: files may name vertices that follow.
  struct used {
    std::uint32_t index = 0;
    std::size_t line = 0;
  };
  struct face {
    std::size_t first, size;  // of corners_
    std::uint32_t material;
    std::int32_t smoothing;
  };

  [[noreturn]] void fail(const std::string& what) const { throw file_error(path_, number_, what); }

  void read_line(std::string_view keyword, std::string_view value) {
    if (keyword == "v") {
      built_.positions.push_back(read_vector("vertex", value));
      if (!value.empty()) ++dropped_["numbers behind a vertex's three (weights, colours)"];
    } else if (keyword == "vn") {
      built_.normals.push_back(read_vector("normal", value));
      if (!value.empty()) ++dropped_["numbers behind a normal's three"];
    } else if (keyword == "f") {
      read_face(value);
    } else if (keyword == "usemtl") {
      use_material(value);
    } else if (keyword == "mtllib") {
      read_libraries(value);
    } else if (keyword == "s") {
      smoothing_ = read_group(value);
    } else if (keyword == "vt") {
      do {
        const std::string_view word = take_word(value);
        if (!number_of(word))
          fail(fmt::format("texture coordinate has '{}', expected a number", shown(word)));
      } while (!value.empty());
      ++textures_;
    } else if (keyword != "g" && keyword != "o") {
      ++dropped_[fmt::format("lines '{}'", printable(keyword.substr(0, 20)))];
    }
  }

  vec read_vector(const char* what, std::string_view& rest) const {
    std::array<double, 3> at{};
    for (double& each : at) {
      const std::string_view word = take_word(rest);
      const auto value = number_of(word);
      if (!value) fail(fmt::format("{} has '{}', expected three numbers", what, shown(word)));
      if (std::abs(*value) > mesh::kLargest)
        fail(fmt::format("{} has {}, expected at most {}", what, shown(word), mesh::kLargest));
      each = *value;
    }
    return {at[0], at[1], at[2]};
  }

  /// "off", "on" for the first group, or a number; in any case.
  std::int32_t read_group(std::string_view value) const {
    std::string word(value);
    std::ranges::transform(word, word.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (word == "off") return mesh_builder::kFlat;
    if (word == "on") return 1;
    std::int32_t group = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), group);
    if (error != std::errc{} || end != value.data() + value.size() || group < 0) {
      fail(fmt::format("smoothing group is '{}', expected off or a number{}", shown(value),
                       error == std::errc::result_out_of_range
                           ? fmt::format(" of at most {}", std::numeric_limits<std::int32_t>::max())
                           : ""));
    }
    return group;
  }

  /// "12", "12/3", "12//4", "12/3/4": the second, of a texture, is only checked; from 1, or from the end if negative.
  mesh_builder::corner read_corner(std::string_view word) {
    const auto slash = word.find('/');
    const auto second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
    if (word.ends_with('/'))
      fail(fmt::format("corner '{}' ends in a slash, expected an index behind it", shown(word)));
    mesh_builder::corner corner{};
    corner.position = read_index("vertex", word.substr(0, slash), built_.positions.size(), highest_vertex_);
    if (slash != std::string_view::npos) {
      const std::string_view texture = word.substr(slash + 1, second - slash - 1);
      if (!texture.empty()) read_index("texture coordinate", texture, textures_, highest_texture_);
    }
    if (second != std::string_view::npos)
      corner.normal = read_index("normal", word.substr(second + 1), built_.normals.size(), highest_normal_);
    return corner;
  }

  std::uint32_t read_index(const char* what, std::string_view word, std::size_t count, used& highest) const {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    const bool is_number = error == std::errc{} && end == word.data() + word.size();
    if (!is_number || index == 0 || index > std::numeric_limits<std::int32_t>::max() ||
        index < -static_cast<std::int64_t>(count)) {
      fail(fmt::format("{} '{}' does not exist, expected 1 to {}", what, shown(word), count));
    }
    const auto at =
        static_cast<std::uint32_t>(index > 0 ? index - 1 : index + static_cast<std::int64_t>(count));
    if (at + 1 > highest.index) highest = {at + 1, number_};
    return at;
  }

  void check_last(const char* what, const used& highest, std::size_t count) {
    number_ = highest.line;
    if (highest.index > count)
      fail(fmt::format("{} '{}' does not exist, expected 1 to {}", what, highest.index, count));
  }

  void read_face(std::string_view value) {
    const std::size_t first = corners_.size();
    while (!value.empty()) corners_.push_back(read_corner(take_word(value)));
    const std::size_t size = corners_.size() - first;
    if (size < 3) fail(fmt::format("face has {} corners, expected three or more", size));
    faces_.push_back({first, size, material_, smoothing_});
  }

  void use_material(std::string_view name) { material_ = index_of(std::string(name)); }

  /// Of a material by name; what a library says of it is found out at the end.
  std::uint32_t index_of(const std::string& name) {
    const auto [at, is_new] = names_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (is_new) uses_.push_back(name);
    return at->second;
  }

  /// Names may hold blanks: the whole line is one file if there is one, else each word is.
  void read_libraries(std::string_view value) {
    if (value.size() > 2 && value.starts_with('"') && value.ends_with('"'))
      value = value.substr(1, value.size() - 2);
    std::vector<std::string> names{std::string(value)};
    if (value.find_first_of(" \t") != std::string_view::npos) {
      try {
        read_library(names.front());
        return;
      } catch (const missing_library&) {
        names.clear();
        while (!value.empty()) names.emplace_back(take_word(value));
      }
    }
    for (const std::string& name : names) {
      try {
        read_library(name);
      } catch (const missing_library& missing) {
        messages_.push_back(fmt::format("{}, its materials are plain", missing.what()));
      }
    }
  }

  struct missing_library : std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  void read_library(const std::string& name) {
    library_text library;
    try {
      library = open_(name);
    } catch (const usage_error& error) {
      throw missing_library(error.what());
    }
    for (raw_material& each : read_mtl(library.path, decoded(library.path, std::move(library.bytes)))) {
      const std::string key = each.name;
      if (known_.contains(key)) each.notes.push_back("defined again, the last one taken");
      known_.insert_or_assign(key, std::move(each));
    }
  }

  /// When all vertices are known.
  void add_faces() {
    for (const std::string& name : uses_) {
      const auto found = known_.find(name);
      if (found != known_.end()) {
        built_.materials.push_back(make_legal(found->second, messages_));
      } else {
        built_.materials.push_back(plain_material());
        if (!name.empty())
          messages_.push_back(fmt::format("material '{}' is in no library, a plain one taken", shown(name)));
        else
          note_plain(std::ranges::count(faces_, names_.at(name), &face::material));
      }
    }
    const std::span<const mesh_builder::corner> all(corners_);
    for (const face& each : faces_)
      built_.add(all.subspan(each.first, each.size), each.material, each.smoothing);
    faces_ = {};
    corners_ = {};
  }

  void note_plain(std::ptrdiff_t faces) {
    if (faces > 0) messages_.push_back(fmt::format("{} faces without usemtl, a plain material taken", faces));
  }

  void report_dropped() {
    constexpr std::size_t kMostKinds = 20;
    std::size_t kinds = 0;
    for (const auto& [what, count] : dropped_) {
      if (++kinds > kMostKinds) break;
      messages_.push_back(fmt::format("{} {} dropped", count, what));
    }
    if (dropped_.size() > kMostKinds)
      messages_.push_back(fmt::format("lines of {} more kinds dropped", dropped_.size() - kMostKinds));
  }

  const std::string& path_;
  const open_library& open_;
  std::vector<std::string>& messages_;
  mesh_builder built_;
  std::vector<mesh_builder::corner> corners_;
  std::vector<face> faces_;
  used highest_vertex_, highest_normal_, highest_texture_;
  std::size_t textures_ = 0;  // coordinates
  std::map<std::string, raw_material> known_;
  std::map<std::string, std::uint32_t> names_;
  std::vector<std::string> uses_;
  std::map<std::string, std::size_t> dropped_;
  std::uint32_t material_ = index_of("");
  std::int32_t smoothing_ = mesh_builder::kUnsaid;
  std::size_t number_ = 0;
};

}  // namespace

mesh read_obj(const std::string& path, const std::string& text, const open_library& open,
              std::vector<std::string>& messages) {
  return obj_reader(path, open, messages).read(text);
}

}  // namespace blysk::scene
