# SPDX-License-Identifier: Apache-2.0
# An experiment of a fit: measured points, the model at the start values (light) and at the optimum (strong); of
# each compared quantity the loop over the position, if it has one, and the history.
# `slipbench calibrate` sets the variables and data blocks used here and loads this file.
load STYLE
set xzeroaxis linewidth 0.6 linecolor rgb axis_colour
height = (1.0 - head) / PANELS
set label 9 NOTE at screen 0.98, screen 1.0 - 50.0 / HEIGHT right font ",11" textcolor rgb quiet_text
do for [i=1:PANELS] {
  bottom = 1.0 - head - i * height
  set bmargin at screen bottom + foot
  set tmargin at screen bottom + 0.78 * height
  set yrange [LOW[i]:HIGH[i]]
  set ytics Y_STEP[i]
  line = 21.0 / HEIGHT
  set label 1 NAME[i] at screen 0.03, screen bottom + 0.96 * height left font ",14" textcolor rgb ink
  set label 2 SAYS[i] at screen 0.03, screen bottom + 0.96 * height - line left font ",12" textcolor rgb quiet_text
  set key at screen 0.98, screen bottom + 0.80 * height bottom right horizontal Left reverse maxrows 1 samplen 2.5 width 1 font ",12"
  if (LOOP[i]) {
    set lmargin at screen 0.09
    set rmargin at screen 0.47
    set xrange [FROM[i]:TO[i]]
    set xtics X_STEP[i]
    set format x X_FORMAT[i]
    set xlabel X_LABEL[i]
    set ylabel LABEL[i] offset 0.5,0
    plot \
      $POINTS index (i-1) using 2:4 with lines linewidth 1 dashtype 2 linecolor rgb faint notitle, \
      $POINTS index (i-1) using 2:3 with points pointtype 7 pointsize POINT_SIZE[i] linecolor rgb colour[3] notitle, \
      $POINTS index (i-1) using 2:5 with lines linewidth 2 linecolor rgb colour[1] notitle
    unset label 1
    unset label 2
    unset label 9
    set lmargin at screen 0.57
  } else {
    set lmargin at screen 0.09
  }
  set rmargin at screen 0.97
  set xrange [BEGIN[i]:END[i]]
  set xtics T_STEP[i]
  set format x T_FORMAT[i]
  set xlabel TIME_LABEL
  set ylabel LABEL[i] offset 0.5,0
  plot \
    $POINTS index (i-1) using 1:4 with lines linewidth 1 dashtype 2 linecolor rgb faint title "before", \
    $POINTS index (i-1) using 1:3 with points pointtype 7 pointsize POINT_SIZE[i] linecolor rgb colour[3] notitle, \
    $POINTS index (i-1) using 1:5 with lines linewidth 2 linecolor rgb colour[1] title "after", \
    keyentry with points pointtype 7 pointsize 0.7 linecolor rgb colour[3] title "measured"
  unset label 1
  unset label 2
  unset label 9
}
unset multiplot
unset output
