# SPDX-License-Identifier: Apache-2.0
# gnuplot -c device_errors.gnuplot device_errors.csv device_errors.svg
# Five measures of the device against c^n over the exponent, a curve for each format, thinner ones on top, as those of the
# wide formats coincide. A relative error is 0 where c = 1 is
# the only code of the epicentre; a logarithmic axis shows that as its lowest line.
set terminal svg size 1200,760 font 'sans,13' background '#ffffff'
set output ARG2
set datafile separator ','
set logscale xy
set xrange [1:1000]
set xlabel 'specular exponent n'
set grid lc rgb '#999999' lw 0.5
unset key
formats = 'q8 q10 q12 q14 q16 q18 q20 q22 q24'
set palette defined (0 '#d73027', 3 '#fdae61', 4 '#66bd63', 6 '#4393c3', 8 '#542788')
set cbrange [0:8]
unset colorbox

zero = 1e-4
curve(f) = sprintf("< grep '^%s,' '%s'", f, ARG1)
set multiplot layout 2,3
set title 'largest absolute error'
set ylabel 'max |BRDF - c^n|, dimensionless'
plot for [i = 9:1:-1] curve(word(formats, i)) using 2:3 with linespoints lw 0.8 + i / 2.5 pt 7 ps 0.4 lc palette cb i - 1
set title 'root mean square error'
set ylabel 'rms of BRDF - c^n, dimensionless'
plot for [i = 9:1:-1] curve(word(formats, i)) using 2:11 with linespoints lw 0.8 + i / 2.5 pt 7 ps 0.4 lc palette cb i - 1

# The sixth place is the key's.
set title ' '
set key center center spacing 1.6 samplen 5 title 'format of the cosine'
unset border; unset tics; unset grid; unset xlabel; unset ylabel
set yrange [1:2]
plot for [i = 1:9] NaN with linespoints lw 0.8 + i / 2.5 pt 7 ps 0.4 lc palette cb i - 1 title word(formats, i)
unset key
set border; set tics; set grid lc rgb '#999999' lw 0.5
set xlabel 'specular exponent n'

set yrange [zero:1]
set ytics add ('0' zero)
titles = "'epicentre c^n ≥ 0.6' 'epicentre c^n ≥ 0.56' 'epicentre up to the inflection'"
do for [e = 1:3] {
  set title word(titles, e)
  set ylabel 'max |BRDF - c^n| / c^n, dimensionless'
  plot for [i = 9:1:-1] curve(word(formats, i)) using 2:(column(4 + e) > 0 ? column(4 + e) : zero) \
    with linespoints lw 0.8 + i / 2.5 pt 7 ps 0.4 lc palette cb i - 1
}
unset multiplot
