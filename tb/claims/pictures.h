// SPDX-License-Identifier: Apache-2.0
/// NMSE of every lobe on the sphere, against the same picture with Blinn's lobe.
#pragma once

#include <array>
#include <string_view>

#include "tb/claims/sweep.h"
#include "tb/golden/sphere.h"

namespace blysk::golden {

/// [T] states the shares of table 3.2 nowhere; fig. 3.9 shows one setting of its program. NMSE falls with the
/// share of what both pictures have alike. It does not depend on the light's colour: a channel's intensity is a
/// common factor of (3.1)'s sums.
struct picture_scene {
  std::string_view name;
  illumination<double> light;
};

inline constexpr std::array kPictureScenes{
    picture_scene{"highlight alone", {1, 1, 0, 0, 1}},
    picture_scene{"fig. 3.9: Ia 0 kd 0.5 ks 0.5", {0, 1, 1, 0.5, 0.5}},
    picture_scene{"ka 0.1 kd 0.3 ks 0.6", {1, 1, 0.1, 0.3, 0.6}},
    picture_scene{"ka 0.1 kd 0.6 ks 0.3", {1, 1, 0.1, 0.6, 0.3}},
};

/// NMSE of the lobe's picture of the sphere against that of Blinn's.
/// \param which  name of one of kApproximations, or table_form::kName: best_table_form where c^n >= 0.6
/// \param n      specular exponent, 1..1000
double sphere_nmse(std::string_view which, const picture_scene& scene, int n);

}  // namespace blysk::golden
