// SPDX-License-Identifier: Apache-2.0
/// The six faults of Gouraud's shading that [T] 1.3 lists, each on a scene made for it.
#pragma once

#include <string>
#include <vector>

#include "tb/render/render.h"

namespace blysk::render {

struct gouraud_fault {
  std::string name;      ///< of its picture
  std::string what;      ///< the fault
  std::string measured;  ///< what is measured
  double gouraud = 0;    ///< with Gouraud's shading
  double other = 0;      ///< with the shading beside it
  picture sheet;         ///< Gouraud's picture and the other one
};

/// a) to e) and the sixth, in the order of [T].
/// \param from  of the highlights
std::vector<gouraud_fault> find_gouraud_faults(const device_source& from);

/// Normals of the corners between two planes of `fault c`: half the sum of theirs, of length 1.
scene::mesh make_zigzag();

/// How far the outline of what is bright in a picture is from a circle: the largest distance from the centre of gravity to
/// a bright pixel over the smallest one to a dark pixel; red of bright pixels is at least half of the largest red. 1 for a
/// large disc.
double roundness(const picture& of);

}  // namespace blysk::render
