# SPDX-License-Identifier: Apache-2.0
# blysk_golden: the reference functions on real numbers. They share no code with rtl_sysc. Boost's headers are all they need.
set(golden ${PROJECT_SOURCE_DIR}/tb/golden)
add_library(blysk_golden STATIC ${golden}/angle.cpp ${golden}/errors.cpp ${golden}/hard_forms.cpp ${golden}/lobe.cpp
            ${golden}/reflectance.cpp ${golden}/registry.cpp ${golden}/sphere.cpp ${golden}/teapot.cpp)
add_library(blysk::golden ALIAS blysk_golden)
set_target_properties(blysk_golden PROPERTIES EXPORT_NAME golden)
target_include_directories(blysk_golden PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                               $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/blysk>)
target_compile_features(blysk_golden PUBLIC cxx_std_20)
if(NOT TARGET Boost::headers)
  find_package(Boost REQUIRED CONFIG)
endif()
target_link_libraries(blysk_golden PUBLIC Boost::headers)
# No contraction, here and where the templates are used: with a fused multiply-add results would depend on the
# processor, and the error bounds count every rounding.
target_compile_options(blysk_golden PUBLIC -ffp-contract=off)
# No errno and no traps, or the comparisons at a lobe's root could not become vector selects.
set_source_files_properties(${golden}/lobe.cpp TARGET_DIRECTORY blysk_golden
                            PROPERTIES COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math")
