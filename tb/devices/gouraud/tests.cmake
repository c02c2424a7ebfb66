# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)           # start, ready and valid
set(exhaustive ${blysk_formats})  # every run length; the colours run alongside
set(covered q8)
set(mutated q8)
set(replayed 20)  # lines of up to 1024 pixels
set(beside q8)
# What the proof of states.v has to notice.
set(state_faults wrong_range "s/pixels <= 1024/pixels < 1024/"
                 changed_hold "s/else if (load_i || step_i)/else/"
                 changed_count "s/{1'b0, length_i} + 11'd1/{1'b0, length_i} + 11'd2/"
                 changed_reset "s/pixels_left <= 11'd0/pixels_left <= 11'd1/")
# What the proof of composed.v has to notice.
set(composition_faults changed_rounding "s/20'd128/20'd127/"
                       crossed_channel "s/.left_i(g0_i)/.left_i(r0_i)/"
                       changed_step "s/.step_i(draw_i)/.step_i(step_i)/")
