// SPDX-License-Identifier: Apache-2.0
/// What the bit-accurate model says of a certificate.
#pragma once

#include "tb/cost/certificate_row.h"
#include "tb/device.h"
#include "tb/netlist/gappa_path.h"

namespace blysk {

/// The largest error of the model against the device's formula in double, at the exponents 1..1000: at all codes of the cosine,
/// or from q21 on at those beside 0, the end of the lobe and 1, and at some at random.
cost::seen_error largest_error(const selection& asked);

/// Whether the definitions that Gappa is told of the netlist give the model's results at 20,000 inputs: random ones, half of them
/// in the lobe, and the ends of the codes. Prints what was compared, or the first difference.
bool are_those_of_the_model(const selection& asked, netlist::planted_fault fault);

}  // namespace blysk
