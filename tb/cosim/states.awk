# SPDX-License-Identifier: Apache-2.0
# awk -v module=NAME [-v cut=1] -f states.awk [states.v] DEVICE.il: the design with an instance of `states` in module NAME, on
# the nets that its ports are called after. With cut=1 the registers of all modules ($dff) become ports: NAME_q, what a register
# holds, an input; NAME_d and NAME_clk, what it takes and by which clock, outputs.
function after(name) { sub("^ *connect \\\\" name " ", ""); return $0 }

FILENAME ~ /\.v$/ {
  if (/^ *input /) {
    name = $NF == "," ? $(NF - 1) : $NF
    gsub(/^\\|,$/, "", name)
    instance = instance "    connect \\" name " \\" name "\n"
  }
  next
}
/^module / { is_target = $2 == "\\" module }
cut && /^  cell \$dff / {
  name = $3
  gsub(/[^A-Za-z0-9]/, "_", name)
  is_register = 1
}
is_register {
  if (/^    parameter \\WIDTH/) width = $3
  if (/^    connect \\CLK/) clock = after("CLK")
  else if (/^    connect \\D/) d = after("D")
  else if (/^    connect \\Q/) q = after("Q")
  if (/^  end/) {
    is_register = 0
    printf "  wire width %d input %d \\register%s_q\n", width, ++ports + 10000, name
    printf "  wire width %d output %d \\register%s_d\n", width, ++ports + 10000, name
    printf "  wire output %d \\register%s_clk\n", ++ports + 10000, name
    connections = connections "  connect " q " \\register" name "_q\n  connect \\register" name "_d " d "\n" \
      "  connect \\register" name "_clk " clock "\n"
  }
  next
}
/^end/ {
  printf "%s", connections
  connections = ""
  if (is_target && instance != "") printf "  cell \\states \\states\n%s  end\n", instance
}
{ print }
