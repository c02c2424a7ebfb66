# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family specular)  # registers and colour multipliers of rtl_sysc/devices/specular.h
set(has_bound ON)     # within which its BRDF is that of its formula
set(covered q8)
set(mutated q8)
set(changed_reference "s/(quotient + 1) >> 1/quotient >> 1/")  # the BRDF of reference.v rounded down
# What the proof of composed.v has to notice.
set(composition_faults changed_unity "s/17'd65536 - a_i/17'd65535 - a_i/"
                       crossed_wire "s/.a_i(half_n), .b_i(rest)/.a_i(half_n), .b_i(square)/"
                       changed_edge "s/we_q <= we_i/we_q <= !we_i/")
