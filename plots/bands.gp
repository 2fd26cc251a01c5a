# SPDX-License-Identifier: Apache-2.0
# When what slips: a band over time for each friction definition, with stick (white), slip (grey), no
# contact (dark, hatched) and where they take turns too fast to be drawn (light, hatched), and its
# changes marked: those to slip above, the others below.
# `slipbench plot --as bands` sets the variables and data blocks used here and loads this file.
load STYLE
slip_band = DARK ? "#6d757e" : "#9a9a9a"
open_band = DARK ? "#c8ced4" : "#202020"
set lmargin at screen 0.05
set rmargin at screen 0.98
set bmargin at screen foot
set tmargin at screen 1.0 - head - 25.0 / HEIGHT
set border 1
unset ytics
set xrange [BEGIN:END_TIME]
set yrange [-DEFINITIONS:0]
set xlabel TIME_LABEL
set format x TIME_FORMAT
set key at screen 0.98, screen 1.0 - head - 2.0 / HEIGHT right center horizontal Left reverse maxrows 1 samplen 1.5 width 1 font ",12"

# A row reaches from -row to 1 - row; its band lies between these two.
base(row) = -row + 0.20
top(row) = -row + 0.58
mark(status, value) = column(2) == status ? value : NaN

do for [i=1:DEFINITIONS] {
  set label i NAME[i] at graph 0.0, first top(i) + 0.30 left font ",14" textcolor rgb ink
  set label DEFINITIONS+i FACTS[i] at graph 1.0, first top(i) + 0.30 right font ",12" textcolor rgb quiet_text
  set object i rectangle from graph 0, first base(i) to graph 1, first top(i) behind \
    fillstyle solid border linecolor rgb edge_colour fillcolor rgb paper
  set object DEFINITIONS+i rectangle from graph 0, first base(i) to graph 1, first top(i) front \
    fillstyle empty border linecolor rgb edge_colour
}
plot \
  keyentry with boxes fillstyle empty linecolor rgb edge_colour title "stick", \
  $SPANS using (0.5 * (edge($1, 2, $3) + $4)):(0.5 * (base($1) + top($1))):3:4:(base($1)):(top($1)) \
    with boxxyerror fillstyle solid noborder fillcolor rgb slip_band title "slip", \
  $SPANS using (0.5 * (edge($1, 0, $3) + $4)):(0.5 * (base($1) + top($1))):3:4:(base($1)):(top($1)) \
    with boxxyerror fillstyle pattern 5 border linecolor rgb open_band fillcolor rgb open_band title (OPENS ? "no friction" : ""), \
  $SPANS using (0.5 * (edge($1, 3, $3) + $4)):(0.5 * (base($1) + top($1))):3:4:(base($1)):(top($1)) \
    with boxxyerror fillstyle pattern 4 noborder fillcolor rgb slip_band title (TURNS ? "in turn" : ""), \
  $SPANS using (0.5 * (edge($1, 4, $3) + $4)):(0.5 * (base($1) + top($1))):3:4:(base($1)):(top($1)) \
    with boxxyerror fillstyle pattern 4 noborder fillcolor rgb open_band notitle, \
  $MARKS using (mark(2, $3)):(top($1) + 0.10) with points pointtype 11 pointsize 1 \
    linecolor rgb ink title "slips from here", \
  $MARKS using (mark(3, $3)):(top($1) + 0.10) with points pointtype 12 pointsize 1 \
    linewidth 1.4 linecolor rgb ink title (TURNS_BACK ? "slip turns" : ""), \
  $MARKS using (mark(1, $3)):(base($1) - 0.09) with points pointtype 8 pointsize 1 linewidth 1.4 \
    linecolor rgb ink title "sticks from here", \
  $MARKS using (mark(0, $3)):(base($1) - 0.09) with points pointtype 2 pointsize 1 linewidth 1.4 \
    linecolor rgb ink title (OPENS ? "no friction from here" : "")
unset multiplot
unset output
