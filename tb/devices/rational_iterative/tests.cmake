# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family iterative)        # of tb/specular/iterative.h
set(computes_as rational)    # the device whose results these are
set(protocol handshake)      # start, ready and valid
set(exhaustive q8 q10 q12)
set(beside q8)
set(covered "")
set(mutated "")
set(simulated 300000)        # rows of each variant that are tried in SystemC
# What the proof of composed.v has to notice.
set(composition_faults changed_limit "s/12'd2048/12'd2047/"
                       crossed_wire "s/rom_rise (.a_i(n)/rom_rise (.a_i({n[8:0], n[9]})/"
                       changed_first "s/first_o = left == 7'd10/first_o = left == 7'd1/")
