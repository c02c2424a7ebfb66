# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family specular)  # registers and colour multipliers of rtl_sysc/devices/specular.h
set(has_bound ON)     # within which its BRDF is that of its formula
set(covered q8)
set(mutated q8)
# What the proof of composed.v has to notice.
set(composition_faults changed_digit "s/selected2.8:7. == 2'd0/selected2[8:7] == 2'd1/"
                       crossed_wire "s/off (.a_i(above), .b_i(is_zero)/off (.a_i(above), .b_i(grounded)/"
                       changed_shift "s/{4'b0, selected2.11:4.}/{4'b0, selected2[10:3]}/")
