# SPDX-License-Identifier: Apache-2.0
# What Gappa could be told of the device computes as the model does: normaliser, barrel shifter and lines. A bound is not proved.
foreach(fault none narrow_words)
  set(name certificate.power.q8.read.${fault})
  add_test(NAME ${name} COMMAND certify compare --device power --format q8 --fault ${fault})
  set_tests_properties(${name} PROPERTIES LABELS full)
endforeach()
set_tests_properties(${name} PROPERTIES WILL_FAIL ON)
