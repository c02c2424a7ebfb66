# SPDX-License-Identifier: Apache-2.0
# blysk_specular_unit_tests(DEVICE): "strobe.DEVICE.FORMAT: ...", the strobes of [P] fig. 3 on a device of the specular
# family, in the narrowest and in the widest format; "bound.DEVICE.FORMAT: ...", the error bound of a device that derives
# one (has_bound) at every input; "stability.DEVICE.FORMAT: ...", hard cases, of label stability besides.
function(blysk_specular_unit_tests device)
  list(GET blysk_formats 0 first)
  list(GET blysk_formats -1 last)
  blysk_cases(strobe specular_cases ${device} FORMATS ${first} ${last} QUICK ${first} ${last}
              SOURCES ${PROJECT_SOURCE_DIR}/tb/specular/test/strobe_test.cpp)
  if(has_bound)
    # 65 million inputs in q16, ten seconds a line of `variants`.
    set(checked ${blysk_checked_formats})
    set(blysk_checked_formats q8 q12)
    blysk_cases(bound bound_cases ${device} FORMATS q8 q10 q12 q14 q16 QUICK q8
                SOURCES ${PROJECT_SOURCE_DIR}/tb/specular/test/bound_test.cpp)
    set(blysk_checked_formats ${checked})
    blysk_cases(stability bound_cases ${device} FORMATS ${blysk_formats} QUICK ${first} LABEL stability
                SOURCES ${PROJECT_SOURCE_DIR}/tb/specular/test/hard_cases_test.cpp)
  endif()
endfunction()
