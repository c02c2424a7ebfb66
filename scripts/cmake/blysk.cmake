# SPDX-License-Identifier: Apache-2.0
# What every target of the project shares.

add_library(blysk_options INTERFACE)
target_include_directories(blysk_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(blysk_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
  $<$<BOOL:${BLYSK_WERROR}>:-Werror>
  # clang says where a kernel that asks for vectors gets none: slower, but right.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-pass-failed>)

# Headers that many sources include are parsed once for all. Not with clang, which refuses them where options differ, nor with
# sanitizers, whose options differ by folder. ccache keeps such objects only with CCACHE_SLOPPINESS=pch_defines,time_macros.
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU OR BLYSK_SANITIZERS)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
# For text that a run passes once, as tests, command lines and pages: it takes a third less time to compile. What a run passes
# often is in libraries, or in sources of blysk_optimise(), with all optimisations.
set(blysk_once_options $<$<CONFIG:Release>:-O1>)
function(blysk_optimise)
  set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS $<$<CONFIG:Release>:-O3>)
endfunction()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/no_text.cpp CONTENT "// Made by CMake.\n")
# blysk_headers(NAME LIBRARY... HEADERS header...): what targets with target_precompile_headers(REUSE_FROM NAME) share.
function(blysk_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS")
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/generated/no_text.cpp)
  target_link_libraries(${name} PRIVATE blysk_options ${arg_UNPARSED_ARGUMENTS})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()
blysk_headers(blysk_program_headers fmt::fmt CLI11::CLI11 nlohmann_json::nlohmann_json
              HEADERS <CLI/CLI.hpp> <fmt/format.h> <nlohmann/json.hpp>)
if(BUILD_TESTING)
  blysk_headers(blysk_test_headers Catch2::Catch2 HEADERS ${PROJECT_SOURCE_DIR}/tb/catch.h)
  target_compile_options(blysk_test_headers PRIVATE ${blysk_once_options})
endif()

# A compiler that looks at a source of the project, for tests of what must not compile.
set(blysk_compiler ${CMAKE_CXX_COMPILER} -std=c++20 -fsyntax-only -I${PROJECT_SOURCE_DIR}
                   -isystem $<TARGET_PROPERTY:SystemC::systemc,INTERFACE_INCLUDE_DIRECTORIES>)

# Tests see no locale but this one, and no variable that changes what the tools say or where cd goes.
file(WRITE ${PROJECT_BINARY_DIR}/test_environment.cmake
  "set(ENV{LC_ALL} C.UTF-8)\nunset(ENV{LANGUAGE})\nunset(ENV{CDPATH})\n")
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY TEST_INCLUDE_FILES ${PROJECT_BINARY_DIR}/test_environment.cmake)

if(BUILD_TESTING)
  list(APPEND CMAKE_MODULE_PATH ${Catch2_DIR})
  include(Catch)
endif()

# blysk_build_only(PROGRAM...): the target all is these programs and what they need.
function(blysk_build_only)
  set(directories ${PROJECT_SOURCE_DIR})
  while(directories)
    list(POP_FRONT directories directory)
    get_property(below DIRECTORY ${directory} PROPERTY SUBDIRECTORIES)
    list(APPEND directories ${below})
    get_property(targets DIRECTORY ${directory} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(target IN LISTS targets)
      set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
    endforeach()
  endwhile()
  set_target_properties(${ARGV} PROPERTIES EXCLUDE_FROM_ALL OFF)
endfunction()

# blysk_add_test(AREA.SUBJECT SOURCES a.cpp ... LIBRARIES lib ... [LABELS label ...] [ENVIRONMENT VAR=value ...])
# A Catch2 program; its cases become the ctest tests "AREA.SUBJECT: case", one process each.
# A case tagged [full] bears the label full, [long] long, every other one quick; LABELS come on top.
# With BUILD_TESTING off it is a target that nothing builds, and Catch2 is not there.
function(blysk_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;LABELS;ENVIRONMENT")
  if(NOT BUILD_TESTING)
    add_executable(${name} EXCLUDE_FROM_ALL ${arg_SOURCES})
    return()
  endif()
  add_executable(${name} ${arg_SOURCES})
  set_property(GLOBAL APPEND PROPERTY blysk_test_programs ${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  # Catch2 first: a static SystemC has a main of its own, for those who come without one.
  target_link_libraries(${name} PRIVATE blysk_options Catch2::Catch2WithMain ${arg_LIBRARIES})
  target_precompile_headers(${name} REUSE_FROM blysk_test_headers)
  target_compile_options(${name} PRIVATE ${blysk_once_options})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  set(text "")
  foreach(source IN LISTS arg_SOURCES)
    file(READ ${source} content)
    string(APPEND text "${content}")
  endforeach()
  foreach(label quick full long)
    if(label STREQUAL quick)
      set(spec "~[full]~[long]")
    elseif(text MATCHES "\\[${label}\\]")
      set(spec "[${label}]")
    else()
      continue()  # Catch2 warns of a list without cases
    endif()
    catch_discover_tests(${name} TEST_SPEC ${spec} TEST_PREFIX "${name}: " TEST_LIST ${name}_${label}
                         DISCOVERY_MODE PRE_TEST PROPERTIES LABELS ${label})
    set(labels ${label} ${arg_LABELS})
    # catch_discover_tests flattens lists, so what takes a list is set when ctest has read the cases.
    set(properties_file ${CMAKE_CURRENT_BINARY_DIR}/${name}_${label}_properties.cmake)
    file(WRITE ${properties_file}
      "if(${name}_${label})\n"
      "  set_tests_properties(\${${name}_${label}} PROPERTIES\n"
      "    LABELS \"${labels}\" ENVIRONMENT \"${arg_ENVIRONMENT}\")\n"
      "endif()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${properties_file})
  endforeach()
endfunction()

# blysk_add_program(NAME SOURCES a.cpp ... LIBRARIES lib ... [OPTIMISED]): a program of the tests and pages, in tests/.
# OPTIMISED: it has loops of its own over many inputs.
function(blysk_add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OPTIMISED" "" "SOURCES;LIBRARIES")
  add_executable(${name} ${arg_SOURCES})
  if(NOT arg_OPTIMISED)
    target_compile_options(${name} PRIVATE ${blysk_once_options})
  endif()
  target_link_libraries(${name} PRIVATE blysk_program ${arg_LIBRARIES} blysk_options)
  target_precompile_headers(${name} REUSE_FROM blysk_program_headers)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
endfunction()

# blysk_add_door(NAME SOURCE LIBRARY...): a place where text from outside enters, and its fuzz target.
# The test doors.NAME tries the inputs in finds/NAME beside the source, those that once showed a fault and those that a
# run starts from. With BLYSK_FUZZ, as the preset fuzz sets it, the target fuzz.NAME is that of libFuzzer.
function(blysk_add_door name source)
  set(shared ${PROJECT_SOURCE_DIR}/tb/fuzz)
  get_filename_component(beside ${source} DIRECTORY)
  set(finds ${CMAKE_CURRENT_SOURCE_DIR}/${beside}/finds/${name})
  if(BLYSK_FUZZ)
    set(target fuzz.${name})
    add_executable(${target} ${source} ${shared}/fuzz.cpp)
    target_link_options(${target} PRIVATE -fsanitize=fuzzer)
    set_property(GLOBAL APPEND PROPERTY blysk_doors ${target} ${finds})
  elseif(BUILD_TESTING)
    set(target doors.${name})
    add_executable(${target} ${source} ${shared}/fuzz.cpp ${shared}/replay.cpp)
    add_test(NAME ${target} COMMAND ${target} ${finds})
    set_property(GLOBAL APPEND PROPERTY blysk_test_programs ${target})
    set_tests_properties(${target} PROPERTIES LABELS quick)
  else()
    return()
  endif()
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  target_link_libraries(${target} PRIVATE blysk_options blysk_files ${ARGN})
endfunction()
