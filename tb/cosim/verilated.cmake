# SPDX-License-Identifier: Apache-2.0
# Verilog of the devices, Verilated while the project is built.
# blysk_verilated_table(TARGET KIND [NAME CLASS]...): adds the table of Verilated classes, cosim::KIND_table(). NAME is the
# name of the Verilog's folder, and behind a blank the options of its device, if they are not the presets.
function(blysk_verilated_table target kind)
  set(functions "")
  set(entries "")
  set(words ${ARGN})
  while(words)
    list(POP_FRONT words name class)
    string(APPEND functions "std::unique_ptr<verilator_engine> make_${class}();\n")
    string(APPEND entries "    {\"${name}\", make_${class}},\n")
  endwhile()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${target}_${kind}_table.cpp @ONLY CONTENT [[
// Made by CMake; do not edit.
#include "tb/cosim/verilated_table.h"

#include <vector>

namespace blysk::cosim {

@functions@
std::span<const verilated_entry> @kind@_table() {
  static const std::vector<verilated_entry> entries{
@entries@  };
  return entries;
}

}  // namespace blysk::cosim
]])
  target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${target}_${kind}_table.cpp)
endfunction()

if(BLYSK_VERILATED)
  find_package(verilator HINTS $ENV{VERILATOR_ROOT})
endif()
find_package(Threads REQUIRED)
if(NOT verilator_FOUND)
  if(BUILD_TESTING)
    message(FATAL_ERROR "No Verilator. Run scripts/setup, which installs it, or set BUILD_TESTING=OFF to build the programs "
                        "without engine verilator.")
  endif()
  message(STATUS "The programs have no engine verilator")
  return()
endif()

# Verilator's own sources.
add_library(blysk_verilator STATIC ${VERILATOR_ROOT}/include/verilated.cpp ${VERILATOR_ROOT}/include/verilated_cov.cpp
            ${VERILATOR_ROOT}/include/verilated_threads.cpp ${VERILATOR_ROOT}/include/verilated_vcd_c.cpp)
target_compile_options(blysk_verilator PRIVATE -w)
target_include_directories(blysk_verilator SYSTEM PUBLIC ${VERILATOR_ROOT}/include ${VERILATOR_ROOT}/include/vltstd)
target_link_libraries(blysk_verilator PUBLIC Threads::Threads)

# g++ works at the long functions of a class up to ten times as long with these passes; without them a write takes 3 % more
# instructions. Their headers have the same options: what #pragma GCC pop_options goes back to is what the precompiled header was made with.
add_library(blysk_class INTERFACE)
target_link_libraries(blysk_class INTERFACE blysk_verilator)
target_compile_options(blysk_class INTERFACE
  "$<$<CXX_COMPILER_ID:GNU>:-fno-thread-jumps;-fno-tree-pre;-Wno-uninitialized;-Wno-maybe-uninitialized>")
# Four hundred classes, and all read these; those that count what was reached know it by a macro.
set(headers <verilated.h> <verilated_vcd_c.h> ${CMAKE_CURRENT_SOURCE_DIR}/verilated.h)
blysk_headers(blysk_verilated_headers blysk_class HEADERS ${headers})
blysk_headers(blysk_covered_headers blysk_class HEADERS <verilated_cov.h> ${headers})
target_compile_definitions(blysk_covered_headers PRIVATE VM_COVERAGE=1)

# blysk_verilated_options(DEVICE): sets verilated_options, the lines of the device's file `verilated`.
function(blysk_verilated_options device)
  string(REPLACE - _ identifier ${device})
  set(file ${PROJECT_SOURCE_DIR}/tb/devices/${identifier}/verilated)
  set(lines "")
  if(EXISTS ${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(STRINGS ${file} lines)
  endif()
  set(verilated_options "${lines}" PARENT_SCOPE)
endfunction()

# blysk_option_words(OPTIONS): sets words, the options of a device as a list, and suffix, what a name gets for them: "_stages_4" for
# "--stages 4".
function(blysk_option_words options)
  separate_arguments(words UNIX_COMMAND "${options}")
  set(words "${words}" PARENT_SCOPE)
  string(REGEX REPLACE "[^A-Za-z0-9]+" "_" suffix "${options}")
  set(suffix "${suffix}" PARENT_SCOPE)
endfunction()

# blysk_verilog_of(DEVICE FORMAT [OPTIONS]): sets verilog_folder, where the device's Verilog is, and verilog_files, what to
# depend on. Checked-in formats are read from rtl_verilog/; the others, what is not there yet, and what has OPTIONS, "--energy"
# in one text, are exported into the build tree.
function(blysk_verilog_of device format)
  string(REPLACE - _ identifier ${device})
  set(name ${identifier}_${format})
  blysk_option_words("${ARGN}")
  set(folder ${PROJECT_SOURCE_DIR}/rtl_verilog/${name})
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.v)
  if(NOT format IN_LIST blysk_checked_formats OR NOT files OR words)
    set(folder ${PROJECT_BINARY_DIR}/rtl_verilog/${name}${suffix})
    set(files ${folder}/blysk_${name}.f)
  endif()
  set(verilog_folder ${folder} PARENT_SCOPE)
  set(verilog_files ${files} PARENT_SCOPE)
endfunction()

# blysk_export_verilog(DEVICE FORMAT [OPTIONS]): the command that exports into the build tree, if blysk_verilog_of() says so.
function(blysk_export_verilog device format)
  blysk_verilog_of(${device} ${format} "${ARGN}")
  if(NOT verilog_folder MATCHES "^${PROJECT_BINARY_DIR}/")
    return()
  endif()
  blysk_option_words("${ARGN}")
  add_custom_command(OUTPUT ${verilog_files} COMMAND exported update ${verilog_folder} ${device} ${format} ${words}
                     DEPENDS exported VERBATIM)
  add_custom_target(verilog_${device}_${format}${suffix} ALL DEPENDS ${verilog_files})
endfunction()

# blysk_verilate(TARGET CLASS DEVICE FORMAT TOP SOURCE [MUTANTS] [NO_INNER] [RECORDED] [DEPENDS file...] [ARGUMENTS verilator's...]
#                [OPTIONS word...])
# Adds the class that Verilator makes of module TOP of SOURCE, a Verilog file or a folder of them, with its glue to the
# ports of DEVICE with its OPTIONS: the function cosim::make_CLASS().
function(blysk_verilate target class device format top source)
  cmake_parse_arguments(PARSE_ARGV 6 arg "MUTANTS;NO_INNER;RECORDED" "" "DEPENDS;ARGUMENTS;OPTIONS")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/verilated/${class})
  set(kind "")
  if(arg_MUTANTS)
    set(kind --mutants --no-inner)
  elseif(arg_NO_INNER)
    set(kind --no-inner)
  elseif(arg_RECORDED)
    set(kind --recorded)
    list(APPEND arg_ARGUMENTS --trace)
  endif()
  add_custom_command(OUTPUT ${folder}/glue.cpp ${folder}/public.vlt
                     COMMAND verilated_glue ${device} ${format} ${class} ${top} --output ${folder} ${kind} ${arg_OPTIONS}
                     DEPENDS verilated_glue VERBATIM)
  add_custom_command(OUTPUT ${folder}/all.cpp
                     COMMAND ${CMAKE_COMMAND} -E env VERILATOR_ROOT=${VERILATOR_ROOT} VERILATOR=${VERILATOR_BIN}
                             ${CMAKE_CURRENT_SOURCE_DIR}/verilate.sh ${folder} ${class} ${top} ${source} public.vlt ${arg_ARGUMENTS}
                     DEPENDS ${arg_DEPENDS} ${folder}/public.vlt ${CMAKE_CURRENT_SOURCE_DIR}/verilate.sh VERBATIM)
  set_source_files_properties(${folder}/glue.cpp PROPERTIES OBJECT_DEPENDS ${folder}/all.cpp
                              COMPILE_OPTIONS "-isystem;${folder}")
  target_sources(${target} PRIVATE ${folder}/glue.cpp)
endfunction()
