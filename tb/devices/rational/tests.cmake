# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family specular)  # registers and colour multipliers of rtl_sysc/devices/specular.h
set(has_bound ON)     # within which its BRDF is that of its formula
set(covered q8)
set(mutated q8)
set(changed_reference "s/(quotient + 1) >> 1/quotient >> 1/")  # the BRDF of reference.v rounded down
# What the proof of composed.v has to notice.
set(composition_faults changed_limit "s/12'd2048/12'd2047/"
                       crossed_wire "s/rom_rise (.a_i(n)/rom_rise (.a_i({n[8:0], n[9]})/"
                       changed_hold "s/else if (we_i)/else/")
