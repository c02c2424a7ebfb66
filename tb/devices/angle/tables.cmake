# SPDX-License-Identifier: Apache-2.0
# Tables that only this device has: the lobe against cos^n.
add_executable(epicentre ${own}/tables/epicentre.cpp)
target_link_libraries(epicentre PRIVATE blysk_program blysk_golden blysk_files blysk_options)
set_target_properties(epicentre PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
add_test(NAME docs.${device}.epicentre COMMAND epicentre --check ${tables})
blysk_label(quick docs.${device}.epicentre)
add_custom_target(update_epicentre USES_TERMINAL VERBATIM
  COMMAND ${CMAKE_COMMAND} -E make_directory ${tables}
  COMMAND epicentre --output ${tables})
add_dependencies(update_errors update_epicentre)

add_test(NAME cli.${device}.bad_input COMMAND ${own}/bad_input.sh $<TARGET_FILE:blysk>)
blysk_label(quick cli.${device}.bad_input)
