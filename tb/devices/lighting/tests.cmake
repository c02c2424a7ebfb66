# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)  # start, ready and valid
set(exhaustive q8 q10 q12 q14 q16 q18 q20)  # every N.L; coefficients and terms run alongside
set(simulated 100000)  # rows that are tried in SystemC
set(covered q8)
set(mutated q8)
set(beside "")  # coefficients and terms have too many codes
# What the proof of states.v has to notice.
set(state_faults wrong_bound "s/r_sum_o <= MOST/r_sum_o < MOST/"
                 changed_hold "s/else if (we_i)/else/"
                 changed_valid "s/else if (go_i)/else/"
                 changed_reset "s/q_o <= 24'd0/q_o <= 24'd1/")
# What the proof of composed.v has to notice.
set(composition_faults changed_limit "s/24'd16711680/24'd16711679/"
                       crossed_channel "s/.ambient_i(ag_i)/.ambient_i(ar_i)/"
                       stopped_valid "s/.go_i(go), .d_i(start_i)/.go_i(take), .d_i(start_i)/")
