# SPDX-License-Identifier: Apache-2.0
# blysk_device_tests(DEVICE): all tests of a device that need its exported Verilog. What they need to know stands in the
# device's folder tb/devices/<identifier>/:
#   variants       a line of options for each export that the tests try besides
#   verilated      a line of options for each export that engine verilator has besides the presets, written as the engine names
#                  it: those that differ from the presets, in the order in which the device lists them
#   reference.v    module `reference` with parameter F, the same ports, written by hand
#   composed.v     module `composed` with parameter F, the same ports: the blocks of the figure, each with a formula of
#                  composition/; the exported device is proved to be that
#   uncovered.txt  reasons for bits that the regression does not change
#   states.v       module `states` with parameter F: what holds for the registers and the ports of a device with start and
#                  ready; it is proved, and proofs that a mutant is equivalent build on it
#   survivors.txt  reasons for mutants of such a device that are equivalent and not proved to be
#   tests.cmake    sets, where they differ from what stands here:
#     family             specular: the proofs of tb/specular/formal and the errors against c^n hold for it;
#                        pipelined: a device of tb/specular/pipelined.h
#                        iterative: a device of tb/specular/iterative.h; tb/specular/formal/iterative.v is its states.v
#     computes_as        of a pipelined and of an iterative one: the device whose results these are
#     rounds_in_any_way  ON: its model of any word length drops bits in each way of tb/specular/rounding.h
#     changed_reference  a sed command that spoils the inner result of reference.v, for family specular
#     composition_faults NAME SED...: faults in the device's Verilog that the proof of composed.v has to notice
#     protocol           strobes, handshake, or none: nothing is written to it
#     replayed           rows that Icarus repeats, 3000
#     beside             formats whose ports beside the enumerated ones run through all their codes
#     exhaustive         formats whose inputs are all tried
#     stated             formats in which states.v is proved
#     state_faults       NAME SED...: faults in the device's Verilog that the proof of states.v has to notice
#     rows               PROGRAM of tables.cmake that writes further rows for the regression: PROGRAM DEVICE FORMAT FILE.csv
#     covered, mutated   formats whose coverage is counted, whose mutants are tried: of the first 200 in a test
#   tables.cmake   declares programs, targets and tests of tables that only this device has
# Labels: quick takes seconds each, full mostly less than a minute of processor time, long is not in the daily run; stability
# besides for hard cases. `long` and `formats` is what repeats for another format or device what a test without that label
# shows: the formats whose Verilog is not checked in, and mutants of other devices than the first one.

# blysk_label(LABEL TEST...)
function(blysk_label label)
  set_property(TEST ${ARGN} APPEND PROPERTY LABELS ${label})
endfunction()

# blysk_label_checked(LABEL FORMAT TEST...): the label for the checked-in formats, long and formats for the others.
function(blysk_label_checked label format)
  if(format IN_LIST blysk_checked_formats)
    blysk_label(${label} ${ARGN})
  else()
    blysk_label("long;formats" ${ARGN})
  endif()
endfunction()

# blysk_label_ends(FORMAT TEST...): full for the narrowest and the widest format, long and formats between.
function(blysk_label_ends format)
  list(GET blysk_formats 0 first)
  list(GET blysk_formats -1 last)
  if(format STREQUAL first OR format STREQUAL last)
    blysk_label(full ${ARGN})
  else()
    blysk_label("long;formats" ${ARGN})
  endif()
endfunction()

function(blysk_device_tests device)
  string(REPLACE - _ identifier ${device})
  set(own ${PROJECT_SOURCE_DIR}/tb/devices/${identifier})
  set(family "")
  set(changed_reference "")
  set(protocol strobes)
  set(replayed 3000)
  set(beside q8 q12)
  set(exhaustive q8 q10 q12 q14 q16)
  set(covered q8 q12 q16)
  set(mutated q8 q12)
  set(rows "")
  set(state_faults "")
  set(composition_faults "")
  set(stated ${blysk_checked_formats})
  set(states ${own}/states.v)
  include(${own}/tests.cmake OPTIONAL)
  if(family STREQUAL iterative)
    set(states ${PROJECT_SOURCE_DIR}/tb/specular/formal/iterative.v)
    set(state_faults wrong_range "s/left <= DIGITS/left < DIGITS/"
                     changed_hold "s/flag = load_i || step_i/flag = load_i || !step_i/"
                     changed_take "s/else if (we_i)/else/"
                     changed_valid "s/done_o <= left == 7'd1/done_o <= left == 7'd2/")
  endif()
  set(reference ${own}/reference.v)
  set(tables ${PROJECT_SOURCE_DIR}/docs/tables/${identifier})

  # The text: is it current, and do the tools read it?
  set(export ${PROJECT_SOURCE_DIR}/tb/export)
  set(folders "")
  foreach(format IN LISTS blysk_formats)
    blysk_verilog_of(${device} ${format})
    list(APPEND folders ${verilog_folder})
    if(format IN_LIST blysk_checked_formats)
      add_test(NAME verilog.${device}.current.${format}
               COMMAND exported check ${PROJECT_SOURCE_DIR}/rtl_verilog/${identifier}_${format} ${device} ${format})
      blysk_label(quick verilog.${device}.current.${format})
    endif()
    add_test(NAME verilog.${device}.package.${format} COMMAND yosys -q -c ${export}/package.tcl)
    set_tests_properties(verilog.${device}.package.${format} PROPERTIES ENVIRONMENT "EXPORTED=${verilog_folder}")
    add_test(NAME verilog.${device}.lint.${format} COMMAND ${export}/lint.sh ${verilog_folder} verilator icarus yosys)
    blysk_label_checked(quick ${format} verilog.${device}.package.${format} verilog.${device}.lint.${format})
  endforeach()
  # The layout beside the export fits the waves of it.
  blysk_verilog_of(${device} q8)
  add_test(NAME verilog.${device}.layout.icarus COMMAND ${export}/layout.sh $<TARGET_FILE:layout_shows> ${verilog_folder} icarus)
  blysk_label(quick verilog.${device}.layout.icarus)
  list(GET blysk_devices 0 first)
  if(device STREQUAL first)
    add_test(NAME verilog.${device}.layout.verilator
             COMMAND ${export}/layout.sh $<TARGET_FILE:layout_shows> ${verilog_folder} verilator)
    blysk_label(full verilog.${device}.layout.verilator)
  endif()
  # Behind a serial line.
  set(serial ${export}/serial.sh $<TARGET_FILE:blysk> ${device} q8)
  if(protocol STREQUAL strobes)
    add_test(NAME verilog.${device}.serial COMMAND ${serial} simulated)
    if(device STREQUAL first)
      add_test(NAME verilog.${device}.serial.mapped COMMAND ${serial} mapped)
      blysk_label(long verilog.${device}.serial.mapped)
      set_tests_properties(verilog.${device}.serial.mapped PROPERTIES SKIP_RETURN_CODE 77)
    endif()
  else()
    add_test(NAME verilog.${device}.serial COMMAND ${serial} refused)
  endif()
  blysk_label(quick verilog.${device}.serial)
  if(NOT protocol STREQUAL none)
    set(bench ${export}/bench.sh $<TARGET_FILE:blysk> ${verilog_folder} ${device} q8)
    add_test(NAME cosim.${device}.bench.icarus COMMAND ${bench} icarus)
    blysk_label(quick cosim.${device}.bench.icarus)
  endif()
  add_test(NAME verilog.${device}.together COMMAND ${export}/together.sh ${folders})
  add_test(NAME verilog.${device}.core COMMAND ${export}/core.sh ${folders})
  set_tests_properties(verilog.${device}.core PROPERTIES SKIP_RETURN_CODE 77)
  blysk_label(full verilog.${device}.together)
  blysk_label(quick verilog.${device}.core)
  if(EXISTS ${own}/variants)
    foreach(format IN LISTS blysk_formats)
      add_test(NAME verilog.${device}.variants.${format}
               COMMAND ${export}/variants.sh $<TARGET_FILE:exported> ${own}/variants ${device} ${format})
      blysk_label_checked(full ${format} verilog.${device}.variants.${format})
    endforeach()
  endif()

  blysk_verilated_options(${device})
  foreach(options IN LISTS verilated_options)
    blysk_option_words("${options}")
    string(REPLACE _ . suffix "${suffix}")
    foreach(format IN LISTS blysk_formats)
      set(prefix cosim.${device}${suffix})
      add_test(NAME ${prefix}.lockstep.${format} COMMAND lockstep ${device} ${format} all ${words})
      add_test(NAME ${prefix}.random.${format} COMMAND sweep_verilog ${device} ${format} 20000 ${words})
      blysk_label_checked(quick ${format} ${prefix}.lockstep.${format} ${prefix}.random.${format})
    endforeach()
  endforeach()

  # Verilog = SystemC after every edge, and = bit-accurate model for every write.
  foreach(format IN LISTS blysk_formats)
    foreach(which legal all)
      add_test(NAME cosim.${device}.lockstep.${format}.${which} COMMAND lockstep ${device} ${format} ${which})
      blysk_label_checked(quick ${format} cosim.${device}.lockstep.${format}.${which})
    endforeach()
  endforeach()
  if(protocol STREQUAL none)
    return()
  endif()
  add_test(NAME cosim.${device}.engines COMMAND lockstep ${device} q8 engines)
  blysk_label(quick cosim.${device}.engines)
  foreach(format IN LISTS blysk_formats)
    blysk_verilog_of(${device} ${format})
    set(prefix cosim.${device})
    add_test(NAME ${prefix}.random.${format} COMMAND sweep_verilog ${device} ${format} 20000)
    add_test(NAME ${prefix}.icarus.${format}
             COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/replay.sh $<TARGET_FILE:replay_vectors> ${verilog_folder} ${device} ${format})
    set_tests_properties(${prefix}.icarus.${format} PROPERTIES ENVIRONMENT "BLYSK_REPLAYED=${replayed}")
    blysk_label_checked(quick ${format} ${prefix}.random.${format} ${prefix}.icarus.${format})
    # Hard cases: the ends of all codes, legal and not; X before and after the reset.
    add_test(NAME ${prefix}.ends.${format} COMMAND lockstep ${device} ${format} ends)
    blysk_label_checked(quick ${format} ${prefix}.ends.${format})
    blysk_label(stability ${prefix}.ends.${format})
    add_test(NAME ${prefix}.four_state.${format}
             COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/four_state.sh $<TARGET_FILE:replay_vectors> ${verilog_folder} ${device} ${format})
    if(protocol STREQUAL handshake)
      set_tests_properties(${prefix}.four_state.${format} PROPERTIES ENVIRONMENT "BLYSK_REPLAYED=${replayed}")
    endif()
    blysk_label_checked(quick ${format} ${prefix}.four_state.${format})
    blysk_label(stability ${prefix}.four_state.${format})
    # For the page of what is known of each format.
    set(known "${device} ${format}")
    if(format IN_LIST exhaustive)
      string(APPEND known " all")
    endif()
    if(mutated)
      list(GET mutated 0 tried)
      if(format STREQUAL tried)
        string(APPEND known " mutants")
      endif()
    endif()
    if(family STREQUAL specular AND EXISTS ${reference} AND format IN_LIST blysk_checked_formats)
      string(APPEND known " proved range proved hold proved registers proved colours")
      if(format STREQUAL q8)
        string(APPEND known " proved brdf")
      endif()
    elseif(family STREQUAL pipelined AND format IN_LIST blysk_checked_formats)
      string(APPEND known " proved wiring proved stand proved control")
    elseif(EXISTS ${states} AND format IN_LIST stated)
      string(APPEND known " proved states")
    endif()
    if(EXISTS ${own}/composed.v AND format IN_LIST blysk_checked_formats)
      string(APPEND known " proved composition")
    endif()
    set_property(GLOBAL APPEND_STRING PROPERTY blysk_known_of_formats "${known}\n")
    if(format IN_LIST exhaustive)
      add_test(NAME ${prefix}.all.${format} COMMAND sweep_verilog ${device} ${format} all)
      blysk_label(full ${prefix}.all.${format})
    else()
      add_test(NAME ${prefix}.corners.${format} COMMAND sweep_verilog ${device} ${format} corners)
      add_test(NAME ${prefix}.sweep.${format} COMMAND sweep_verilog ${device} ${format} 2000000)
      blysk_label_checked(full ${format} ${prefix}.corners.${format} ${prefix}.sweep.${format})
      add_test(NAME ${prefix}.long_sweep.${format} COMMAND sweep_verilog ${device} ${format} 100000000)
      blysk_label(long ${prefix}.long_sweep.${format})
    endif()
  endforeach()
  foreach(format IN LISTS beside)
    add_test(NAME cosim.${device}.beside.${format} COMMAND sweep_verilog ${device} ${format} beside)
    blysk_label(quick cosim.${device}.beside.${format})
  endforeach()
  blysk_verilog_of(${device} q8)
  add_test(NAME cosim.${device}.icarus.stuck COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/replay.sh $<TARGET_FILE:replay_vectors>
           ${verilog_folder} ${device} q8 stuck)
  set_tests_properties(cosim.${device}.icarus.stuck PROPERTIES ENVIRONMENT "BLYSK_REPLAYED=${replayed}")
  blysk_label(quick cosim.${device}.icarus.stuck)

  # Rows of the device's own.
  if(rows)
    set(files "")
    foreach(format IN LISTS blysk_checked_formats)
      set(file ${CMAKE_CURRENT_BINARY_DIR}/rows_${identifier}_${format}.csv)
      add_custom_command(OUTPUT ${file} COMMAND ${rows} ${device} ${format} ${file} DEPENDS ${rows} VERBATIM)
      list(APPEND files ${file})
      add_test(NAME cosim.${device}.rows.${format} COMMAND sweep_verilog ${device} ${format} ${file})
      blysk_label(quick cosim.${device}.rows.${format})
    endforeach()
    add_custom_target(rows_${identifier} ALL DEPENDS ${files})
  endif()

  # Coverage and mutants.
  set(reasons "")
  set(files ${PROJECT_SOURCE_DIR}/tb/${family}/uncovered.txt ${own}/uncovered.txt)
  if(family MATCHES "^(pipelined|iterative)$")  # the blocks are those of the other device
    string(REPLACE - _ other ${computes_as})
    list(APPEND files ${PROJECT_SOURCE_DIR}/tb/specular/uncovered.txt ${PROJECT_SOURCE_DIR}/tb/devices/${other}/uncovered.txt)
  endif()
  foreach(file IN LISTS files)
    if(EXISTS ${file})
      list(APPEND reasons ${file})
    endif()
  endforeach()
  foreach(format IN LISTS covered)
    set(name coverage_${identifier}_${format})
    blysk_coverage(${name} ${device} ${format})
    set(uncovered ${CMAKE_CURRENT_SOURCE_DIR}/uncovered.sh $<TARGET_FILE:${name}> ${device} ${format})
    set(further "")
    if(rows)
      set(further --rows ${CMAKE_CURRENT_BINARY_DIR}/rows_${identifier}_${format}.csv)
    endif()
    add_test(NAME cosim.${device}.coverage.${format}
             COMMAND ${uncovered} --check ${tables}/coverage_${format}.md ${further} ${reasons})
    blysk_label(full cosim.${device}.coverage.${format})
    add_custom_target(update_${name} COMMAND ${uncovered} --output ${tables}/coverage_${format}.md ${further} ${reasons}
                      USES_TERMINAL VERBATIM)
    add_dependencies(update_${name} ${name})
    if(rows)
      add_dependencies(update_${name} rows_${identifier})
    endif()
    add_dependencies(update_coverage update_${name})
  endforeach()
  set(equivalence --prove ${CMAKE_CURRENT_SOURCE_DIR}/mutants.sh)
  set(arguments_of_mutants "")
  if(EXISTS ${states})
    list(APPEND equivalence --states ${states})
    list(APPEND arguments_of_mutants ${states})
  endif()
  if(EXISTS ${own}/survivors.txt)
    list(APPEND equivalence --reasons ${own}/survivors.txt)
    list(APPEND arguments_of_mutants ${own}/survivors.txt)
  endif()
  if(mutated)
    list(GET mutated 0 format)
    set(name mutation_${identifier}_few)
    blysk_mutants(${name} ${device} ${format} 200)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL OFF)
    set(further "")
    if(rows)
      set(further --rows ${CMAKE_CURRENT_BINARY_DIR}/rows_${identifier}_${format}.csv)
    endif()
    add_test(NAME cosim.${device}.mutation.${format}
             COMMAND ${name} ${device} ${format} ${CMAKE_CURRENT_BINARY_DIR}/${name} ${further} ${equivalence})
    if(device STREQUAL first)
      blysk_label(full cosim.${device}.mutation.${format})
    else()
      blysk_label("long;formats" cosim.${device}.mutation.${format})
    endif()
  endif()
  foreach(format IN LISTS mutated)
    set(name mutation_${identifier}_${format})
    blysk_mutants(${name} ${device} ${format} 1200)
    set(further "")
    if(rows)
      set(further --rows ${CMAKE_CURRENT_BINARY_DIR}/rows_${identifier}_${format}.csv)
    endif()
    # A stamp of its own: what has been tried is not tried again before the Verilog or the regression changes.
    set(stamp ${CMAKE_CURRENT_BINARY_DIR}/${name}/table)
    add_custom_command(OUTPUT ${stamp} USES_TERMINAL VERBATIM
      COMMAND ${CMAKE_COMMAND} -E make_directory ${tables}
      COMMAND ${name} ${device} ${format} ${CMAKE_CURRENT_BINARY_DIR}/${name} ${further} ${equivalence}
              --output ${tables}/mutation_${format}.md
      COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
      DEPENDS ${name} ${arguments_of_mutants})
    add_custom_target(update_${name} DEPENDS ${stamp})
    if(rows)
      add_dependencies(update_${name} rows_${identifier})
    endif()
    if(NOT TARGET update_mutation_${format})
      add_custom_target(update_mutation_${format})
    endif()
    add_dependencies(update_mutation_${format} update_${name})
    add_dependencies(update_mutation update_${name})
  endforeach()

  if(EXISTS ${own}/composed.v)
    blysk_composition_tests(${device})
  endif()
  if(EXISTS ${states})
    blysk_states_tests(${device})
  endif()
  if(family STREQUAL specular)
    blysk_specular_tests(${device})
  elseif(family STREQUAL pipelined)
    blysk_pipelined_tests(${device})
  endif()
  include(${own}/tables.cmake OPTIONAL)
endfunction()

# The blocks are proved to be what composed.v says, and the proof notices faults. Uses the variables of blysk_device_tests().
function(blysk_composition_tests device)
  set(prove ${CMAKE_CURRENT_SOURCE_DIR}/composition/composition.sh)
  foreach(format IN LISTS blysk_checked_formats)
    blysk_verilog_of(${device} ${format})
    add_test(NAME cosim.${device}.formal.${format}.composition COMMAND ${prove} ${verilog_folder} ${own}/composed.v ${format})
    blysk_label(full cosim.${device}.formal.${format}.composition)
  endforeach()
  blysk_verilog_of(${device} q8)
  while(composition_faults)
    list(POP_FRONT composition_faults name fault)
    add_test(NAME cosim.${device}.formal.${name} COMMAND ${prove} ${verilog_folder} ${own}/composed.v q8 ${fault})
    set_tests_properties(cosim.${device}.formal.${name} PROPERTIES PASS_REGULAR_EXPRESSION "proof did fail")
    blysk_label(full cosim.${device}.formal.${name})
  endwhile()
endfunction()

# What a device's states.v, or its family's, says is proved, and the proof notices faults. Uses the variables of blysk_device_tests().
function(blysk_states_tests device)
  set(prove ${CMAKE_CURRENT_SOURCE_DIR}/states.sh)
  foreach(format IN LISTS stated)
    blysk_verilog_of(${device} ${format})
    add_test(NAME cosim.${device}.formal.${format}.states COMMAND ${prove} ${verilog_folder} ${states} ${format})
    blysk_label_ends(${format} cosim.${device}.formal.${format}.states)
  endforeach()
  blysk_verilog_of(${device} q8)
  while(state_faults)
    list(POP_FRONT state_faults name fault)
    add_test(NAME cosim.${device}.formal.${name} COMMAND ${prove} ${verilog_folder} ${states} q8 ${fault})
    set_tests_properties(cosim.${device}.formal.${name} PROPERTIES PASS_REGULAR_EXPRESSION "proof did fail")
    blysk_label(full cosim.${device}.formal.${name})
  endwhile()
endfunction()

# What devices with the registers and colour multipliers of rtl_sysc/devices/specular.h share: proofs, and the errors
# against c^n. Uses the variables of blysk_device_tests().
function(blysk_specular_tests device)
  set(specular ${PROJECT_SOURCE_DIR}/tb/specular)
  if(EXISTS ${reference})
    set(prove ${specular}/formal/formal.sh)
    foreach(format IN LISTS blysk_checked_formats)
      blysk_verilog_of(${device} ${format})
      foreach(property range hold registers colours)
        add_test(NAME cosim.${device}.formal.${format}.${property}
                 COMMAND ${prove} ${verilog_folder} ${reference} ${format} ${property})
        if(format STREQUAL q24 AND property STREQUAL range)
          blysk_label(long cosim.${device}.formal.${format}.${property})
        else()
          blysk_label_ends(${format} cosim.${device}.formal.${format}.${property})
        endif()
      endforeach()
    endforeach()
    blysk_verilog_of(${device} q8)
    # cosim.${device}.all.q8 tries the same inputs.
    add_test(NAME cosim.${device}.formal.q8.brdf COMMAND ${prove} ${verilog_folder} ${reference} q8 brdf)
    blysk_label(long cosim.${device}.formal.q8.brdf)
    # The proof fails if the reference or the property is spoilt.
    set(faults wrong_range range "s/brdf <= ONE/brdf < ONE/"
               wrong_hold hold "s/n == n_before/n == n_i/"
               changed_registers registers "s/if (g_we_i) g_ks/if (r_we_i) g_ks/"
               changed_strobe registers "s/strobe17 & ~cos_we_i/strobe17/"
               changed_colours colours "s/brdf [*] g_ks/brdf + g_ks/")
    if(changed_reference)
      list(APPEND faults changed_brdf brdf "${changed_reference}")
    endif()
    while(faults)
      list(POP_FRONT faults name property fault)
      add_test(NAME cosim.${device}.formal.${name}
               COMMAND ${prove} ${verilog_folder} ${reference} q8 ${property} ${fault})
      set_tests_properties(cosim.${device}.formal.${name} PROPERTIES PASS_REGULAR_EXPRESSION "proof did fail")
      if(property STREQUAL brdf)
        blysk_label(long cosim.${device}.formal.${name})
      else()
        blysk_label(full cosim.${device}.formal.${name})
      endif()
    endwhile()
  endif()

  add_test(NAME docs.${device}.device_errors COMMAND device_errors ${device} --check ${tables})
  blysk_label(full docs.${device}.device_errors)
  add_custom_target(update_errors_${identifier} USES_TERMINAL VERBATIM
    COMMAND ${CMAKE_COMMAND} -E make_directory ${tables}
    COMMAND device_errors ${device} --output ${tables}
    COMMAND gnuplot -c ${specular}/device_errors.gnuplot ${tables}/device_errors.csv
            ${PROJECT_SOURCE_DIR}/docs/figures/device_errors_${identifier}.svg)
  add_dependencies(update_errors update_errors_${identifier})
endfunction()

# What devices of tb/specular/pipelined.h share: proofs of what their registers do. With the test pipeline.DEVICE, that all
# inputs of a block belong to one point, they give equality to the other device for every sequence of inputs.
function(blysk_pipelined_tests device)
  set(prove ${PROJECT_SOURCE_DIR}/tb/specular/formal/pipelined.sh)
  foreach(format IN LISTS blysk_checked_formats)
    blysk_verilog_of(${computes_as} ${format})
    set(other ${verilog_folder})
    blysk_verilog_of(${device} ${format})
    foreach(property wiring stand control)
      add_test(NAME cosim.${device}.formal.${format}.${property} COMMAND ${prove} ${verilog_folder} ${other} ${property})
      blysk_label(full cosim.${device}.formal.${format}.${property})
    endforeach()
  endforeach()
  blysk_verilog_of(${computes_as} q8)
  set(other ${verilog_folder})
  blysk_verilog_of(${device} q8)
  set(faults inverted_colour wiring "s/b_i(g_last)/b_i(~g_last)/" "proof did fail"
             always_loaded stand "s/else if (go_i)/else/" "selection is not empty"
             always_ready control "s/ready_o = (stall_i/ready_o = (start_i/" "proof did fail")
  while(faults)
    list(POP_FRONT faults name property fault says)
    add_test(NAME cosim.${device}.formal.${name} COMMAND ${prove} ${verilog_folder} ${other} ${property} ${fault})
    set_tests_properties(cosim.${device}.formal.${name} PROPERTIES PASS_REGULAR_EXPRESSION "${says}")
    blysk_label(full cosim.${device}.formal.${name})
  endwhile()
endfunction()

# blysk_coverage(NAME DEVICE FORMAT): the program that counts what the regression reaches.
function(blysk_coverage name device format)
  blysk_verilog_of(${device} ${format})
  get_filename_component(folder ${verilog_folder} NAME)
  add_executable(${name})
  blysk_verilate(${name} Vcovered_${folder} ${device} ${format} blysk_${folder} ${verilog_folder} NO_INNER
                 DEPENDS ${verilog_files} ARGUMENTS --coverage)
  blysk_verilated_table(${name} covered ${folder} Vcovered_${folder})
  target_compile_definitions(${name} PRIVATE VM_COVERAGE=1)
  target_precompile_headers(${name} REUSE_FROM blysk_covered_headers)
  target_link_libraries(${name} PRIVATE blysk_coverage blysk_class blysk_strobes blysk_program blysk_options)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
endfunction()

# blysk_mutants(NAME DEVICE FORMAT COUNT): a program that tries COUNT mutants, a multiple of 100, of the exported device on
# the regression. Each hundred is a Verilated class of its own: the time of an evaluation grows with their number.
function(blysk_mutants name device format count)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name})
  set(script ${CMAKE_CURRENT_SOURCE_DIR}/mutants.sh)
  blysk_verilog_of(${device} ${format})
  add_custom_command(OUTPUT ${folder}/list.ys ${folder}/control.txt ${folder}/protocol.txt ${folder}/device.il
                     COMMAND ${script} list ${folder} ${verilog_folder} ${count}
                     DEPENDS ${verilog_files} ${script} VERBATIM)
  add_executable(${name} EXCLUDE_FROM_ALL)
  set(functions "")
  set(entries "")
  foreach(last RANGE 100 ${count} 100)
    math(EXPR first "${last} - 99")
    set(class V${name}_${last})
    add_custom_command(OUTPUT ${folder}/mutants_${last}.v COMMAND ${script} module ${folder} ${first} ${last}
                       DEPENDS ${folder}/list.ys ${folder}/device.il ${script} VERBATIM)
    blysk_verilate(${name} ${class} ${device} ${format} mutants ${folder}/mutants_${last}.v MUTANTS
                   DEPENDS ${folder}/mutants_${last}.v ARGUMENTS -Wno-lint -Wno-UNOPTFLAT)
    string(APPEND functions "std::unique_ptr<mutants> make_${class}();\n")
    string(APPEND entries "make_${class}, ")
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/mutants_table.cpp @ONLY CONTENT [[
// Made by CMake; do not edit.
#include "tb/cosim/mutants.h"

namespace blysk::cosim {

@functions@
std::span<std::unique_ptr<mutants> (*const)()> mutants_table() {
  static constexpr std::unique_ptr<mutants> (*kEntries[])() = {@entries@};
  return kEntries;
}

}  // namespace blysk::cosim
]])
  target_sources(${name} PRIVATE ${folder}/mutants_table.cpp)
  target_precompile_headers(${name} REUSE_FROM blysk_verilated_headers)
  target_link_libraries(${name} PRIVATE blysk_mutation blysk_class blysk_files blysk_strobes blysk_program blysk_options)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
endfunction()
