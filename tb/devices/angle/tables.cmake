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

# With a factor of the lobe the wiring is another one.
set(prove_energy ${own}/energy_composition.sh $<TARGET_FILE:exported> ${CMAKE_CURRENT_SOURCE_DIR}/composition/composition.sh)
foreach(format IN LISTS blysk_checked_formats)
  add_test(NAME cosim.${device}.formal.${format}.energy_composition COMMAND ${prove_energy} ${format})
  blysk_label(full cosim.${device}.formal.${format}.energy_composition)
endforeach()
add_test(NAME cosim.${device}.formal.crossed_factor COMMAND ${prove_energy} q8 "s/mul_energy (.a_i(lobe)/mul_energy (.a_i(~lobe)/")
set_tests_properties(cosim.${device}.formal.crossed_factor PROPERTIES PASS_REGULAR_EXPRESSION "proof did fail")
blysk_label(full cosim.${device}.formal.crossed_factor)
