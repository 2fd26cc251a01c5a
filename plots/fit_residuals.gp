# SPDX-License-Identifier: Apache-2.0
# What a fit leaves of an experiment: model minus measurement over time, and how often, with the curve of noise of the
# same deviation. Noise has no shape over time; a trend is something that the model does not have.
# `slipbench calibrate` sets the variables and data blocks used here and loads this file.
load STYLE
set xzeroaxis linewidth 0.8 linecolor rgb axis_colour
height = (1.0 - head) / PANELS
set label 9 NOTE at screen 0.98, screen 1.0 - 50.0 / HEIGHT right font ",11" textcolor rgb quiet_text
bell(x, i) = DEVIATION[i] > 0 ? TOTAL[i] * WIDTH[i] * exp(-0.5 * ((x - MEAN[i]) / DEVIATION[i])**2) / (DEVIATION[i] * sqrt(2 * pi)) : NaN
set samples 400
do for [i=1:PANELS] {
  bottom = 1.0 - head - i * height
  set bmargin at screen bottom + foot
  set tmargin at screen bottom + 0.74 * height
  line = 19.0 / HEIGHT
  set label 1 NAME[i] at screen 0.03, screen bottom + 0.96 * height left font ",14" textcolor rgb ink
  set label 2 SAYS_1[i] at screen 0.03, screen bottom + 0.96 * height - 1.1 * line left font ",12" textcolor rgb quiet_text
  set label 3 SAYS_2[i] at screen 0.03, screen bottom + 0.96 * height - 2.0 * line left font ",12" textcolor rgb quiet_text
  set lmargin at screen 0.09
  set rmargin at screen 0.62
  set xrange [BEGIN[i]:END[i]]
  set yrange [-HIGH[i]:HIGH[i]]
  set xtics T_STEP[i]
  set ytics Y_STEP[i]
  set format x T_FORMAT[i]
  set xlabel TIME_LABEL
  set ylabel LABEL[i] offset 0.5,0
  # Points of no size are shapes that some programs cannot draw.
  if (POINT_SIZE[i] > 0) {
    plot $RESIDUALS index (i-1) using 1:2 with linespoints linewidth 1 pointtype 7 pointsize POINT_SIZE[i] \
      linecolor rgb ink notitle
  } else {
    plot $RESIDUALS index (i-1) using 1:2 with lines linewidth 1 linecolor rgb ink notitle
  }
  unset label 1
  unset label 2
  unset label 3
  unset label 9
  set lmargin at screen 0.70
  set rmargin at screen 0.97
  set xrange [-HIGH[i]:HIGH[i]]
  set yrange [0:TOP[i]]
  set xtics Y_STEP[i]
  set ytics COUNT_STEP[i]
  set format x "% h"
  set xlabel LABEL[i]
  set ylabel "points" offset 0.5,0
  set key at graph 1.0, graph 1.02 bottom right horizontal Left reverse maxrows 1 samplen 2.5 font ",12"
  plot \
    $BINS index (i-1) using 1:2:(WIDTH[i]) with boxes fillcolor rgb (DARK ? "#34506b" : "#c3d7ea") fillstyle solid border linecolor rgb colour[2] notitle, \
    bell(x, i) with lines linewidth 2 dashtype 2 linecolor rgb colour[3] title (DEVIATION[i] > 0 ? "noise of this deviation" : "")
}
unset multiplot
unset output
