# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)           # start, ready and valid
set(exhaustive ${blysk_formats})  # every length; values and differences run alongside
set(covered q8)
set(mutated q8)
set(replayed 20)  # lines of up to 1024 pixels
set(beside "")  # values and differences have too many codes
# What the proof of states.v has to notice.
set(state_faults wrong_range "s/left <= 1024/left < 1024/"
                 changed_hold "s/else if (load_i || step_i)/else/"
                 changed_count "s/{1'b0, length_i} + 11'd1/{1'b0, length_i}/"
                 changed_reset "s/ left <= 11'd0/ left <= 11'd1/")
# What the proof of composed.v has to notice.
set(composition_faults changed_limit "s/23'sd255/23'sd254/"
                       crossed_wire "s/.a_i(value), .b_i(first)/.a_i(value), .b_i(next_first)/"
                       changed_enable "s/else if (load_i || step_i)/else if (step_i)/")
