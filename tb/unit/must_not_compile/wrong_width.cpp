// SPDX-License-Identifier: Apache-2.0
// A net of another width cannot be bound to a port.
#include "rtl_sysc/blocks/reg_level.h"

void bind(blysk::reg_level<blysk::uq<8, 0>>& reg, sc_core::sc_signal<sc_dt::sc_uint<9>>& wide) {
  reg.q_o(wide);
}
