# SPDX-License-Identifier: Apache-2.0
# A friction result in panels, one row of them for each friction definition: force against time with
# its limit and with stick (white), slip (light) and no contact (dark) shaded; then force against
# motion, or, for motion in a plane, the paths of the motion and of the force.
# `slipbench plot` sets the variables and data blocks used here and loads this file.
eval "set terminal ".TERMINAL
set output PICTURE
set encoding utf8
set termoption noenhanced
set border 3 linewidth 1 linecolor rgb "#444444"
set tics nomirror out scale 0.5 textcolor rgb "#222222" font ",12"
set xzeroaxis linewidth 0.6 linecolor rgb "#777777"

slip_shade = "#dcdcdc"
open_shade = "#a8a8a8"
limit_colour = "#c03020"
array colour[3] = ["#1f6fb4", "#e08a00", "#2a8f5b"]
array dashes[3] = [4, 5, 2]

# The span (column 3 to 4) if it is of definition d and of this status.
edge(d, status, value) = column(1) == d && column(2) == status ? value : NaN
# The limit of negative forces: its own where there is one (belts), else the limit's negative.
below(i) = LIMIT_BELOW[i] > 0 ? column(LIMIT_BELOW[i]) : -column(LIMIT[i])

set multiplot title TITLE font ",17" offset 0,-0.2
head = 60.0 / (60.0 + 440.0 * DEFINITIONS)
height = (1.0 - head) / DEFINITIONS

do for [i=1:DEFINITIONS] {
  bottom = 1.0 - head - i * height
  low = SIGNED[i] ? -1.15 * TOP[i] : -0.04 * TOP[i]
  high = 1.15 * TOP[i]
  wide = PLANAR[i] ? 0.40 : 0.56

  # Force against time.
  set size noratio
  set lmargin at screen 0.075
  set rmargin at screen wide
  set bmargin at screen bottom + 0.15 * height
  set tmargin at screen bottom + 0.87 * height
  set xrange [BEGIN:END_TIME]
  set yrange [low:high]
  set xlabel TIME_LABEL
  set ylabel FORCE_LABEL[i]
  set label 1 NAME[i] at graph 0.0, graph 1.13 left font ",15"
  set key at graph 1.0, graph 1.02 bottom right horizontal Left reverse maxrows 2 samplen 1.5 width 0 font ",12"
  plot \
    $SPANS using (0.5 * (edge(i, 2, $3) + $4)):(0.5 * (low + high)):3:4:(low):(high) \
      with boxxyerror fillstyle solid noborder fillcolor rgb slip_shade title (SLIPS[i] ? "slip" : ""), \
    $SPANS using (0.5 * (edge(i, 0, $3) + $4)):(0.5 * (low + high)):3:4:(low):(high) \
      with boxxyerror fillstyle solid noborder fillcolor rgb open_shade title (OPENS[i] ? "no contact" : ""), \
    keyentry with boxes fillstyle empty linecolor rgb "#888888" title "stick", \
    for [k=1:words(BESIDE[i])] $DATA using 1:(column(int(word(BESIDE[i], k)))) with lines \
      linewidth 1.5 dashtype dashes[k] linecolor rgb colour[k] title word(BESIDE_NAMES[i], k), \
    $DATA using 1:(column(FORCE[i])) with lines linewidth 2 linecolor rgb "black" title FORCE_NAME[i], \
    $DATA using 1:(LIMIT[i] > 0 ? column(LIMIT[i]) : NaN) with lines linewidth 2 dashtype 2 \
      linecolor rgb limit_colour title (LIMIT[i] > 0 ? "limit" : ""), \
    $DATA using 1:(LIMIT[i] > 0 && SIGNED[i] ? below(i) : NaN) with lines linewidth 2 \
      dashtype 2 linecolor rgb limit_colour notitle
  unset label 1
  unset lmargin; unset rmargin; unset tmargin; unset bmargin

  if (PLANAR[i]) {
    # The path of the motion.
    set key at graph 0.5, graph 1.02 bottom center
    set size ratio -1 0.29, 0.92 * height
    set origin 0.42, bottom + 0.02 * height
    set xrange [*:*]
    set yrange [*:*]
    set xlabel MOTION_X_LABEL[i]
    set ylabel MOTION_Y_LABEL[i]
    set xtics MOTION_X_STEP[i]
    set ytics MOTION_Y_STEP[i]
    set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
    plot $DATA using (column(MOTION_X[i])):(column(MOTION_Y[i])) with lines linewidth 2 \
      linecolor rgb "black" title "path of the motion"
    set offsets 0, 0, 0, 0
    # The path of the force within its limit.
    set origin 0.71, bottom + 0.02 * height
    set size ratio -1 0.29, 0.92 * height
    set parametric
    set trange [0:2*pi]
    set xrange [-1.15 * TOP[i]:1.15 * TOP[i]]
    set yrange [-1.15 * TOP[i]:1.15 * TOP[i]]
    set xlabel FORCE_X_LABEL[i]
    set ylabel FORCE_Y_LABEL[i]
    set xtics FORCE_STEP[i]
    set ytics FORCE_STEP[i]
    plot $DATA using (column(FORCE_X[i])):(column(FORCE_Y[i])) with lines linewidth 2 \
        linecolor rgb "black" title "force", \
      LIMIT_AXIS_1[i] * cos(t) * DIRECTION_X[i] - LIMIT_AXIS_2[i] * sin(t) * DIRECTION_Y[i], \
      LIMIT_AXIS_1[i] * cos(t) * DIRECTION_Y[i] + LIMIT_AXIS_2[i] * sin(t) * DIRECTION_X[i] \
        with lines linewidth 2 dashtype 2 \
        linecolor rgb limit_colour title "largest limit"
    set xtics autofreq
    set ytics autofreq
    unset parametric
  } else { if (MOTION_X[i] > 0) {
    # Force against motion.
    set lmargin at screen 0.66
    set rmargin at screen 0.98
    set bmargin at screen bottom + 0.15 * height
    set tmargin at screen bottom + 0.87 * height
    set xrange [*:*]
    set yrange [*:*]
    if (LIMIT_IN_LOOP[i]) { set yrange [-1.15 * TOP[i]:1.15 * TOP[i]] }
    set offsets graph 0.04, graph 0.04, 0, 0
    set xlabel MOTION_X_LABEL[i]
    set ylabel FORCE_X_LABEL[i]
    set xtics MOTION_X_STEP[i]
    plot \
      $DATA using (column(MOTION_X[i])):(column(FORCE_X[i])) with lines linewidth 2 \
        linecolor rgb "black" title "force", \
      $DATA using (column(MOTION_X[i])):(LIMIT_IN_LOOP[i] ? column(LIMIT[i]) : NaN) with lines \
        linewidth 2 dashtype 2 linecolor rgb limit_colour title (LIMIT_IN_LOOP[i] ? "limit" : ""), \
      $DATA using (column(MOTION_X[i])):(LIMIT_IN_LOOP[i] ? below(i) : NaN) with lines \
        linewidth 2 dashtype 2 linecolor rgb limit_colour notitle
    set offsets 0, 0, 0, 0
    set xtics autofreq
    unset lmargin; unset rmargin; unset tmargin; unset bmargin
  } }
}
unset multiplot
unset output
