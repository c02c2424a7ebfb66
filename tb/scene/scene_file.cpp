// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tb/line_reader.h"
#include "tb/scene/json_document.h"
#include "tb/scene/read_scene.h"
#include "tb/scene/shapes.h"
#include "tb/usage_error.h"

namespace blysk::scene {
namespace {

using nlohmann::json;

/// A value of a scene file, and where it stands: "lights[0].colour".
class field {
 public:
  field(const std::string& path, const json_document& in) : path_(path), lines_(in.lines), value_(in.root) {}

  /// 0 for what is too deep to be named.
  std::size_t line() const { return line_of(where_); }

  [[noreturn]] void fail(const std::string& what) const { fail_at(where_, what); }

  /// What is wrong is a member, whose line is named.
  [[noreturn]] void fail_at_member(const std::string& key, const std::string& what) const {
    fail_at(member_place(where_, key), what);
  }

  /// The members, each of which has to be one of those named.
  std::vector<std::pair<std::string, field>> members(const std::vector<std::string>& known) const {
    if (!value_.is_object()) fail(fmt::format("is {}, expected an object", value_.type_name()));
    std::vector<std::pair<std::string, field>> all;
    for (const auto& [key, value] : value_.items()) {
      if (std::ranges::find(known, key) == known.end())
        fail_at_member(key, fmt::format("has '{}', expected {}", shown(key), fmt::join(known, ", ")));
      all.emplace_back(key, field(*this, value, member_place(where_, key)));
    }
    return all;
  }

  std::vector<field> elements() const {
    if (!value_.is_array()) fail(fmt::format("is {}, expected an array", value_.type_name()));
    std::vector<field> all;
    for (std::size_t i = 0; i < value_.size(); ++i)
      all.push_back(field(*this, value_[i], element_place(where_, i)));
    return all;
  }

  double number(double least, double most) const {
    if (!value_.is_number() || !(value_.get<double>() >= least && value_.get<double>() <= most))
      fail(fmt::format("is {}, expected a number in [{}, {}]", shown_value(), least, most));
    return value_.get<double>();
  }
  int integer(int least, int most) const {
    const double value = number(least, most);
    if (value != std::floor(value)) fail(fmt::format("is {}, expected an integer", shown_value()));
    return static_cast<int>(value);
  }
  std::string text() const {
    if (!value_.is_string()) fail(fmt::format("is {}, expected a string", value_.type_name()));
    std::string text = value_.get<std::string>();
    // The system would take what stands before it for the whole name.
    if (text.find('\0') != std::string::npos) fail("holds a zero byte, expected text");
    return text;
  }

  std::array<double, 3> triple(double least, double most) const {
    const std::vector<field> all = elements();
    if (all.size() != 3) fail(fmt::format("has {} elements, expected three", all.size()));
    return {all[0].number(least, most), all[1].number(least, most), all[2].number(least, most)};
  }
  rgb colour() const { return triple(0, 1); }
  vec place() const {
    const auto at = triple(-mesh::kLargest, mesh::kLargest);
    return {at[0], at[1], at[2]};
  }
  vec direction() const {
    const vec at = place();
    const vec unit = golden::normalised(at);  // the square of at may vanish where its direction does not
    if (golden::dot(unit, unit) == 0) fail("is zero, expected a direction");
    return at;
  }

 private:
  field(const field& in, const json& value, std::string where)
      : path_(in.path_), lines_(in.lines_), value_(value), where_(std::move(where)) {}

  std::size_t line_of(const std::string& place) const {
    const auto line = lines_.find(place);
    return line == lines_.end() ? 0 : line->second;
  }
  [[noreturn]] void fail_at(const std::string& place, const std::string& what) const {
    throw file_error(path_, line_of(place),
                     fmt::format("{}: {}", where_.empty() ? "the file" : where_, what));
  }

  /// Not what an array or object holds: it may be deeper than the stack.
  std::string shown_value() const {
    return value_.is_structured() ? fmt::format("an {}", value_.type_name()) : shown(value_.dump());
  }

  const std::string& path_;
  const std::map<std::string, std::size_t>& lines_;
  const json& value_;
  std::string where_;
};

light read_light(const field& from) {
  light made;
  bool has_place = false;
  for (const auto& [key, value] : from.members({"direction", "position", "colour"})) {
    if (key == "colour") {
      made.colour = value.colour();
      continue;
    }
    if (has_place) from.fail("has direction and position, expected one of them");
    has_place = true;
    made.is_point = key == "position";
    made.at = made.is_point ? value.place() : value.direction();
  }
  if (!has_place) from.fail("has neither direction nor position, expected one of them");
  return made;
}

void read_camera(const field& from, camera& view) {
  for (const auto& [key, value] : from.members({"eye", "target", "up", "fov"})) {
    if (key == "fov") {
      view.fov_deg = value.number(0.001, 179);
    } else if (key == "up") {
      view.up = value.direction();
    } else {
      (key == "eye" ? view.eye : view.target) = value.place();
    }
  }
}

void read_material(const field& from, material& to) {
  for (const auto& [key, value] : from.members({"ka", "kd", "ks", "n", "emitted"})) {
    if (key == "n") {
      to.n = value.integer(1, 1000);
    } else {
      rgb& share = key == "ka" ? to.ka : key == "kd" ? to.kd : key == "ks" ? to.ks : to.emitted;
      share = value.colour();
    }
  }
}

/// Materials of the mesh by name; "*" is all of them, before what is said of one.
void read_materials(const field& from, const std::vector<std::pair<std::string, field>>& all,
                    std::vector<material>& materials) {
  for (const auto& [name, value] : all) {
    if (name != "*") continue;
    for (material& each : materials) read_material(value, each);
  }
  for (const auto& [name, value] : all) {
    if (name == "*") continue;
    bool found = false;
    for (material& each : materials) {
      if (each.name != name) continue;
      read_material(value, each);
      found = true;
    }
    if (!found) {
      std::vector<std::string> names;
      std::ranges::transform(materials, std::back_inserter(names), &material::name);
      from.fail_at_member(name, fmt::format("has '{}', which the mesh has not, expected *, {}", shown(name),
                                            fmt::join(names, ", ")));
    }
  }
}

std::string text_of_size(const field& from) {
  const std::vector<field> all = from.elements();
  if (all.size() != 2) from.fail(fmt::format("has {} elements, expected width and height", all.size()));
  constexpr int kMost = 1 << 14;
  return fmt::format("{}x{}", all[0].integer(1, kMost), all[1].integer(1, kMost));
}

}  // namespace

namespace {

/// What keeps the camera from seeing anything; nothing if it sees.
std::string blindness_of(const camera& view) {
  const vec forward = golden::normalised(view.target - view.eye);
  const vec right = cross(forward, golden::normalised(view.up));
  if (golden::dot(forward, forward) == 0) return "eye and target are one place, expected two";
  if (golden::dot(right, right) < 1e-24)
    return "up points where the camera looks, expected another direction";
  return {};
}

}  // namespace

void check_camera(const std::string& where, const camera& view) {
  if (const std::string why = blindness_of(view); !why.empty()) throw usage_error(where + ": " + why);
}

read_world read_scene_file(const std::string& path, const std::string& text, int density) {
  const json_document read_text = parse_document(path, text);
  const field all(path, read_text);
  const auto members =
      all.members({"mesh", "density", "materials", "lights", "ambient", "background", "camera", "size",
                   "shading", "perspective", "device", "format", "engine", "normalisation"});
  const auto find = [&](const char* key) {
    const auto found = std::ranges::find(members, key, [](const auto& of) { return of.first; });
    return found == members.end() ? nullptr : &found->second;
  };
  const field* const mesh_name = find("mesh");
  if (mesh_name == nullptr) all.fail("has no mesh, expected its name");
  std::string name = mesh_name->text();
  if (name.empty()) mesh_name->fail("is empty, expected the name of a mesh");
  if (find_shape(name) == nullptr) {
    name = (std::filesystem::path(path).parent_path() / name).string();
    if (ending_of(name) == ".json") mesh_name->fail("is a scene, expected a mesh");
    std::error_code unknown;
    const bool is_there = std::filesystem::exists(name, unknown);
    if (!unknown && (!is_there || std::filesystem::is_directory(name, unknown)))
      mesh_name->fail("is no file, expected one beside the scene or a built-in shape");
    if (find("density") != nullptr)
      find("density")->fail("is of a built-in shape, expected none beside a mesh from a file");
  }
  if (find("density") != nullptr) {
    const int said = find("density")->integer(kLeastDensity, kMostDensity);
    if (density == 0) density = said;
  }
  read_world read = read_scene(name, density);
  world& made = read.of;
  for (std::string& each : made.messages)
    each = fmt::format("{}: {}", printable(std::filesystem::path(name).filename().string()), each);
  for (const auto& [key, value] : members) {
    if (key == "materials") {
      std::vector<std::string> names{"*"};
      std::ranges::transform(made.surface.materials, std::back_inserter(names), &material::name);
      read_materials(value, value.members(names), made.surface.materials);
    } else if (key == "lights") {
      made.lights.clear();
      for (const field& each : value.elements()) made.lights.push_back(read_light(each));
      if (made.lights.size() > kMostLights)
        value.fail(fmt::format("has {} lights, expected at most {}", made.lights.size(), kMostLights));
    } else if (key == "ambient" || key == "background") {
      (key == "ambient" ? made.ambient : made.background) = value.colour();
    } else if (key == "camera") {
      made.view = fitted_camera(made.surface);
      read_camera(value, *made.view);
      if (const std::string why = blindness_of(*made.view); !why.empty()) value.fail(why);
    } else if (key == "size") {
      read.options[key] = {text_of_size(value), value.line()};
    } else if (key == "shading" || key == "perspective" || key == "device" || key == "format" ||
               key == "engine" || key == "normalisation") {
      read.options[key] = {value.text(), value.line()};
    }
  }
  return read;
}

}  // namespace blysk::scene
