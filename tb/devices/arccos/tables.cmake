# SPDX-License-Identifier: Apache-2.0
# update_price: synthesises the unit, the device it serves and the one that needs neither, and writes the table of all three.
set(price ${PROJECT_BINARY_DIR}/price)
set(synth ${CMAKE_COMMAND} -E env BLYSK_SYNTHESIS=$<TARGET_FILE:synthesis> BLYSK_ROWS=${price} ${PROJECT_SOURCE_DIR}/scripts/synth)
add_custom_target(update_price USES_TERMINAL VERBATIM
  COMMAND ${synth} quadratic q8
  COMMAND ${synth} angle q8
  COMMAND ${synth} arccos q8
  COMMAND ${CMAKE_COMMAND} -E make_directory ${tables}
  COMMAND ${own}/tables/price.sh ${price} ${tables}/price.csv)
