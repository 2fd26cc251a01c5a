# SPDX-License-Identifier: Apache-2.0
# The look that all pictures share; every template loads this file first. Curves differ in dashes and
# lightness as well as in colour, so that a picture printed in grey still tells them apart.
eval "set terminal ".TERMINAL
set output PICTURE
set encoding utf8
set termoption noenhanced
set border 3 linewidth 1 linecolor rgb "#444444"
set tics nomirror out scale 0.5 textcolor rgb "#222222" font ",12"

slip_shade = "#dcdcdc"
open_shade = "#a8a8a8"
limit_colour = "#c03020"
faint = "#8a8a8a"
quiet_text = "#555555"
# The first is what matters most; the others stand beside it.
array colour[6] = ["#000000", "#1f6fb4", "#e08a00", "#2a8f5b", "#8a4fa3", "#7a7a7a"]
array dashes[6] = [1, 4, 5, 2, 3, 6]
# Neighbours in a stack, far apart in lightness.
array stack_colour[6] = ["#2f5f8f", "#f2c879", "#7fae8d", "#5a3d5c", "#d9d9d9", "#b5654a"]

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
  with boxxyerror fillstyle solid noborder fillcolor rgb open_shade title (shades_told && OPENS[i] ? "no contact" : ""), \
  keyentry with boxes fillstyle empty linecolor rgb "#888888" title (shades_told ? "stick" : "")'
shades_told = 1

head = 60.0 / HEIGHT
legend = 'set key at graph 1.0, graph 1.02 bottom right horizontal Left reverse maxrows 2 samplen 2.5 width 0 font ",12"'
set multiplot title TITLE font ",17" offset 0,-0.2
