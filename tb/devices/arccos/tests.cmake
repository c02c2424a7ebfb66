# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)  # start, ready and valid
set(exhaustive q8 q10 q12 q14 q16 q18 q20)  # every cosine
set(simulated 300000)  # inputs that SystemC takes one after the other; each takes up to 31 cycles
set(covered q8)
set(mutated q8)
set(beside "")  # there are no other ports
set(stated q8 q12 q16)  # q24 was not waited for
# What the proof of states.v has to notice.
set(state_faults wrong_range "s/left <= STEPS/left < STEPS/"
                 changed_hold "s/else if (flag)/else/"
                 changed_valid "s/done_o <= left == 7'd1/done_o <= left == 7'd2/"
                 changed_root "s/ - sum2.14:0./ - 15'd0/")
# What the proof of composed.v has to notice.
set(composition_faults changed_subtrahend "s/ - sum2.14:0./ - 15'd0/"
                       crossed_wire "s/.d_i(versine_in), .we_i/.d_i(cos_i), .we_i/"
                       changed_enable "s/.we_i(load)/.we_i(step)/")
