// SPDX-License-Identifier: Apache-2.0
/// Wavefront OBJ and MTL. Every number and index is checked; an error names its line.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tb/scene/material.h"
#include "tb/scene/scene.h"

namespace blysk::scene {

/// A material library, as it lies in the file.
struct library_text {
  std::string path, bytes;
};

/// Opens a file beside the one that names it; throws usage_error if it cannot be read.
using open_library = std::function<library_text(const std::string& name)>;

/// Materials of an MTL file by name, in its order.
/// \param text  as decoded() gives it
/// \throws usage_error for NaN and for what is no number
std::vector<raw_material> read_mtl(const std::string& path, const std::string& text);

/// \param path      for messages
/// \param text      as decoded() gives it
/// \param open      gives the bytes of a material library
/// \param messages  gets what was changed or dropped
/// \throws usage_error for a file that cannot be right, with its line
mesh read_obj(const std::string& path, const std::string& text, const open_library& open,
              std::vector<std::string>& messages);

}  // namespace blysk::scene
