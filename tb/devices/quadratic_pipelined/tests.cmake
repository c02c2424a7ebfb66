# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family pipelined)        # of tb/specular/pipelined.h
set(computes_as quadratic)   # the device without registers between its blocks
set(protocol handshake)      # start, ready and valid
set(exhaustive q8 q10 q12)
set(beside q8)
set(covered q8)
set(mutated q8)
set(simulated 100000)        # rows of each variant that are tried in SystemC
# What the proof of composed.v has to notice.
set(composition_faults changed_rounding "s/+ 34'd32768/+ 34'd16384/"
                       crossed_wire "s/.b_i(cos_3), .carry_i/.b_i(cos_1), .carry_i/"
                       lost_stage "s/q_o <= held_2/q_o <= held_1/")
