// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/scene/scene.h"

namespace blysk::scene {

/// The mesh turned around an axis.
/// \param through    a point of the axis
/// \param axis       of any length above 0; seen from its end the mesh turns counter-clockwise
/// \param angle_rad  by which
mesh turned(const mesh& of, const vec& through, const vec& axis, double angle_rad);

}  // namespace blysk::scene
