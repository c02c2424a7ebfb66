// SPDX-License-Identifier: Apache-2.0
// Compiled with formats.h in which one net has an integer bit less than the device's law needs.
#include "rtl_sysc/formats.h"

static_assert(blysk::quadratic_formats<blysk::q8, blysk::lobe::clamped>::no_overflow());
