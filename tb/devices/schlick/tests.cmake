# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family specular)  # registers and colour multipliers of rtl_sysc/devices/specular.h
set(has_bound ON)     # within which its BRDF is that of its formula
set(covered q8)
set(mutated q8)
set(changed_reference "s/(quotient + 1) >> 1/quotient >> 1/")  # the BRDF of reference.v rounded down
# What the proof of composed.v has to notice.
set(composition_faults changed_digit "s/flag5 ? shifted4/flag4 ? shifted4/"
                       crossed_wire "s/mul13 (.a_i(brdf), .b_i(g_ks)/mul13 (.a_i(brdf), .b_i(b_ks)/"
                       changed_hold "s/else if (we_i)/else/")
