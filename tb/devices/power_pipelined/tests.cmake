# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(family pipelined)        # of tb/specular/pipelined.h
set(unpiped power)           # the device without registers between its blocks
set(protocol handshake)      # start, ready and valid
set(exhaustive q8 q10 q12)
set(beside q8)
set(covered q8)
set(mutated q8)
set(simulated 100000)        # rows of each variant that are tried in SystemC
