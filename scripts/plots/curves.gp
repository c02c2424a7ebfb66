# SPDX-License-Identifier: Apache-2.0
# One figure, as SVG and PNG, from a file of columns:
#   call 'curves.gp' NAME TITLE X_LABEL Y_LABEL LOG_AXES Y_RANGE STYLE COLUMNS
# `data` and `figures` are the directories of NAME.csv and of the pictures.
set datafile separator ';'
set datafile missing 'nan'
set key outside top center horizontal
set grid lc rgb '#c8c8c8' lw 1 dashtype 1
set title ARG2 font ',12'
set xlabel ARG3
set ylabel ARG4
unset logscale
set format '%h'
if (strlen(ARG5) > 0) { set logscale @ARG5 }
if (ARG5 eq 'y' || ARG5 eq 'xy') { set format y '10^{%L}' }
set yrange @ARG6
do for [extension in 'svg png'] {
  if (extension eq 'svg') { set terminal svg size 800,500 font 'sans,14' background '#ffffff'
  } else { set terminal pngcairo size 800,500 font 'sans,11' }
  set output figures.'/'.ARG1.'.'.extension
  plot for [i = 2:int(ARG8)] data.'/'.ARG1.'.csv' using 1:i with @ARG7 title columnheader(i)
  unset output
}
