# SPDX-License-Identifier: Apache-2.0
# gnuplot -c front.gnuplot ROWS.csv OUTPUT.svg|.png METRIC DOMAIN: the error of each device and format over four costs;
# ROWS.csv is what `blysk explore --csv` prints. A colour is a device, with whatever options, a shape a format. A dashed line leads
# along each panel's front.
if (ARG2[strlen(ARG2) - 3:] eq '.png') {
  set terminal pngcairo size 1400,860 font 'sans,11' background '#ffffff'
} else {
  set terminal svg size 1400,860 font 'sans,13' background '#ffffff'
}
set output ARG2
set datafile separator ','
metric = ARG3
set logscale y
set grid lc rgb '#dddddd' lw 0.5
set ylabel metric . ', ' . ARG4 noenhanced
unset key

# The devices and the formats of the rows that have an error, each once.
row = 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next } $at["domain"] == "' . ARG4 . '" && $at["status"] != ""'
each_once(key) = system("awk -F, '" . row . ' && $at["' . key . '"] != "" { if (!($at["' . key . '"] in seen)) { seen[$at["' . key \
  . '"]] = 1; print $at["' . key . '"] } }' . "' '" . ARG1 . "' | sort -V")
names = each_once('device')
formats = each_once('format')
host(engine) = 'match($at["host"], /' . engine . '=s_per_million=[0-9.e+-]*/) ? substr($at["host"], RSTART + ' \
  . (strlen(engine) + 15) . ', RLENGTH - ' . (strlen(engine) + 15) . ') : 0'
points(which, cost) = "< awk -F, '" . row . ' { x = ' . cost . '; y = $at["' . metric . '"]; y = y < 0 ? -y : y; ' \
  . 'if ($at["device"] == "' . which . '" && x > 0 && y > 0) print x "," y "," $at["format"] }' . "' '" . ARG1 . "'"
front(cost) = "< awk -F, '" . row . ' { x = ' . cost . '; y = $at["' . metric . '"]; y = y < 0 ? -y : y; ' \
  . 'if (x > 0 && y > 0) print x "," y }' . "' '" . ARG1 . "' | sort -t, -g -k1,1 -k2,2 | awk -F, 'NR == 1 || $2 < best { best = $2; print }'"
# As many as there are devices with an error, and some more.
palette = "#1f77b4 #d95f02 #1b9e77 #7570b3 #e7298a #66a61e #a6761d #444444 #17becf #d62728 #bcbd22 #8c564b " \
  . "#ffb000 #0000a8 #ff9da7 #006d2c #b8b8b8 #c77cff"
colour(i) = word(palette, 1 + (i - 1) % words(palette))
shape(format) = int(word("7 5 9 11 13 15 6 4 8", int((format[2:] - 8) / 2) + 1))

label(panel) = panel == 1 ? 'iCE40: LUT' : panel == 2 ? 'OSU018: ns a result' : panel == 3 ? 'OSU018: area in NAND2' \
  : 'host: s a million results, engine bit'
cost(panel) = panel == 1 ? '$at["lut"]' : panel == 2 ? '($at["results_per_s_asic"] > 0 ? 1e9 / $at["results_per_s_asic"] : 0)' \
  : panel == 3 ? '$at["area_nand2"]' : host('bit')
set autoscale noextend
set offsets graph 0.06, graph 0.06, graph 0.1, graph 0.1
set format xy '%g'
# What is close together needs no logarithm.
spread = real(system("awk -F, '" . row . ' { y = $at["' . metric . '"]; y = y < 0 ? -y : y; if (y > 0) { if (!low || y < low) low = y; ' \
  . 'if (y > high) high = y } } END { print low ? high / low : 1 }' . "' '" . ARG1 . "'"))
if (spread < 5) {
  unset logscale y
} else {
  set ytics 1e-12, 10
  do for [e = -9:1] { do for [m in '1 2 5'] { set ytics add (10.0**e * m) } }
}

# The legend: gnuplot's own leaves out what is longer than one panel.
legend_y(line) = 0.96 - 0.028 * line
do for [i = 1:words(names)] {
  set label i word(names, i) at screen 0.855, legend_y(i - 1) left offset 1, 0 noenhanced point pt 7 ps 1.1 lc rgb colour(i)
}
do for [i = 1:words(formats)] {
  line = words(names) + i
  set label line word(formats, i) at screen 0.855, legend_y(line) left offset 1, 0 noenhanced \
    point pt shape(word(formats, i)) ps 1.1 lc rgb '#777777'
}

set multiplot layout 2,2 margins 0.075, 0.83, 0.08, 0.97 spacing 0.08, 0.12
do for [panel = 1:4] {
  set xlabel label(panel) noenhanced
  if (panel == 2) { unset label }
  if (words(system(front(cost(panel))[2:])) == 0) {
    set title label(panel) . ': not measured' noenhanced
    plot [1:10] [1:10] NaN notitle
    set title
  } else {
    plot front(cost(panel)) using 1:2 with steps lc rgb '#999999' dt 2 lw 1.5 notitle, \
      for [i = 1:words(names)] points(word(names, i), cost(panel)) using 1:2:(shape(strcol(3))) with points pt variable ps 1.1 \
        lc rgb colour(i) notitle
  }
}
unset multiplot
