# SPDX-License-Identifier: Apache-2.0
# awk -v module=NAME [-v cut=1] -f states.awk [states.v] DEVICE.il: the design with an instance of `states` in module NAME, on
# the nets that its ports are called after. With cut=1 the registers of all modules ($dff) become ports: NAME_q, what a register
# holds, an input; NAME_d and NAME_clk, what it takes and by which clock, outputs. Multipliers ($mul) do the same: what a
# solver cannot do with two of them, it can if their factors have to be equal.
function after(name) { return substr($0, index($0, name " ") + length(name) + 1) }

FILENAME ~ /\.v$/ {
  if (/^ *input /) {
    name = $NF == "," ? $(NF - 1) : $NF
    gsub(/^\\|,$/, "", name)
    instance = instance "    connect \\" name " \\" name "\n"
  }
  next
}
/^module / { is_target = $2 == "\\" module }
# input_for SIGNAL WIDTH NAME, output_of: the signal as a port.
function input_for(signal, width, name) {
  printf "  wire width %d input %d \\cut%s\n", width, ++ports + 10000, name
  connections = connections "  connect " signal " \\cut" name "\n"
}
function output_of(signal, width, name) {
  printf "  wire width %d output %d \\cut%s\n", width, ++ports + 10000, name
  connections = connections "  connect \\cut" name " " signal "\n"
}
cut && /^  cell \$(dff|mul) / {
  kind = $2
  name = $3
  gsub(/[^A-Za-z0-9]/, "_", name)
  is_cut = 1
}
is_cut {
  if (/^    parameter /) width[$2] = $3
  if (/^    connect /) signal[$2] = after($2)
  if (/^  end/) {
    is_cut = 0
    if (kind == "$dff") {
      input_for(signal["\\Q"], width["\\WIDTH"], name "_q")
      output_of(signal["\\D"], width["\\WIDTH"], name "_d")
      output_of(signal["\\CLK"], 1, name "_clk")
    } else {
      input_for(signal["\\Y"], width["\\Y_WIDTH"], name "_y")
      output_of(signal["\\A"], width["\\A_WIDTH"], name "_a")
      output_of(signal["\\B"], width["\\B_WIDTH"], name "_b")
    }
  }
  next
}
/^end/ {
  printf "%s", connections
  connections = ""
  if (is_target && instance != "") printf "  cell \\states \\states\n%s  end\n", instance
}
{ print }
