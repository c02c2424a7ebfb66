# SPDX-License-Identifier: Apache-2.0
# What the functions that declare a device's tests have to know of this one.
set(protocol handshake)           # start, ready and valid
set(exhaustive ${blysk_formats})  # every length; values and differences run alongside
set(covered q8)
set(mutated q8)
set(replayed 20)  # lines of up to 1024 pixels
set(beside "")  # values and differences have too many codes
