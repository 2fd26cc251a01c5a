# SPDX-License-Identifier: Apache-2.0
# What the normal force is made of over time, a panel for each friction definition: the parts of the
# contact force and the internal one, stacked (negative ones below zero), and F_N, the magnitude of
# their sum.
# `slipbench plot --as shares` sets the variables and data blocks used here and loads this file.
load STYLE
set xzeroaxis linewidth 0.6 linecolor rgb axis_colour
height = (1.0 - head) / DEFINITIONS

do for [i=1:DEFINITIONS] {
  bottom = 1.0 - head - i * height
  set lmargin at screen 0.1
  set rmargin at screen 0.64
  set bmargin at screen bottom + foot
  set tmargin at screen bottom + 0.90 * height
  set xrange [BEGIN:END_TIME]
  set yrange [LOW[i]:HIGH[i]]
  set xlabel TIME_LABEL
  set format x TIME_FORMAT
  set ylabel LABEL[i]
  set label 1 NAME[i] at graph 0.0, graph 1.06 left font ",15" textcolor rgb ink
  set key at graph 1.03, graph 1.0 top left vertical Left reverse maxrows 12 samplen 2 width 0 invert font ",12"
  data = "$SHARES".i
  plot for [k=1:PARTS[i]] data using 1:(column(1 + 2*k)):(column(2 + 2*k)) with filledcurves \
      fillstyle solid border linecolor rgb "#303030" fillcolor rgb stack_colour[k] \
      title word(PART_NAMES[i], k), \
    for [k=1:PARTS[i]] data using 1:(column(2 + 2*k)) with lines linewidth 0.8 linecolor rgb "#303030" notitle, \
    data using 1:2 with lines linewidth 4.5 linecolor rgb paper notitle, \
    data using 1:2 with lines linewidth 2.5 dashtype 2 linecolor rgb ink title "F_N"
}
unset multiplot
unset output
