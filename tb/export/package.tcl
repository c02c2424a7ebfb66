# SPDX-License-Identifier: Apache-2.0
# What stands beside the Verilog in the directory EXPORTED names its files and ports, no more and no fewer. Runs in the
# Tcl of Yosys: EXPORTED=rtl_verilog/quadratic_q8 yosys -q -c package.tcl
set folder $env(EXPORTED)
set top blysk_[file tail $folder]

proc text {name} {
  set file [open $::folder/$name]
  set content [read $file]
  close $file
  return $content
}
proc expect {what got wanted} {
  if {[lsort $got] ne [lsort $wanted]} {
    puts stderr "$::folder, $what: got [lsort $got], expected [lsort $wanted]"
    exit 1
  }
}

# The list and the FuseSoC description: all modules, all files.
set modules [glob -directory $folder -tails *.v]
set benches [glob -nocomplain -directory $folder -tails *.vt]
expect "$top.f" [split [string trim [text $top.f]] \n] $modules
set files {}
foreach line [split [text $top.core] \n] {
  if {[regexp {^      - (\S+)$} $line -> name]} {lappend files $name}
  if {[regexp {^ *toplevel: (.*)$} $line -> name]} {lappend tops $name}
}
set bench_tops {}
foreach bench $benches {lappend bench_tops [file rootname $bench]}
expect "$top.core, toplevels" [lsort -unique $tops] [concat $top $bench_tops]
# What a core that depends on this one gets: modules, no clock of ours.
regexp {\n  default:\n    filesets: \[([^\n]*)\]\n} [text $top.core] -> filesets
foreach fileset [split $filesets ,] {
  if {[string match {*is_toplevel\? (*)*} $fileset]} continue
  expect "$top.core, target default for dependants" [string trim $fileset] rtl
}
regexp -line {^name: (.*)$} [text $top.core] -> name
if {![regexp "^blysk:devices:$top:\\d+\\.\\d+\\.\\d+\$" $name]} {expect "$top.core, name" $name "blysk:devices:$top:VERSION"}

expect "$top.core, first line" [lindex [split [text $top.core] \n] 0] CAPI=2:
expect "$top.core" $files [concat $modules $benches $top.sdc]
expect folder [glob -directory $folder -tails *] [concat $modules $benches $top.f $top.core $top.sdc $top.gtkw]

# The constraints, sourced with commands that write down the ports.
foreach direction {input output} {
  set ports($direction) {}
  foreach {- name} [regexp -all -inline -line "^    $direction +(?:wire|reg) +(?:signed +)?(?:\\\[\\d+:0\\] +)?(\\w+)" [text $top.v]] {
    lappend ports($direction) $name
  }
}
proc get_ports {names} {return $names}
proc create_clock {args} {
  expect clock $args "-name clk -period $::clk_period clk"
  set ::clock [lindex $args end]
}
proc set_input_delay {delay option clock names} {
  expect "input delay" [list $option $clock] "-clock $::clock"
  set ::constrained(input) $names
}
proc set_output_delay {delay option clock names} {
  expect "output delay" [list $option $clock] "-clock $::clock"
  set ::constrained(output) $names
}
proc set_multicycle_path {cycles edge option names} {
  expect "multicycle path" [list $cycles $option] [list [expr {$edge eq "-setup" ? $::strobe_gap : $::strobe_gap - 1}] -to]
  set ::cycles($edge) $names
}
source $folder/$top.sdc
expect "$top.sdc, inputs" [concat $clock $constrained(input)] $ports(input)
expect "$top.sdc, outputs" $constrained(output) $ports(output)
# Results are what is sampled with a strobe at one.
if {[info exists strobe_gap]} {
  foreach edge {-setup -hold} {expect "$top.sdc, results" [concat $cycles($edge) valid_o] $ports(output)}
}
