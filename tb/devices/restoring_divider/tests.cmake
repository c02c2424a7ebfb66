# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)  # start, ready and valid
set(exhaustive ${blysk_formats})  # 511 differences by 1023 run lengths
set(covered q8)
set(mutated q8)
# What the proof of states.v has to notice.
set(state_faults wrong_range "s/left <= F + 8/left < F + 8/"
                 kept_rest "s/selected < {1'b0, selected2}/selected <= {1'b0, selected2}/"
                 changed_hold "s/wire flag = load_i || step_i/wire flag = load_i || !step_i/"
                 changed_valid "s/done_o <= left == 7'd1/done_o <= left == 7'd2/"
                 changed_reset "s/left <= 7'd0/left <= 7'd1/")
# What the proof of composed.v has to notice.
set(composition_faults changed_compare "s/selected < {1'b0, selected2}/selected <= {1'b0, selected2}/"
                       crossed_wire "s/.a_i(dividend)/.a_i(~dividend)/"
                       changed_load "s/.go_i(load)/.go_i(step)/")
