# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family specular)  # registers and colour multipliers of rtl_sysc/devices/specular.h
set(has_bound ON)     # within which its BRDF is that of its formula
set(rounds_in_any_way ON)  # the model of any word length
set(changed_reference "s/S40 = 40'd865248229639/S40 = 40'd869543196935/")  # what spoils the BRDF of reference.v
