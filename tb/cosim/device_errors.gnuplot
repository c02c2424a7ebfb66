# SPDX-License-Identifier: Apache-2.0
# gnuplot -c errors.gnuplot errors.csv errors.svg
set terminal svg size 900,420 noenhanced
set output ARG2
set datafile separator ','
set logscale xy
set xlabel 'specular exponent n'
set key outside right
set grid
set multiplot layout 1,2
set title 'max |BRDF - c^n|'
plot for [f in 'q8 q10 q12 q14 q16 q24'] sprintf("< grep '^%s,' %s", f, ARG1) using 2:3 with linespoints title f
set title 'max relative error, c^n >= 0.6'
plot for [f in 'q8 q10 q12 q14 q16 q24'] sprintf("< grep '^%s,' %s", f, ARG1) using 2:4 with linespoints title f
unset multiplot
