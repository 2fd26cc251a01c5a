# SPDX-License-Identifier: Apache-2.0
# The look that all pictures share; every template loads this file first. Curves differ in dashes and
# lightness as well as in colour, so that a picture printed in grey still tells them apart.
eval "set terminal ".TERMINAL
set output PICTURE
set encoding utf8
set termoption noenhanced

# The background is told by TERMINAL; `paper` is for what covers something.
paper = DARK ? "#16191d" : "#ffffff"
ink = DARK ? "#e8e8e8" : "#000000"
edge_colour = DARK ? "#a4abb3" : "#444444"
axis_colour = DARK ? "#7c848c" : "#777777"
slip_shade = DARK ? "#2d3339" : "#dcdcdc"
open_shade = DARK ? "#4b535c" : "#a8a8a8"
# Where regimes change too fast to be drawn one by one: hatched.
turns_shade = DARK ? "#59616b" : "#c4c4c4"
limit_colour = DARK ? "#ff7a66" : "#c03020"
faint = DARK ? "#7a828a" : "#8a8a8a"
quiet_text = DARK ? "#aab2ba" : "#555555"
# The first is what matters most; the others stand beside it.
array colour[6] = ["#000000", "#1f6fb4", "#e08a00", "#2a8f5b", "#8a4fa3", "#7a7a7a"]
if (DARK) { array colour[6] = ["#e8e8e8", "#6cb2f0", "#f0a030", "#5cc890", "#c592e6", "#9a9a9a"] }
array dashes[6] = [1, 4, 5, 2, 3, 6]
# Of a stack: in grey any two differ by a contrast of 1.5, neighbours by much more.
array stack_colour[6] = ["#2f6ea3", "#f6e7c1", "#4a9a6a", "#1f2d3d", "#e0a84a", "#7a3f1d"]

set border 3 linewidth 1 linecolor rgb edge_colour
set tics nomirror out scale 0.5 textcolor rgb ink font ",12"
# A label that is unset forgets its colour: set it to "" instead.
set xlabel textcolor rgb ink
set ylabel textcolor rgb ink
set y2label textcolor rgb ink
set cblabel textcolor rgb ink
set key textcolor rgb ink

# The span (column 3 to 4) if it is of definition d and of this status.
edge(d, status, value) = column(1) == d && column(2) == status ? value : NaN
# The limit of negative forces: its own where there is one (belts), else the limit's negative.
below(i) = LIMIT_BELOW[i] > 0 ? column(LIMIT_BELOW[i]) : -column(LIMIT[i])
# The number of a column, nothing if the result does not have it.
number(k) = k > 0 ? column(k) : NaN

# Of a plot over time: slip and no contact of definition i, between the heights `low` and `high`.
SHADES = '$SPANS using (0.5 * (edge(i, 2, $3) + $4)):(0.5 * (low + high)):3:4:(low):(high) \
  with boxxyerror fillstyle solid noborder fillcolor rgb slip_shade title (shades_told && SLIPS[i] ? "slip" : ""), \
  $SPANS using (0.5 * (edge(i, 0, $3) + $4)):(0.5 * (low + high)):3:4:(low):(high) \
  with boxxyerror fillstyle solid noborder fillcolor rgb open_shade title (shades_told && OPENS[i] ? "no friction" : ""), \
  $SPANS using (0.5 * (edge(i, 3, $3) + $4)):(0.5 * (low + high)):3:4:(low):(high) \
  with boxxyerror fillstyle transparent pattern 4 noborder fillcolor rgb turns_shade title (shades_told && TURNS[i] ? "stick and slip in turn" : ""), \
  $SPANS using (0.5 * (edge(i, 4, $3) + $4)):(0.5 * (low + high)):3:4:(low):(high) \
  with boxxyerror fillstyle transparent pattern 4 noborder fillcolor rgb open_shade notitle, \
  keyentry with boxes fillstyle empty linecolor rgb "#888888" title (shades_told ? "stick" : "")'
shades_told = 1

# Loop c of n: from light to dark, of one only as dark as text; in a dark picture from dark to light.
mix(from, to, part) = int(from + (to - from) * part + 0.5)
mixed(part) = DARK ? sprintf("#%02x%02x%02x", mix(63, 240, part), mix(95, 246, part), mix(133, 252, part)) \
  : sprintf("#%02x%02x%02x", mix(157, 0, part), mix(199, 16, part), mix(232, 52, part))
shade(c, n) = n > 1 ? mixed((c - 1.0) / (n - 1.0)) : ink
# Of a plot of loops of definition i: all of them, column `up` over column `across`, and the limit of
# the last one if it is asked for.
last_loop(i) = FIRST_LOOP[i] + LOOPS[i] - 1
LOOP_LINES = 'for [c=1:LOOPS[i]] $LOOP_ROWS index (FIRST_LOOP[i] + c - 1) using (number(across)):(column(up)) with lines \
  linewidth (c == LOOPS[i] ? 2.2 : 1.5) linecolor rgb shade(c, LOOPS[i]) title (loops_told ? word(LOOP_NAMES[i], c) : "")'
LOOP_LIMIT = '$LOOP_ROWS index (last_loop(i)) using (number(across)):(with_limit ? column(LIMIT[i]) : NaN) with lines \
  linewidth 2 dashtype 2 linecolor rgb limit_colour title (with_limit && loops_told ? LIMIT_NAME[i] : ""), \
  $LOOP_ROWS index (last_loop(i)) using (number(across)):(with_limit ? below(i) : NaN) with lines \
  linewidth 2 dashtype 2 linecolor rgb limit_colour notitle'
loops_told = 1
# Their names stand to the right of the panels, which end at this part of the width.
loops_end = 0.855
loops_legend = 'set key at screen loops_end + 0.008, screen bottom + 0.83 * height left top vertical Left reverse maxrows 15 samplen 2 width 0 font ",12"'

# Parts of the picture's height: of the title, and of what stands below the axis of a panel.
head = HEAD / HEIGHT
foot = 80.0 / HEIGHT
legend = 'set key at graph 1.0, graph 1.02 bottom right horizontal Left reverse maxrows 2 samplen 2.5 width 0 font ",12"'
set multiplot title TITLE.(TITLE_2 eq "" ? "" : "\n".TITLE_2) font ",17" offset 0,-0.2 textcolor rgb ink
