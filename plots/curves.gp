# SPDX-License-Identifier: Apache-2.0
# Columns of one or several results over another column. Of a single phase portrait the line goes from
# light to dark as time goes on.
# `slipbench plot` with --x and --y, with several inputs, and with --as phase_portrait, sets the
# variables and data blocks used here and loads this file.
load STYLE
set xzeroaxis linewidth 0.6 linecolor rgb axis_colour
set lmargin at screen 0.11
set rmargin at screen (GRADIENT ? 0.86 : 0.70)
set bmargin at screen foot
set tmargin at screen 1.0 - head
set xrange [X_FROM:X_TO]
set yrange [Y_FROM:Y_TO]
set xtics X_STEP
set ytics Y_STEP
set format x X_FORMAT
set format y Y_FORMAT
set xlabel X_LABEL
set ylabel Y_LABEL
set label 1 NOTE at screen 0.965, screen 1.0 - head + 10.0 / HEIGHT right font ",12" textcolor rgb quiet_text
set key at screen 0.71, screen 1.0 - head left top vertical Left reverse maxrows 14 samplen 2.5 width 0 font ",12"
if (GRADIENT) {
  unset key
  set palette defined (0 mixed(0), 0.5 mixed(0.5), 1 mixed(1))
  set cbrange [BEGIN:END_TIME]
  set colorbox user origin 0.89, foot size 0.016, 1.0 - foot - head
  set cbtics scale 0.3 font ",12"
  set cblabel TIME_LABEL offset 0.5,0
  plot $POINTS using 1:2:3 with lines linewidth 1.5 linecolor palette notitle
} else {
  plot for [k=1:CURVES] $POINTS index (k-1) using 1:2 with lines linewidth (k > 6 ? 3.5 : 2) \
    dashtype dashes[(k-1) % 6 + 1] linecolor rgb colour[(k-1) % 6 + 1] title NAME[k]
}
unset multiplot
unset output
