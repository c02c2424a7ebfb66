# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family specular)  # registers and colour multipliers of rtl_sysc/devices/specular.h
set(has_bound ON)     # within which its BRDF is that of its formula
set(covered q8)
set(mutated q8)
# What the proof of composed.v has to notice.
set(composition_faults changed_rounding "s/29'd16/29'd15/"
                       crossed_wire "s/mul_log (.a_i(versine), .b_i(factor)/mul_log (.a_i(cos_delta), .b_i(factor)/"
                       changed_reset "s/q_o <= 9'd0/q_o <= 9'd1/")
