// SPDX-License-Identifier: Apache-2.0
/// Bit-accurate model of the quadratic device on columns.
#pragma once

#include "rtl_sysc/devices/quadratic/formats.h"
#include "tb/specular/parabola_engines.h"

namespace blysk::quadratic_device {

/// [P] fig. 1 from register outputs to 25, 26, 27, the laws in the netlist's order, for every write of the columns.
/// Compiled for several vector widths in one binary; the loader takes the widest that the processor has. Defined for every
/// named format and both lobes.
/// \tparam Formats  a quadratic_formats
template <class Formats>
void compute(const wired_constants& wired, const specular::columns_of<Formats>& io);

/// The same at word lengths of the moment.
void compute(const specular::free_shape& shape, const wired_constants& wired,
             const specular::free_columns& io);

}  // namespace blysk::quadratic_device
