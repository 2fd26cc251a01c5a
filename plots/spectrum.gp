# SPDX-License-Identifier: Apache-2.0
# The amplitudes of a column of a result over frequency; the highest peak is told.
# `slipbench plot --as spectrum` sets the variables and data blocks used here and loads this file.
load STYLE
set lmargin at screen 0.11
set rmargin at screen 0.965
set bmargin at screen foot
set tmargin at screen 1.0 - head
set xrange [0:END]
set yrange [0:TOP]
set xtics X_STEP
set xlabel X_LABEL
set ylabel Y_LABEL
unset key
$PEAK_POINT << END
0
END
if (PEAK_AT > 0.6 * END) {
  set label 1 PEAK_NAME at first PEAK_AT, first PEAK right offset -1,0 font ",14" textcolor rgb ink
} else {
  set label 1 PEAK_NAME at first PEAK_AT, first PEAK left offset 1,0 font ",14" textcolor rgb ink
}
plot $POINTS using 1:2 with lines linewidth 1.5 linecolor rgb colour[2], \
  $PEAK_POINT using (PEAK_AT):(PEAK) with points pointtype 6 pointsize 1.2 linewidth 2 linecolor rgb limit_colour
unset multiplot
unset output
