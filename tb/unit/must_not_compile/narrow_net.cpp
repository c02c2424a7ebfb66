// SPDX-License-Identifier: Apache-2.0
// A net one bit too narrow is refused at compile time: cos^2 - cos reaches -1/4, SQ-3.16 ends at -1/8.
#include "rtl_sysc/formats.h"

using narrow = blysk::sq<-3, 16>;
using net = blysk::quadratic_formats<blysk::q8, blysk::lobe::clamped>;
static_assert(blysk::fits<narrow>(net::add9::law(net::mul7::law(128L, 128L), net::inv8::law(128L), 1L), 0),
              "overflow of cos^2 - cos");
