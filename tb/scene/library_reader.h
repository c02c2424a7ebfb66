// SPDX-License-Identifier: Apache-2.0
/// Meshes in the formats that the library assimp reads: 3DS, glTF, PLY, Collada and others.
#pragma once

#include <string>
#include <vector>

#include "tb/scene/scene.h"

namespace blysk::scene {

struct library_mesh {
  mesh surface;
  std::vector<std::string>
      files;  ///< that the library opened: the mesh, and what it names, such as buffers of glTF
};

/// The library reads in a process of its own: what a hostile file does to it ends there, as one message.
/// \throws usage_error with the library's reason, or with what became of its process
library_mesh read_by_library(const std::string& path, std::vector<std::string>& messages);

}  // namespace blysk::scene
