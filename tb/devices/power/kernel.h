// SPDX-License-Identifier: Apache-2.0
/// Bit-accurate model of power on columns.
#pragma once

#include "rtl_sysc/devices/power/formats.h"
#include "tb/specular/point_engines.h"

namespace blysk::power_device {

/// From register outputs to the colours, the laws in the netlist's order, for every write of the columns. Defined for every
/// named format.
/// \tparam Formats  a power_formats
template <class Formats>
void compute(const specular::columns_of<Formats>& io);

/// The same on columns of any storage.
template <class Formats>
void compute(const specular::free_columns& io);

}  // namespace blysk::power_device
