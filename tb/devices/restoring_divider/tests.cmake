# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)  # start, ready and valid
set(exhaustive ${blysk_formats})  # 511 differences by 1023 run lengths
set(covered "")
set(mutated "")
