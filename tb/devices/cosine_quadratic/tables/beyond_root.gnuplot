# SPDX-License-Identifier: Apache-2.0
# gnuplot -c beyond_root.gnuplot beyond_root.csv beyond_root.svg
# Left: the lobe of n = 10, gated by the sign of adder 8 and by comparator 11. Right: the largest BRDF that comparator 11 lets
# through beyond the root, over the exponent.
set terminal svg size 1200,460 font 'sans,13' background '#ffffff'
set output ARG2
set datafile separator ','
set key top center
set grid lc rgb '#999999' lw 0.5
set multiplot layout 1,2
set title 'n = 10'
set xlabel 'cos(gamma)'
set ylabel 'BRDF, dimensionless'
set xrange [0:1]
set yrange [0:8]
plot ARG1 index 0 using 1:4 every ::1 with lines lw 2 lc rgb '#d73027' title 'comparator 11, as published', \
     ARG1 index 0 using 1:2 every ::1 with lines lw 2 lc rgb '#999999' title 'cos^n', \
     ARG1 index 0 using 1:3 every ::1 with lines lw 2 lc rgb '#4393c3' title 'sign of adder 8'
set title 'beyond the root'
set xlabel 'specular exponent n'
set ylabel 'largest BRDF that comparator 11 passes'
set logscale xy
set xrange [1:1000]
set yrange [0.1:1e6]
unset key
plot ARG1 index 1 using 1:($2 > 0 ? $2 : NaN) every ::1 with linespoints pt 7 ps 0.5 lw 2 lc rgb '#d73027'
unset multiplot
