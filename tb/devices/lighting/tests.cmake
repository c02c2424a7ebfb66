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
