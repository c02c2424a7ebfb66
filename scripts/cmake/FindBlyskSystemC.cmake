# SPDX-License-Identifier: Apache-2.0
# Finds SystemC and gives the target SystemC::systemc. In this order:
#   SystemCLanguage_DIR   folder of SystemCLanguageConfig.cmake    (CMake or environment variable)
#   SYSTEMC_HOME          an installed SystemC, built with CMake or autotools            (likewise)
#   build/deps/systemc    the one that scripts/setup builds

foreach(name SystemCLanguage_DIR SYSTEMC_HOME)
  if(NOT ${name} AND DEFINED ENV{${name}})
    set(${name} "$ENV{${name}}" CACHE PATH "An installed SystemC" FORCE)
  endif()
endforeach()

if(SystemCLanguage_DIR)
  set(systemc_origin "SystemCLanguage_DIR=${SystemCLanguage_DIR}")
  find_package(SystemCLanguage CONFIG QUIET NO_DEFAULT_PATH)
else()
  if(SYSTEMC_HOME)
    set(systemc_home "${SYSTEMC_HOME}")
    set(systemc_origin "SYSTEMC_HOME=${SYSTEMC_HOME}")
  else()
    cmake_path(SET systemc_home NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../../build/deps/systemc")
    set(systemc_origin "${systemc_home}")
  endif()
  find_package(SystemCLanguage CONFIG QUIET NO_DEFAULT_PATH PATHS "${systemc_home}")
  unset(SystemCLanguage_DIR CACHE)  # else the next configuration takes it for the user's
endif()

if(NOT TARGET SystemC::systemc AND systemc_home)  # as autotools installs it
  find_path(systemc_include systemc NO_CACHE NO_DEFAULT_PATH PATHS "${systemc_home}/include")
  find_library(systemc_library NAMES libsystemc.a systemc NO_CACHE NO_DEFAULT_PATH
    PATHS "${systemc_home}" PATH_SUFFIXES lib lib64 lib-linux64 lib-linuxaarch64 lib/${CMAKE_LIBRARY_ARCHITECTURE})
  if(systemc_include AND systemc_library)
    find_package(Threads REQUIRED)
    add_library(SystemC::systemc UNKNOWN IMPORTED)
    set_target_properties(SystemC::systemc PROPERTIES
      IMPORTED_LOCATION "${systemc_library}"
      INTERFACE_INCLUDE_DIRECTORIES "${systemc_include}"
      INTERFACE_LINK_LIBRARIES Threads::Threads)
  endif()
endif()

if(NOT TARGET SystemC::systemc)
  message(FATAL_ERROR "No SystemC in ${systemc_origin}. Run scripts/setup, which builds one, or set "
    "SYSTEMC_HOME to an installed SystemC (built for C++${CMAKE_CXX_STANDARD}).")
endif()
message(STATUS "SystemC: ${systemc_origin}")

# A shared SystemC refers to an sc_main, and tests have none.
get_target_property(systemc_type SystemC::systemc TYPE)
if(NOT systemc_type STREQUAL STATIC_LIBRARY)
  target_link_options(SystemC::systemc INTERFACE LINKER:--allow-shlib-undefined)
endif()

# SystemC's symbols carry the C++ standard that it was built with, so try.
if(NOT BLYSK_SYSTEMC_CHECKED STREQUAL systemc_origin)
  include(CheckCXXSourceCompiles)
  unset(BLYSK_SYSTEMC_LINKS CACHE)
  set(CMAKE_REQUIRED_LIBRARIES SystemC::systemc)
  check_cxx_source_compiles("
    #include <systemc>
    int sc_main(int, char**) { sc_core::sc_start(); return 0; }"
    BLYSK_SYSTEMC_LINKS)
  unset(CMAKE_REQUIRED_LIBRARIES)
  if(NOT BLYSK_SYSTEMC_LINKS)
    message(FATAL_ERROR "The SystemC in ${systemc_origin} does not link with a C++${CMAKE_CXX_STANDARD} "
      "program. Build it with CMAKE_CXX_STANDARD=${CMAKE_CXX_STANDARD}, or unset SYSTEMC_HOME and "
      "SystemCLanguage_DIR, delete ${CMAKE_BINARY_DIR}/CMakeCache.txt and run scripts/setup, which builds one.")
  endif()
  set(BLYSK_SYSTEMC_CHECKED "${systemc_origin}" CACHE INTERNAL "")
endif()
set(BlyskSystemC_FOUND TRUE)
