# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family iterative)        # of tb/specular/iterative.h
set(computes_as gx)          # the device whose results these are
set(protocol handshake)      # start, ready and valid
set(exhaustive q8 q10 q12)
set(beside q8)
set(covered "")
set(mutated q8)
set(simulated 300000)        # rows of each variant that are tried in SystemC
# What the proof of composed.v has to notice.
set(composition_faults changed_unity "s/17'd65536 - a_i/17'd65535 - a_i/"
                       crossed_wire "s/.a_i(half_n), .b_i(rest)/.a_i(half_n), .b_i(square)/"
                       changed_first "s/first_o = left == 7'd10/first_o = left == 7'd1/")
