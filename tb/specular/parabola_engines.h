// SPDX-License-Identifier: Apache-2.0
/// Engines on kernels of tb/specular/parabola_law.h.
#pragma once

#include "tb/specular/parabola_law.h"
#include "tb/specular/point_engines.h"

namespace blysk::specular {

/// The shape that word lengths {"cos", "coefficient", "square"} ask for.
/// \throws std::invalid_argument if one is missing or unknown, or a net would need more than 64 bits
free_shape shape_of(const word_lengths& bits, bool is_clamped, rounding how);

/// Those of a format.
word_lengths widths_of(int cos_bits, int coefficient_bits);

}  // namespace blysk::specular
