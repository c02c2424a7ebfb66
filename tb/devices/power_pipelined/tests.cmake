# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family pipelined)        # of tb/specular/pipelined.h
set(computes_as power)       # the device without registers between its blocks
set(protocol handshake)      # start, ready and valid
set(exhaustive q8 q10 q12)
set(beside q8)
set(covered q8)
set(mutated q8)
set(simulated 100000)        # rows of each variant that are tried in SystemC
# What the proof of composed.v has to notice.
set(composition_faults changed_digit "s/selected2.8:7. == 2'd0/selected2[8:7] == 2'd1/"
                       crossed_wire "s/.b_i(is_zero_7), .y_o/.b_i(is_zero), .y_o/"
                       changed_control "s/assign go_o = (stall_i/assign go_o = (start_i/")
