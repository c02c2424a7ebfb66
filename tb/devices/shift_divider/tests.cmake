# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)  # start, ready and valid
set(exhaustive ${blysk_formats})  # 511 differences by 1023 run lengths
set(covered q8)
set(mutated q8)
# What the proof of states.v has to notice.
set(state_faults wrong_range "s/left <= F/left < F/"
                 changed_hold "s/load_i || step_i && add_i/load_i || !step_i || add_i/"
                 changed_valid "s/done_o <= left == 7'd1/done_o <= left == 7'd2/"
                 changed_reset "s/left <= 7'd0/left <= 7'd1/")
# What the proof of composed.v has to notice.
set(composition_faults changed_shift "s/{shifted.14., shifted}/{1'b0, shifted}/"
                       crossed_wire "s/.a_i(increment_o), .b_i(shifted)/.a_i(sum), .b_i(shifted)/"
                       fewer_steps "s/STEPS(7'd8)/STEPS(7'd7)/")
