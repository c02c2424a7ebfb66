// SPDX-License-Identifier: Apache-2.0
/// NMSE of every lobe on the sphere, against the same picture with Blinn's lobe.
#pragma once

#include <array>
#include <string_view>

#include "tb/claims/sweep.h"

namespace blysk::claims {

/// The scene of [T] listing A, calcColor (lines 528 to 539): the object's colour scaled by N.L plus white scaled by the
/// lobe of N.H, either factor cut to 8 bits, the sum saturated; every pixel of the object, lit or not. The listing has
/// no k_d and k_s, fig. 3.9 has both at 0.5; the object's colour is given nowhere: fig. 3.9 shows I_e = (238, 138, 32),
/// and the library that it is written for draws white.
struct picture_scene {
  std::string_view key;
  std::string_view name;
  std::array<int, 3> colour;  ///< of the object, 0..255
  double kd, ks;
};

inline constexpr std::array kPictureScenes{
    picture_scene{"orange", "object (238, 138, 32)", {238, 138, 32}, 1, 1},
    picture_scene{"half", "object (238, 138, 32), kd = ks = 0.5", {238, 138, 32}, 0.5, 0.5},
    picture_scene{"white", "white object", {255, 255, 255}, 1, 1},
};

/// NMSE of the lobe's picture of the sphere (tb/golden/sphere.h) against that of Blinn's.
/// \param which  name of one of kApproximations, or table_form::kName: best_table_form where c^n >= 0.6
/// \param scene  place in kPictureScenes
/// \param n      specular exponent, 1..1000
double sphere_nmse(std::string_view which, std::size_t scene, int n);

/// The names that sphere_nmse knows.
const std::vector<std::string_view>& pictured_lobes();

}  // namespace blysk::claims
