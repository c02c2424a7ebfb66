// SPDX-License-Identifier: Apache-2.0
/// Which effects a scene calls for, and why. Leaving an effect out never changes the picture: what is left out would have
/// added 0.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tb/render/device_ports.h"
#include "tb/render/effects/energy.h"
#include "tb/render/effects/fixed.h"
#include "tb/scene/scene.h"

namespace blysk::render {

enum class effects {
  automatic,  ///< what the scene calls for
  all         ///< every effect for every point and light
};

/// What one light does on one material.
struct light_plan {
  coefficient_rgb diffuse{};               ///< I_l k_d, UQ8.8
  std::array<std::uint8_t, 3> specular{};  ///< I_l k_s, 0..255: the colour ports
  int n = 1;
  std::int64_t lobe_begin = 0;  ///< smallest code of cos that adds anything
  /// A cosine whose code is below the lobe: one code below its begin, where half a code of the rounding and the last bits
  /// of the vectors cannot lift it. 0 where the lobe begins at 0 or 1.
  double below_lobe = 0;
  energy_share energy = {};   ///< multiplies the specular term
  bool has_diffuse = false;   ///< the effect is computed
  bool has_specular = false;  ///< the device is written
  bool is_grey = false;       ///< one colour multiplier serves three channels
};

/// Lights by their bits.
using light_set = std::uint64_t;

struct plan {
  effects asked = effects::automatic;
  std::size_t lights = 0;
  bool checks_triangles = false;         ///< by the inner specular check
  std::vector<coefficient_rgb> ambient;  ///< of each material, UQ8.8
  std::vector<bool>
      grey_materials;  ///< all terms of them are grey: one channel of the effect units serves three
  std::vector<light_plan> of_lights;  ///< material by material, a light after the other
  std::vector<std::string> units;     ///< that are built
  std::vector<std::string> reasons;   ///< a line for each unit, and for each that is left out

  const light_plan& at(std::uint32_t material, std::size_t light) const {
    return of_lights[material * lights + light];
  }
  bool has_specular() const;

  /// The lights whose highlights on a material are computed, for each material.
  std::vector<light_set> specular_lights() const;
};

/// Exponents of the materials that a device makes highlights of.
std::set<int> written_exponents(const scene::world& of, effects asked);

/// Whether a device is needed at all: before one is made.
bool needs_device(const scene::world& of, effects asked);

/// \param table   null: every code of cos may add something
/// \param device  what it is called among the units
/// \param by      what the specular terms are multiplied by
plan make_plan(const scene::world& of, effects asked, lobe_table* table, int cos_fraction,
               const std::string& device, normalisation by);

}  // namespace blysk::render
