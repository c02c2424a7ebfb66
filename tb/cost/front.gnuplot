# SPDX-License-Identifier: Apache-2.0
# gnuplot -c front.gnuplot ROWS.csv OUTPUT.svg|.png METRIC DOMAIN: the error of each device and format over four costs;
# ROWS.csv is what `blysk explore --csv` prints. A dashed line leads along each panel's front.
if (ARG2[strlen(ARG2) - 3:] eq '.png') {
  set terminal pngcairo size 1200,860 font 'sans,11' background '#ffffff'
} else {
  set terminal svg size 1200,860 font 'sans,13' background '#ffffff'
}
set output ARG2
set datafile separator ','
metric = ARG3
set logscale xy
set grid lc rgb '#dddddd' lw 0.5
set ylabel metric . ', ' . ARG4 noenhanced
unset key

# "DEVICE OPTIONS" of the rows, each once; a blank as '+'.
row = 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next } $at["domain"] == "' . ARG4 . '"'
name = 'n = $at["device"] ($at["options"] == "" ? "" : "+" $at["options"])'
names = system("awk -F, '" . row . " { " . name . "; if (!(n in seen)) { seen[n] = 1; print n } }' '" . ARG1 . "'")
host(engine) = 'match($at["host"], /' . engine . '=s_per_million=[0-9.e+-]*/) ? substr($at["host"], RSTART + ' \
  . (strlen(engine) + 15) . ', RLENGTH - ' . (strlen(engine) + 15) . ') : 0'
points(which, cost) = "< awk -F, '" . row . ' { ' . name . '; x = ' . cost . '; y = $at["' . metric . '"]; y = y < 0 ? -y : y; ' \
  . 'if (n == "' . which . '" && x > 0 && y > 0) print x "," y "," $at["format"] }' . "' '" . ARG1 . "'"
front(cost) = "< awk -F, '" . row . ' { x = ' . cost . '; y = $at["' . metric . '"]; y = y < 0 ? -y : y; ' \
  . 'if (x > 0 && y > 0) print x "," y }' . "' '" . ARG1 . "' | sort -t, -g -k1,1 -k2,2 | awk -F, 'NR == 1 || $2 < best { best = $2; print }'"
colour(i) = word("#1f77b4 #d95f02 #1b9e77 #7570b3 #e7298a #66a61e #a6761d #444444", 1 + (i - 1) % 8)

set multiplot layout 2,2
do for [panel = 1:4] {
  cost = word('$at["lut"] 1e9/$at["results_per_s_asic"] $at["area_nand2"] HOST', panel)
  if (panel == 2) { cost = '($at["results_per_s_asic"] > 0 ? 1e9 / $at["results_per_s_asic"] : 0)' }
  if (panel == 4) { cost = host('bit') }
  set xlabel word("iCE40:_LUT OSU018:_ns_a_result OSU018:_area_in_NAND2 host:_s_a_million_results,_engine_bit", panel) noenhanced
  if (panel == 1) { set key top right noenhanced samplen 1 } else { unset key }
  plot front(cost) using 1:2 with steps lc rgb '#999999' dt 2 lw 1.5 notitle, \
    for [i = 1:words(names)] points(word(names, i), cost) using 1:2 with points pt 7 ps 0.9 lc rgb colour(i) title word(names, i), \
    for [i = 1:words(names)] points(word(names, i), cost) using 1:2:3 with labels offset 1.6,0.6 font ',9' tc rgb '#555555' notitle
}
unset multiplot
