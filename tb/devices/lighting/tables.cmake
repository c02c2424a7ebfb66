# SPDX-License-Identifier: Apache-2.0
# Proofs of the exported unit, and that they fail if the reference or the property is spoilt.
set(prove ${own}/formal.sh)
foreach(format IN LISTS blysk_checked_formats)
  blysk_verilog_of(${device} ${format})
  foreach(property equal range stand)
    add_test(NAME cosim.${device}.formal.${format}.${property} COMMAND ${prove} ${verilog_folder} ${reference} ${format} ${property})
    blysk_label(full cosim.${device}.formal.${format}.${property})
  endforeach()
  set_property(GLOBAL APPEND_STRING PROPERTY blysk_known_of_formats "${device} ${format} proved equal\n")
endforeach()
blysk_verilog_of(${device} q8)
set(faults wrong_most equal "s/MOST = 255/MOST = 254/"
           wrong_first equal "s/first_i ? ambient/!first_i ? ambient/"
           wrong_half equal "s/24'h8000/24'h7fff/"
           wrong_range range "s/<= MOST/< MOST/"
           wrong_stand stand "s/stands <= rst_n && valid_o/stands <= rst_n/")
while(faults)
  list(POP_FRONT faults name property fault)
  add_test(NAME cosim.${device}.formal.${name} COMMAND ${prove} ${verilog_folder} ${reference} q8 ${property} ${fault})
  set_tests_properties(cosim.${device}.formal.${name} PROPERTIES PASS_REGULAR_EXPRESSION "proof did fail")
  blysk_label(full cosim.${device}.formal.${name})
endwhile()
