# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family specular)  # registers and colour multipliers of rtl_sysc/devices/specular.h
set(has_bound ON)     # within which its BRDF is that of its formula
set(covered q8)
set(mutated q8)
set(changed_reference "s/(4 << F) - drop/(4 << F) - drop - 1/")  # the bracket of reference.v an ulp lower
# What the proof of composed.v has to notice.
set(composition_faults changed_rounding "s/+ 21'd256/+ 21'd128/"
                       crossed_wire "s/square4 (.a_i(power2), .b_i(power2)/square4 (.a_i(power2), .b_i(root)/"
                       changed_reset "s/we_q <= 1'd0/we_q <= 1'd1/")
