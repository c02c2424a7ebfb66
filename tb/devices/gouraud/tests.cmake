# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)           # start, ready and valid
set(exhaustive ${blysk_formats})  # every run length; the colours run alongside
set(covered q8)
set(mutated q8)
set(replayed 20)  # lines of up to 1024 pixels
set(beside q8)
