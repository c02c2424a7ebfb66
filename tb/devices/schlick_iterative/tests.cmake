# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family iterative)        # of tb/specular/iterative.h
set(computes_as schlick)     # the device whose results these are
set(protocol handshake)      # start, ready and valid
set(exhaustive q8 q10 q12)
set(beside q8)
set(covered "")
set(mutated q8)
set(simulated 300000)        # rows of each variant that are tried in SystemC
# What the proof of composed.v has to notice.
set(composition_faults changed_compare "s/selected < {1'b0, selected2}/selected <= {1'b0, selected2}/"
                       crossed_wire "s/mul13 (.a_i(brdf), .b_i(g_ks)/mul13 (.a_i(brdf), .b_i(b_ks)/"
                       changed_first "s/first_o = left == 7'd10/first_o = left == 7'd1/")
