// SPDX-License-Identifier: Apache-2.0
/// Newell's teapot as a mesh under one distant light, without a renderer: the cosines that its picture asks of a device.
///
/// Each patch is density x density quadrangles of two triangles; normals are those of the patches at the corners,
/// interpolated. The camera has a field of 30 degrees, looks along -(0, 0.3, 1) at the middle of the box around the mesh, y
/// upward, and the sphere around that middle that holds the mesh fills nine tenths of the picture: what `blysk render
/// teapot` shows.
#pragma once

#include <vector>

#include "tb/golden/scene.h"

namespace blysk::golden {

struct teapot_scene {
  int side = 512;  ///< pixels
  int density = 16;
  vec3<double> light = normalised(vec3<double>{0.4, 0.5, 0.75});
};

/// A pixel whose ray, through its centre, meets the mesh.
struct teapot_pixel {
  int x, y;
  vec3<double> normal;  ///< unit vector, on the side that is seen
  vec3<double> view;    ///< unit vector towards the eye
};

/// The pixels that the mesh covers, row by row from the top.
std::vector<teapot_pixel> teapot_pixels(const teapot_scene& scene);

}  // namespace blysk::golden
