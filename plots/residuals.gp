# SPDX-License-Identifier: Apache-2.0
# How far a case is from its references: for each check the quantity less the reference over what they
# are compared over, with the tolerance shaded, failing points crossed and the worst point circled.
# `slipbench plot --as residuals` sets the variables and data blocks used here and loads this file.
load STYLE
tolerance_shade = DARK ? "#2d3339" : "#e2e2e2"
set xzeroaxis linewidth 0.8 linecolor rgb axis_colour
in_row = PANELS > 1 ? 2 : 1
rows = (PANELS + in_row - 1) / in_row
height = (1.0 - head) / rows
do for [i=1:PANELS] {
  place = i - 1
  left = 0.095 + (place % in_row) * 0.5
  bottom = 1.0 - head - (place / in_row + 1) * height
  set lmargin at screen left
  set rmargin at screen (in_row == 1 ? 0.97 : left + 0.385)
  set bmargin at screen bottom + foot
  set tmargin at screen bottom + 0.66 * height
  set xrange [FROM[i]:TO[i]]
  set yrange [-HIGH[i]:HIGH[i]]
  set xlabel ABSCISSA[i]
  set ylabel LABEL[i] offset 0.5,0
  set ytics Y_STEP[i]
  set xtics STEP[i]
  set format x FORMAT[i]
  # A heading and what it says, in one or two lines each.
  line = 21.0 / HEIGHT
  heading = bottom + 0.968 * height
  text = heading - (NAME_2[i] eq "" ? 1.15 : 2.15) * line
  set label 1 NAME_1[i] at screen left - 0.06, screen heading left font ",14" textcolor rgb ink
  set label 2 NAME_2[i] at screen left - 0.06, screen heading - line left font ",14" textcolor rgb ink
  set label 3 SAYS_1[i] at screen left - 0.06, screen text left font ",11" textcolor rgb quiet_text
  set label 4 SAYS_2[i] at screen left - 0.06, screen text - 0.85 * line left font ",11" textcolor rgb quiet_text
  edge_of_band = WIDE[i] ? HIGH[i] : TUBE[i]
  set object 1 rectangle from graph 0, first -edge_of_band to graph 1, first edge_of_band behind \
    fillstyle solid noborder fillcolor rgb (TUBE[i] > 0 ? tolerance_shade : paper)
  set key at graph 1.0, graph 1.02 bottom right horizontal Left reverse maxrows 1 samplen 1.5 width 0 font ",11"
  mark = POINTS[i] <= 60 ? 0.5 : 0
  plot \
    keyentry with boxes fillstyle solid noborder fillcolor rgb tolerance_shade \
      title (TUBE[i] > 0 ? sprintf("tolerance %.3g%s", TUBE[i], WIDE[i] ? ", larger than this picture" : "") : ""), \
    $RESIDUALS index (i-1) using 1:2 with linespoints linewidth 1.5 pointtype 7 pointsize mark \
      linecolor rgb ink notitle, \
    $RESIDUALS index (i-1) using 1:($3 > 0 ? $2 : NaN) with points pointtype 2 pointsize 0.8 \
      linecolor rgb limit_colour notitle, \
    "+" every ::::0 using (WORST_AT[i]):(WORST[i]) with points pointtype 6 pointsize 1.8 linewidth 2 \
      linecolor rgb limit_colour title (POINTWISE[i] ? "worst" : "largest residual")
  unset object 1
}
unset multiplot
unset output
