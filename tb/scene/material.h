// SPDX-License-Identifier: Apache-2.0
/// Materials as files give them, and what a device takes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tb/scene/scene.h"

namespace blysk::scene {

/// Numbers as they were written: any sign and size, infinite ones too, but no NaN.
struct raw_material {
  std::string name;
  std::optional<rgb> ka, kd, ks, ke;
  std::optional<double> n;
  std::optional<double> illum;     ///< 0 constant colour, 1 ambient and diffuse, 2 with specular
  std::vector<std::string> notes;  ///< what the reader dropped
};

/// The material with legal numbers: shares cut to [0, 1], the exponent rounded and cut to 1..1000.
/// \param messages  gets one line if anything was changed or dropped
material make_legal(const raw_material& raw, std::vector<std::string>& messages);

/// What surfaces without a material are made of.
material plain_material();

}  // namespace blysk::scene
