// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/read_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tb/line_reader.h"
#include "tb/scene/library_reader.h"
#include "tb/scene/obj_reader.h"
#include "tb/scene/shapes.h"
#include "tb/scene/text_lines.h"
#include "tb/usage_error.h"

namespace blysk::scene {

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

read_world read_scene(const std::string& name, int density) {
  read_world read;
  if (const shape* built_in = find_shape(name)) {
    read.of.surface = built_in->make(density > 0 ? density : built_in->density);
    return read;
  }
  const std::filesystem::path path(name);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    if (error)
      throw file_error(shown(name), 0,
                       fmt::format("cannot be read ({}), expected a shape or a file", error.message()));
    std::string names;
    for (const shape& each : shapes()) names += fmt::format("{}, ", each.name);
    throw file_error(name, 0, fmt::format("does not exist, expected {}or a file", names));
  }
  if (std::filesystem::is_directory(path, error))
    throw file_error(name, 0, "is a directory, expected a file");
  const std::string ending = ending_of(name);
  if (ending == ".json") {
    read = read_scene_file(name, decoded(name, read_file(name)), density);
    read.files.push_back(name);
    return read;
  }
  if (density > 0)
    throw file_error(name, 0, "is a mesh from a file, expected --density with a built-in shape only");
  if (ending == ".obj") {
    const auto open = [&](const std::string& library) {
      std::string unix_name = library;
      std::ranges::replace(unix_name, '\\', '/');
      const std::string beside = (path.parent_path() / unix_name).string();
      std::error_code unknown;
      if (std::filesystem::exists(beside, unknown) && !std::filesystem::is_regular_file(beside, unknown))
        throw file_error(beside, 0, "is no regular file, expected a library of materials");
      library_text opened{beside, read_file(beside)};
      read.files.push_back(beside);
      return opened;
    };
    read.of.surface = read_obj(name, decoded(name, read_file(name)), open, read.of.messages);
  } else {
    library_mesh made = read_by_library(name, read.of.messages);
    read.of.surface = std::move(made.surface);
    read.files = std::move(made.files);
  }
  read.files.push_back(name);
  const camera view = fitted_camera(read.of.surface);
  const vec distance = view.eye - view.target;
  if (std::max({std::abs(distance.x), std::abs(distance.y), std::abs(distance.z)}) < mesh::kSmallest)
    throw file_error(name, 0,
                     fmt::format("is too small, expected an extent of at least {}", mesh::kSmallest));
  return read;
}

}  // namespace blysk::scene
