# SPDX-License-Identifier: Apache-2.0
# What Gappa could be told of the device computes as the model does: normaliser, barrel shifter and lines. A bound is not proved.
foreach(format q8 q12 q24)
  add_test(NAME certificate.power.${format}.read COMMAND certify compare --device power --format ${format})
  set_tests_properties(certificate.power.${format}.read PROPERTIES LABELS full)
endforeach()
add_test(NAME certificate.power.q8.read.narrow_words COMMAND certify compare --device power --format q8 --fault narrow_words)
set_tests_properties(certificate.power.q8.read.narrow_words PROPERTIES LABELS full WILL_FAIL ON)
