# SPDX-License-Identifier: Apache-2.0
# One figure, as SVG and PNG, from a file of columns:
#   call 'curves.gp' NAME X_LABEL Y_LABEL LOG_AXES COLUMNS
# `data` and `figures` are the directories of NAME.csv and of the pictures.
set datafile separator ';'
set key outside top center horizontal
set grid lc rgb '#bbbbbb' dashtype 3
set xlabel ARG2
set ylabel ARG3
unset logscale
if (strlen(ARG4) > 0) { set logscale @ARG4 }
do for [extension in 'svg png'] {
  if (extension eq 'svg') { set terminal svg size 800,500 font 'sans,14' background '#ffffff'
  } else { set terminal pngcairo size 800,500 font 'sans,11' }
  set output figures.'/'.ARG1.'.'.extension
  plot for [i = 2:int(ARG5)] data.'/'.ARG1.'.csv' using 1:i with lines lw 2 title columnheader(i)
  unset output
}
