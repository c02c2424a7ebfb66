# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)  # start, ready and valid
set(exhaustive q8 q10 q12 q14 q16 q18 q20)  # every N.L; coefficients and terms run alongside
set(simulated 100000)  # rows that are tried in SystemC
set(covered "")
set(mutated "")
set(beside "")  # coefficients and terms have too many codes
