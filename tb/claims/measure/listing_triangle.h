// SPDX-License-Identifier: Apache-2.0
/// The triangle on which the slips of [T] listing A are measured: E19, E20.
#pragma once

#include <array>

#include "tb/golden/interpolation/triangle.h"

namespace blysk::claims {

inline constexpr golden::triangle<double> kTriangle{8, 4, 4, 8};
inline constexpr golden::six_intensities<double> kIntensities{40, 80, 60, 200, 120, 180};

struct node {
  const char* name;
  double x, y;
  double golden::six_intensities<double>::*intensity;
};
inline constexpr std::array<node, 6> kNodes{{
    {"vertex 1", 0, 0, &golden::six_intensities<double>::i1},
    {"vertex 2", 8, 4, &golden::six_intensities<double>::i2},
    {"vertex 3", 4, 8, &golden::six_intensities<double>::i3},
    {"middle of 1 and 2", 4, 2, &golden::six_intensities<double>::i12},
    {"middle of 1 and 3", 2, 4, &golden::six_intensities<double>::i13},
    {"middle of 2 and 3", 6, 6, &golden::six_intensities<double>::i23},
}};

}  // namespace blysk::claims
