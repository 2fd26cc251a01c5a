# SPDX-License-Identifier: Apache-2.0
# A coefficient of friction as a map over two of its arguments, a panel for each coefficient, with
# contours at the marks of its scale, the points of its table and the states that the run visited.
# `slipbench plot --as mu_map` sets the variables and data blocks used here and loads this file.
load STYLE
# From light to dark without a turn, so that it says the same in grey.
set palette defined (0 "#fdf7d8", 0.25 "#f6cf80", 0.5 "#dd8c5f", 0.75 "#9c4868", 1 "#3b1d52")
state(status, value) = column(1) == status ? value : NaN
height = (1.0 - head) / MAPS

do for [i=1:MAPS] {
  bottom = 1.0 - head - i * height
  # The contours first, as a block of lines.
  set contour base
  set cntrparam levels incremental MU_FIRST[i], MU_STEP[i], MU_HIGH[i]
  unset surface
  set table $CONTOURS
  set xrange [X_FROM[i]:X_TO[i]]
  set yrange [Y_FROM[i]:Y_TO[i]]
  splot $MAP index (i-1) using 1:2:3
  unset table
  unset contour
  set surface

  set lmargin at screen 0.09
  set rmargin at screen 0.87
  set bmargin at screen bottom + foot
  set tmargin at screen bottom + 0.84 * height
  set label 1 NAME[i] at screen 0.09, screen bottom + 0.96 * height left font ",15" textcolor rgb ink
  set label 2 NOTE[i] at screen 0.98, screen bottom + 0.96 * height right font ",12" textcolor rgb quiet_text
  set key at graph 0.0, graph 1.02 bottom left horizontal Left reverse maxrows 1 samplen 1.5 width 1 font ",12"
  set xlabel X_LABEL[i]
  set ylabel Y_LABEL[i]
  set xtics X_STEP[i]
  set ytics Y_STEP[i]
  set cbrange [MU_LOW[i]:MU_HIGH[i]]
  set colorbox user origin 0.89, bottom + foot size 0.018, 0.70 * height
  set cbtics MU_STEP[i] scale 0.3 font ",12"
  set cblabel "coefficient mu" offset 0.5,0
  plot \
    $MAP index (i-1) using 1:2:3 with image notitle, \
    $CONTOURS using 1:2 with lines linewidth 1 linecolor rgb "#404040" notitle, \
    $POINTS index (i-1) using 1:2 with points pointtype 1 pointsize 0.9 linewidth 1.6 linecolor rgb "#1060a0" \
      title (TABLE[i] ? "point of the table" : ""), \
    $STATES index (i-1) using 2:(state(1, $3)) with points pointtype 5 pointsize 0.9 linecolor rgb "black" notitle, \
    $STATES index (i-1) using 2:(state(1, $3)) with points pointtype 5 pointsize 0.5 linecolor rgb "#888888" notitle, \
    $STATES index (i-1) using 2:(state(2, $3)) with points pointtype 7 pointsize 0.9 linecolor rgb "black" notitle, \
    $STATES index (i-1) using 2:(state(2, $3)) with points pointtype 7 pointsize 0.6 linecolor rgb "white" notitle, \
    keyentry with points pointtype 4 pointsize 0.8 linewidth 1.2 linecolor rgb ink \
      title (STICKS[i] ? STICK_NAME[i] : ""), \
    keyentry with points pointtype 6 pointsize 0.8 linewidth 1.2 linecolor rgb ink \
      title (SLIPS[i] ? "visited in slip" : "")
  unset colorbox
}
unset multiplot
unset output
