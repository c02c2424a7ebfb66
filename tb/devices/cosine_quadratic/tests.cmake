# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family specular)  # registers and colour multipliers of rtl_sysc/devices/specular.h
set(has_bound ON)     # within which its BRDF is that of its formula
set(rounds_in_any_way ON)  # the model of any word length
set(changed_reference "s/}}} + 3/}}} + 0/")  # m of reference.v rounded down
# What the proof of composed.v has to notice.
set(composition_faults changed_rounding "s/+ 27'd16/+ 27'd8/"
                       crossed_wire "s/key12 (.a_i(square), .off_i(beyond_root)/key12 (.a_i(square), .off_i(grounded)/"
                       changed_hold "s/else if (we_i)/else/")
