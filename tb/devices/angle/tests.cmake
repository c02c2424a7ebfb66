# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)           # start, ready and valid
set(exhaustive ${blysk_formats})  # every exponent; intensities, angles and lengths run alongside
set(rows telling_rows)  # in which a wrong bit of a memory changes a pixel
set(covered q8)
set(mutated q8)
set(replayed 20)  # lines of up to 1023 pixels
set(beside "")  # angles have too many codes
set(stated q8 q12 q16)  # q24 was not waited for
# What the proof of states.v has to notice.
set(state_faults wrong_range "s/assert (now <= 2)/assert (now < 2)/"
                 changed_hold "s/else if (we_i)/else/"
                 changed_end "s/!carry_i/carry_i/")
# What the proof of composed.v has to notice.
set(composition_faults changed_rounding "s/35'd262144/35'd262143/"
                       crossed_address "s/rom2 (.a_i(n)/rom2 (.a_i(n_i)/"
                       changed_select "s/.select_b_i(first)/.select_b_i(load)/")
