// SPDX-License-Identifier: Apache-2.0
/// Bit-accurate model of the prototype on columns.
#pragma once

#include <array>
#include <cstdint>

#include "rtl_sysc/devices/quadratic_rom/quadratic_rom.h"
#include "tb/specular/parabola_engines.h"

namespace blysk::quadratic_rom_device {

/// A word for each code of register 1; beyond the memory's end, 0.
using memory = std::array<std::int32_t, 1024>;

/// From register outputs to 25, 26, 27, the laws in the netlist's order, for every write of the columns. Defined for every
/// named format and both lobes.
/// \tparam Formats  a quadratic_rom_formats
template <class Formats>
void compute(const memory& words, const specular::columns_of<Formats>& io);

/// The same at word lengths of the moment.
void compute(const specular::free_shape& shape, const memory& words, const specular::free_columns& io);

}  // namespace blysk::quadratic_rom_device
