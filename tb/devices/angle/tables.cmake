# SPDX-License-Identifier: Apache-2.0
# Tables that only this device has: the lobe against cos^n.
blysk_add_program(epicentre SOURCES ${own}/tables/epicentre.cpp LIBRARIES blysk_golden blysk_files)
blysk_add_program(telling_rows SOURCES ${own}/rows/telling_rows.cpp LIBRARIES blysk_files)
add_test(NAME docs.${device}.epicentre COMMAND epicentre --check ${tables})
blysk_label(quick docs.${device}.epicentre)
add_custom_target(update_epicentre USES_TERMINAL VERBATIM
  COMMAND ${CMAKE_COMMAND} -E make_directory ${tables}
  COMMAND epicentre --output ${tables})
add_dependencies(update_errors update_epicentre)

add_test(NAME cli.${device}.bad_input COMMAND ${own}/bad_input.sh $<TARGET_FILE:blysk>)
blysk_label(quick cli.${device}.bad_input)
