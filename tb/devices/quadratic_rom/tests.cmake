# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family specular)  # registers and colour multipliers of rtl_sysc/devices/specular.h
set(has_bound ON)     # within which its BRDF is that of its formula
set(rounds_in_any_way ON)  # the model of any word length
set(changed_reference "s/44'd17179869184/44'd25769803776/")  # the word of n = 2 in reference.v, 1.5 instead of 1
