// SPDX-License-Identifier: Apache-2.0
/// Experiments of [T] on pictures: NMSE of the lobes on a mesh (table 3.2), segments of rows (2.6).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tb/golden/lobe.h"
#include "tb/render/render.h"

namespace blysk::render {

/// The scene of [T] listing A, calcColor: the object's colour scaled by N.L plus white scaled by the lobe of N.H, either
/// factor cut to 8 bits, the sum saturated. H is taken once, from the light and the camera's direction.
struct listing_scene {
  std::string_view name;
  std::array<int, 3> colour;  ///< of the object, 0..255
  double share;               ///< k_d and k_s
};
inline constexpr std::array kListingScenes{listing_scene{"object (238, 138, 32)", {238, 138, 32}, 1},
                                           listing_scene{"the same with kd = ks = 0.5", {238, 138, 32}, 0.5},
                                           listing_scene{"white object", {255, 255, 255}, 1}};

/// A picture of a mesh, 512 x 512, with the light that `blysk render` has if nothing else is said.
class listing_picture {
 public:
  listing_picture(const scene::mesh& surface, const scene::camera& camera);

  std::size_t pixels() const { return pixels_.size(); }

  /// NMSE of the picture with a lobe, cut at 0, against that with Blinn's, in each of kListingScenes.   [T] (3.1)
  std::array<double, kListingScenes.size()> nmse(golden::lobe which, int n) const;

 private:
  struct pixel {
    double nl, nh;  // [0, 1]
  };
  std::vector<pixel> pixels_;  // of the mesh; those with the largest N.H first
  std::array<std::vector<double>, kListingScenes.size()>
      energy_behind_;  // without a highlight, from a pixel on
};

/// A picture by segments against the same one with every pixel traced.
struct segment_run {
  std::string scene;
  segments asked;
  segment_counts counts;
  double nmse;
  int largest;  ///< difference of a channel
};
/// Sphere and teapot, 512 x 512, by K, measure and interpolation.
std::vector<segment_run> run_segments(const device_source& from);

}  // namespace blysk::render
