# SPDX-License-Identifier: Apache-2.0
# A friction result in panels, one row of them for each friction definition: force against time with
# its limit and with stick (white), slip (light) and no friction (dark) shaded; then force against
# motion, or, for motion in a plane, the paths of the motion and of the force. Of many cycles some are
# drawn, whole, from light to dark.
# `slipbench plot` sets the variables and data blocks used here and loads this file.
load STYLE
set xzeroaxis linewidth 0.6 linecolor rgb axis_colour
height = (1.0 - head) / DEFINITIONS
set label 5 NOTE at screen 0.965, screen 1.0 - head + 12.0 / HEIGHT right font ",12" textcolor rgb quiet_text

do for [i=1:DEFINITIONS] {
  bottom = 1.0 - head - i * height
  low = SIGNED[i] ? -1.15 * TOP[i] : -0.04 * TOP[i]
  high = 1.15 * TOP[i]
  wide = PLANAR[i] ? 0.36 : 0.51
  stays = STILL_X[i] && (!PLANAR[i] || STILL_Y[i])

  # Force against time.
  set size noratio
  set lmargin at screen 0.11
  set rmargin at screen wide
  set bmargin at screen bottom + foot
  set tmargin at screen bottom + 0.83 * height
  set xrange [BEGIN:END_TIME]
  set yrange [low:high]
  set xlabel TIME_LABEL
  set xtics TIME_STEP
  set format x TIME_FORMAT
  set ylabel FORCE_LABEL[i]
  set label 1 NAME[i] at screen 0.11, screen bottom + 0.965 * height left font ",15" textcolor rgb ink
  @legend
  if (PLANAR[i]) { set key maxrows 3 }
  plot \
    @SHADES, \
    for [k=1:words(BESIDE[i])] $DATA using 1:(column(int(word(BESIDE[i], k)))) with lines \
      linewidth 1.5 dashtype dashes[k+1] linecolor rgb colour[k+1] title word(BESIDE_NAMES[i], k), \
    $DATA using 1:(column(FORCE[i])) with lines linewidth 2 linecolor rgb ink title FORCE_NAME[i], \
    $DATA using 1:(LIMIT[i] > 0 ? column(LIMIT[i]) : NaN) with lines linewidth 2 dashtype 2 \
      linecolor rgb limit_colour title (LIMIT[i] > 0 ? "limit" : ""), \
    $DATA using 1:(LIMIT[i] > 0 && SIGNED[i] ? below(i) : NaN) with lines linewidth 2 \
      dashtype 2 linecolor rgb limit_colour notitle
  unset label 1
  unset label 5
  set format x "% h"
  set xtics autofreq
  unset lmargin; unset rmargin; unset tmargin; unset bmargin
  @loops_legend

  if (PLANAR[i]) {
    # The path of the motion.
    loops_told = 0
    set size ratio -1 0.245, 0.88 * height
    set origin 0.37, bottom + 0.01 * height
    if (MOVES_X[i]) { set xrange [*:*] } else { set xrange [PLACE_X[i]-1:PLACE_X[i]+1] }
    if (MOVES_Y[i]) { set yrange [*:*] } else { set yrange [PLACE_Y[i]-1:PLACE_Y[i]+1] }
    set xlabel MOTION_X_LABEL[i]
    set ylabel MOTION_Y_LABEL[i]
    set xtics MOTION_X_STEP[i]
    set ytics MOTION_Y_STEP[i]
    set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
    set format x MOTION_X_FORMAT[i]
    set format y MOTION_Y_FORMAT[i]
    across = MOTION_X[i]
    up = MOTION_Y[i]
    plot @LOOP_LINES, \
      $DATA every ::0::0 using (stays ? column(across) : NaN):(column(up)) with points \
        pointtype 7 linecolor rgb ink notitle
    set format x "% h"
    set format y "% h"
    set offsets 0, 0, 0, 0
    # The path of the force within its limit.
    loops_told = 1
    set origin 0.615, bottom + 0.01 * height
    set size ratio -1 0.245, 0.88 * height
    set parametric
    set trange [0:2*pi]
    set xrange [-1.15 * TOP[i]:1.15 * TOP[i]]
    set yrange [-1.15 * TOP[i]:1.15 * TOP[i]]
    set xlabel FORCE_X_LABEL[i]
    set ylabel FORCE_Y_LABEL[i]
    set xtics FORCE_STEP[i]
    set ytics FORCE_STEP[i]
    across = FORCE_X[i]
    up = FORCE_Y[i]
    plot @LOOP_LINES, \
      $DATA every ::0::0 using (stays ? column(across) : NaN):(column(up)) with points \
        pointtype 7 linecolor rgb ink notitle, \
      LIMIT_AXIS_1[i] * cos(t) * DIRECTION_X[i] - LIMIT_AXIS_2[i] * sin(t) * DIRECTION_Y[i], \
      LIMIT_AXIS_1[i] * cos(t) * DIRECTION_Y[i] + LIMIT_AXIS_2[i] * sin(t) * DIRECTION_X[i] \
        with lines linewidth 2 dashtype 2 \
        linecolor rgb limit_colour title "largest limit"
    set xtics autofreq
    set ytics autofreq
    unset parametric
  } else { if (MOTION_X[i] > 0) {
    # Force against motion.
    set lmargin at screen 0.60
    set rmargin at screen loops_end
    set bmargin at screen bottom + foot
    set tmargin at screen bottom + 0.83 * height
    if (MOVES_X[i]) { set xrange [*:*] } else { set xrange [PLACE_X[i]-1:PLACE_X[i]+1] }
    set yrange [*:*]
    if (LIMIT_IN_LOOP[i]) { set yrange [-1.15 * TOP[i]:1.15 * TOP[i]] }
    set offsets graph 0.04, graph 0.04, 0, 0
    set xlabel MOTION_X_LABEL[i]
    set ylabel FORCE_X_LABEL[i]
    set xtics MOTION_X_STEP[i]
    set format x MOTION_X_FORMAT[i]
    across = MOTION_X[i]
    up = FORCE_X[i]
    with_limit = LIMIT_IN_LOOP[i]
    plot @LOOP_LINES, @LOOP_LIMIT, \
      $DATA every ::0::0 using (stays ? column(across) : NaN):(column(up)) with points \
        pointtype 7 linecolor rgb ink notitle, \
      $DATA every ::0::0 using (stays && with_limit ? column(across) : NaN):(column(LIMIT[i])) \
        with points pointtype 1 linecolor rgb limit_colour notitle, \
      $DATA every ::0::0 using (stays && with_limit ? column(across) : NaN):(below(i)) \
        with points pointtype 1 linecolor rgb limit_colour notitle
    set format x "% h"
    set offsets 0, 0, 0, 0
    set xtics autofreq
    unset lmargin; unset rmargin; unset tmargin; unset bmargin
  } }
}
unset multiplot
unset output
