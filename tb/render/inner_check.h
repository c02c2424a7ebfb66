// SPDX-License-Identifier: Apache-2.0
/// The inner specular check of [T] (listing A, "ISC"): whole triangles that no part of a highlight can lie in.
#pragma once

#include <optional>
#include <vector>

#include "tb/render/plan.h"
#include "tb/render/visibility.h"

namespace blysk::render {

/// Directions that are no further from an axis than an angle of at most 60 degrees.
struct cone {
  vec axis;       ///< unit vector
  double cosine;  ///< of the angle, [0.5, 1]
};

/// How large N.H gets on a triangle whose normals are interpolated. inner_check.cpp has the proof.
class highlight_bound {
 public:
  /// More than all roundings, those of the renderer and those of the bound itself: at most 3e-7.
  static constexpr double kMargin = 1e-6;

  /// \param corrected  with perspective correction
  highlight_bound(const scene::mesh& surface, const projection& view, std::uint32_t triangle, bool corrected);

  /// At every pixel of the triangle N.H, as half_cosine() computes it, is at most this and kMargin more.
  /// \param light  with a direction of length 1, if it is far away
  /// \return       [-1, 1]; 1 where nothing is known
  double most_half_cosine(const scene::light& light) const;

 private:
  std::array<vec, 3> corners_;
  std::optional<cone> normals_, views_;
};

/// Of each triangle, the lights whose highlights none of its pixels lies in, as far as the bound tells. Triangles with few
/// pixels are not looked at: the bound would take longer than the tests of their pixels.
std::vector<light_set> find_dark_lights(const scene::mesh& surface, const projection& view,
                                        const visibility& seen, const std::vector<scene::light>& lights,
                                        const plan& planned, bool corrected, unsigned threads);

}  // namespace blysk::render
