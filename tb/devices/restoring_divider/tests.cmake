# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)  # start, ready and valid
set(exhaustive ${blysk_formats})  # 511 differences by 1023 run lengths
set(covered "")
set(mutated "")
# What the proof of composed.v has to notice.
set(composition_faults changed_compare "s/selected < {1'b0, selected2}/selected <= {1'b0, selected2}/"
                       crossed_wire "s/.a_i(dividend)/.a_i(~dividend)/"
                       changed_load "s/.go_i(load)/.go_i(step)/")
