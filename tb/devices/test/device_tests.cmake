# SPDX-License-Identifier: Apache-2.0
# Tests that every device passes. Their cases read the device, format and options from the environment.

# blysk_case_program(PROGRAM SOURCES... LIBRARIES...): a Catch2 program for blysk_cases(). With BUILD_TESTING off it is a
# target that nothing builds, as with blysk_add_test().
function(blysk_case_program program)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  if(NOT BUILD_TESTING)
    add_executable(${program} EXCLUDE_FROM_ALL ${arg_SOURCES})
    return()
  endif()
  add_executable(${program} ${arg_SOURCES})
  target_link_libraries(${program} PRIVATE blysk_options Catch2::Catch2WithMain ${arg_LIBRARIES})
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
endfunction()

# blysk_cases(AREA PROGRAM DEVICE FORMATS format... [QUICK format...] [LABEL label] SOURCES file...): each case of the sources as a test of
# its own, "AREA.DEVICE.FORMAT: case". A case tagged [variants] is tried with each line of the device's file `variants`
# besides. Tests take the label quick in the formats named so, without further options, and full elsewhere; LABEL comes on top.
function(blysk_cases area program device)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "LABEL" "FORMATS;QUICK;SOURCES")
  string(REPLACE - _ identifier ${device})
  set(variants "")
  set(file ${PROJECT_SOURCE_DIR}/tb/devices/${identifier}/variants)
  if(EXISTS ${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(STRINGS ${file} variants REGEX "^--")
  endif()
  foreach(source IN LISTS arg_SOURCES)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    file(STRINGS ${source} lines REGEX "^TEST_CASE\\(\"")
    foreach(line IN LISTS lines)
      string(REGEX MATCH "^TEST_CASE\\(\"([^\"]+)\"(.*)" matched "${line}")
      set(case "${CMAKE_MATCH_1}")
      set(tags "${CMAKE_MATCH_2}")
      string(REPLACE "," "\\," pattern "${case}")  # a comma ends a pattern of Catch2
      foreach(format IN LISTS arg_FORMATS)
        blysk_case("${area}.${device}.${format}: ${case}" ${program} "${pattern}" ${device} ${format} "" "${arg_QUICK}"
                   "${arg_LABEL}")
        if(tags MATCHES "\\[variants\\]")
          foreach(options IN LISTS variants)
            blysk_case("${area}.${device}.${format}: ${case}, ${options}" ${program} "${pattern}" ${device} ${format}
                       "${options}" "" "${arg_LABEL}")
          endforeach()
        endif()
      endforeach()
    endforeach()
  endforeach()
endfunction()

function(blysk_case name program pattern device format options quick label_besides)
  add_test(NAME "${name}" COMMAND ${program} "${pattern}")
  set(label full)
  if(format IN_LIST quick)
    set(label quick)
  endif()
  # A name that no case has is a success for Catch2 2.
  set_tests_properties("${name}" PROPERTIES LABELS "${label};${label_besides}" FAIL_REGULAR_EXPRESSION "No test"
    ENVIRONMENT "BLYSK_DEVICE=${device};BLYSK_FORMAT=${format};BLYSK_OPTIONS=${options}")
endfunction()

# blysk_narrow_nets(DEVICE): each line of the device's narrow.txt as a test.
function(blysk_narrow_nets device)
  string(REPLACE - _ identifier ${device})
  set(file ${PROJECT_SOURCE_DIR}/tb/devices/${identifier}/narrow.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(STRINGS ${file} lines REGEX "^[^#]")
  set(number 0)
  foreach(line IN LISTS lines)
    math(EXPR number "${number} + 1")
    set(change "")
    if(line MATCHES "^assert (.+)$")
      set(assertion "${CMAKE_MATCH_1}")
      set(name nothing_narrow_${number})
    elseif(line MATCHES "^narrow ([^ ]+) ([^ ]+) ([^ ]+) ([^ ]+)$")
      set(change ${CMAKE_MATCH_1} ${CMAKE_MATCH_2} ${CMAKE_MATCH_3} ${CMAKE_MATCH_4})
      set(name narrow_${number}_${CMAKE_MATCH_2})
    else()
      message(FATAL_ERROR "${file}: expected 'assert HEADER CONDITION' or 'narrow FILE NET FROM TO', not '${line}'")
    endif()
    set(name unit.${device}.must_not_compile.${name})
    add_test(NAME ${name} COMMAND ${PROJECT_SOURCE_DIR}/tb/devices/test/narrow.sh ${assertion} ${change} ${blysk_compiler}
             WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(${name} PROPERTIES LABELS quick)
  endforeach()
endfunction()

# blysk_device_unit_tests(DEVICE): the cases of this folder, and what stands in the device's own folder: *_test.cpp,
# narrow.txt, and tests.cmake, which names the device's family.
function(blysk_device_unit_tests device)
  string(REPLACE - _ identifier ${device})
  set(here ${PROJECT_SOURCE_DIR}/tb/devices/test)
  set(own ${PROJECT_SOURCE_DIR}/tb/devices/${identifier})
  blysk_cases(unit device_cases ${device} FORMATS ${blysk_formats} QUICK q8
              SOURCES ${here}/equality_test.cpp ${here}/inputs_test.cpp)
  blysk_cases(unit device_thread_cases ${device} FORMATS q8 QUICK q8 SOURCES ${here}/thread_test.cpp)
  file(GLOB sources CONFIGURE_DEPENDS ${own}/*_test.cpp)
  if(sources)
    blysk_add_test(unit.${device} SOURCES ${sources} LIBRARIES blysk_harness blysk_interpreter blysk_golden)
    target_compile_definitions(unit.${device} PRIVATE BLYSK_DEVICE_FOLDER="${own}")
  endif()
  if(EXISTS ${own}/narrow.txt)
    blysk_narrow_nets(${device})
  endif()
  set(family "")
  set(has_bound OFF)
  include(${own}/tests.cmake OPTIONAL)
  if(family STREQUAL specular)
    blysk_specular_unit_tests(${device})
  endif()
endfunction()
