# SPDX-License-Identifier: Apache-2.0
# Tables that only this device has: what the published comparator lets through, and the reflectance with each factor.
blysk_add_program(beyond_root SOURCES ${own}/tables/beyond_root.cpp LIBRARIES blysk_golden blysk_files)
add_test(NAME docs.${device}.beyond_root COMMAND beyond_root --check ${tables})
blysk_label(quick docs.${device}.beyond_root)
add_custom_target(update_beyond_root USES_TERMINAL VERBATIM
  COMMAND ${CMAKE_COMMAND} -E make_directory ${tables}
  COMMAND beyond_root --output ${tables}
  COMMAND gnuplot -c ${own}/tables/beyond_root.gnuplot ${tables}/beyond_root.csv
          ${PROJECT_SOURCE_DIR}/docs/figures/beyond_root_${identifier}.svg)
add_dependencies(update_errors update_beyond_root)
