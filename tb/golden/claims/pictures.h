// SPDX-License-Identifier: Apache-2.0
/// NMSE of every lobe on the sphere, against the same picture with Blinn's lobe.
#pragma once

#include <array>
#include <string_view>

#include "tb/golden/claims/sweep.h"
#include "tb/golden/sphere.h"

namespace blysk::golden {

/// [T] does not state the shares of its scene, and NMSE falls with the share of what both pictures have
/// alike.
struct picture_scene {
  std::string_view name;
  illumination<double> light;
};

inline constexpr std::array kPictureScenes{
    picture_scene{"highlight alone", {1, 1, 0, 0, 1}},
    picture_scene{"ka 0.1 kd 0.3 ks 0.6", {1, 1, 0.1, 0.3, 0.6}},
    picture_scene{"ka 0.1 kd 0.6 ks 0.3", {1, 1, 0.1, 0.6, 0.3}},
};

/// Exponents at which pictures are compared.
inline constexpr std::array kPictureExponents{1, 2, 3, 5, 10, 20, 50, 100, 169, 170, 200, 500, 1000};

double sphere_nmse(lobe which, const picture_scene& scene, int n);

/// Largest over the picture exponents in [first, last].
worst worst_nmse(lobe which, const picture_scene& scene, int first, int last);

}  // namespace blysk::golden
