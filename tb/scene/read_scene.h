// SPDX-License-Identifier: Apache-2.0
/// A scene by its name: a built-in shape, a mesh file, or a scene file in JSON that names one of these.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "tb/scene/scene.h"

namespace blysk::scene {

/// An option of the command line that a scene file gives.
struct given_option {
  std::string text;
  std::size_t line;  ///< of the file
};

struct read_world {
  world of;
  std::vector<std::string> files;  ///< that were read: scene, mesh, and what they name
  /// By name: "size" "512x512", "shading" "phong".
  std::map<std::string, given_option> options;
};

/// \param density  of built-in shapes; 0: their own
/// \throws usage_error with file and line
read_world read_scene(const std::string& name, int density = 0);

/// docs/scenes.md has the schema.
/// \param text  of the file
read_world read_scene_file(const std::string& path, const std::string& text, int density = 0);

/// ".obj" of "a/Ball.OBJ": what follows the last point, in small letters.
std::string ending_of(const std::string& path);

/// \throws usage_error for a camera that sees nothing: no direction, no angle
void check_camera(const std::string& where, const camera& view);

}  // namespace blysk::scene
