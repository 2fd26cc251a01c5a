# SPDX-License-Identifier: Apache-2.0
# Loops of a friction result, one row of panels for each friction definition: force against motion
# for each component that moves, or, for motion in a plane, the paths of the motion and of the force.
# Of a cyclic motion the cycles 1, 2, 5, 10 and so on and the last are drawn, whole, from light to
# dark; the dissipated energy stands above.
# `slipbench plot --as hysteresis` sets the variables and data blocks used here and loads this file.
load STYLE
set xzeroaxis linewidth 0.6 linecolor rgb axis_colour
set yzeroaxis linewidth 0.6 linecolor rgb axis_colour
height = (1.0 - head) / DEFINITIONS

# A panel's left and right end, of `n` panels in a row.
left(n, p) = 0.11 + (p - 1) * (loops_end - 0.11) / n + (p - 1) * 0.05 / n
right(n, p) = p == n ? loops_end : left(n, p + 1) - 0.085

array force[3]
array force_label[3]
array low[3]
array high[3]
array from[3]
array to[3]
array has_limit[3]
array motion[3]
array motion_label[3]
array motion_step[3]
array motion_format[3]
array still[3]
set label 5 NOTE at screen 0.965, screen 1.0 - head + 10.0 / HEIGHT right font ",12" textcolor rgb quiet_text

do for [i=1:DEFINITIONS] {
  bottom = 1.0 - head - i * height
  force[1] = FORCE_1[i]; force[2] = FORCE_2[i]; force[3] = FORCE_3[i]
  force_label[1] = FORCE_1_LABEL[i]; force_label[2] = FORCE_2_LABEL[i]; force_label[3] = FORCE_3_LABEL[i]
  low[1] = FORCE_1_LOW[i]; low[2] = FORCE_2_LOW[i]; low[3] = FORCE_3_LOW[i]
  high[1] = FORCE_1_HIGH[i]; high[2] = FORCE_2_HIGH[i]; high[3] = FORCE_3_HIGH[i]
  from[1] = MOTION_1_FROM[i]; from[2] = MOTION_2_FROM[i]; from[3] = MOTION_3_FROM[i]
  to[1] = MOTION_1_TO[i]; to[2] = MOTION_2_TO[i]; to[3] = MOTION_3_TO[i]
  has_limit[1] = FORCE_1_LIMIT[i]; has_limit[2] = FORCE_2_LIMIT[i]; has_limit[3] = FORCE_3_LIMIT[i]
  motion[1] = MOTION_1[i]; motion[2] = MOTION_2[i]; motion[3] = MOTION_3[i]
  motion_label[1] = MOTION_1_LABEL[i]; motion_label[2] = MOTION_2_LABEL[i]; motion_label[3] = MOTION_3_LABEL[i]
  motion_step[1] = MOTION_1_STEP[i]; motion_step[2] = MOTION_2_STEP[i]; motion_step[3] = MOTION_3_STEP[i]
  motion_format[1] = MOTION_1_FORMAT[i]; motion_format[2] = MOTION_2_FORMAT[i]; motion_format[3] = MOTION_3_FORMAT[i]
  still[1] = STILL_1[i]; still[2] = STILL_2[i]; still[3] = STILL_3[i]
  set label 1 NAME[i] at screen 0.11, screen bottom + 0.95 * height left font ",15" textcolor rgb ink
  set label 2 ENERGY[i] at screen 0.965, screen bottom + 0.95 * height right font ",12" textcolor rgb quiet_text

  @loops_legend

  if (PLANAR[i]) {
    stays = still[1] && still[2]
    loops_told = 0
    set bmargin; set tmargin; set lmargin; set rmargin
    set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
    set origin 0.04, bottom + 0.01 * height
    set size ratio -1 0.41, 0.88 * height
    set xrange [*:*]
    set yrange [*:*]
    set xlabel motion_label[1]
    set ylabel motion_label[2]
    set xtics motion_step[1]
    set ytics motion_step[2]
    set format x motion_format[1]
    set format y motion_format[2]
    across = motion[1]
    up = motion[2]
    plot @LOOP_LINES, \
      $DATA every ::0::0 using (stays ? column(across) : NaN):(column(up)) with points pointtype 7 \
        linecolor rgb ink notitle
    set offsets 0, 0, 0, 0
    set format x "% h"
    set format y "% h"
    unset label 1
    unset label 2
    unset label 5
    loops_told = 1
    set origin 0.45, bottom + 0.01 * height
    set size ratio -1 0.41, 0.88 * height
    set parametric
    set trange [0:2*pi]
    set xrange [-1.15 * TOP[i]:1.15 * TOP[i]]
    set yrange [-1.15 * TOP[i]:1.15 * TOP[i]]
    set xlabel force_label[1]
    set ylabel force_label[2]
    set xtics FORCE_STEP[i]
    set ytics FORCE_STEP[i]
    across = force[1]
    up = force[2]
    plot \
      LIMIT_AXIS_1[i] * cos(t) * DIRECTION_X[i] - LIMIT_AXIS_2[i] * sin(t) * DIRECTION_Y[i], \
      LIMIT_AXIS_1[i] * cos(t) * DIRECTION_Y[i] + LIMIT_AXIS_2[i] * sin(t) * DIRECTION_X[i] \
        with lines linewidth 2 dashtype 2 linecolor rgb limit_colour title "largest limit", \
      @LOOP_LINES, \
      $DATA every ::0::0 using (stays ? column(across) : NaN):(column(up)) with points pointtype 7 \
        linecolor rgb ink notitle
    unset parametric
    set xtics autofreq
    set ytics autofreq
    set size noratio
  } else {
    do for [p=1:PANELS[i]] {
      loops_told = p == 1
      set lmargin at screen left(PANELS[i], p)
      set rmargin at screen right(PANELS[i], p)
      set bmargin at screen bottom + foot
      set tmargin at screen bottom + 0.86 * height
      set xrange [from[p]:to[p]]
      set yrange [low[p]:high[p]]
      set xlabel motion_label[p]
      set ylabel force_label[p]
      set xtics motion_step[p]
      set format x motion_format[p]
      set label 6 (still[p] ? "neither the motion nor the force changes" : "") at graph 0.5, graph 0.75 center \
        font ",12" textcolor rgb quiet_text
      across = motion[p]
      up = force[p]
      with_limit = has_limit[p]
      plot @LOOP_LIMIT, @LOOP_LINES, \
        $DATA every ::0::0 using (still[p] && with_limit ? number(across) : NaN):(column(LIMIT[i])) \
          with points pointtype 1 linecolor rgb limit_colour notitle, \
        $DATA every ::0::0 using (still[p] && with_limit ? number(across) : NaN):(below(i)) \
          with points pointtype 1 linecolor rgb limit_colour notitle, \
        $DATA every ::0::0 using (still[p] ? number(across) : NaN):(column(up)) with points pointtype 7 \
          linecolor rgb ink notitle
      set xtics autofreq
      set format x "% h"
      unset label 1
      unset label 2
      unset label 5
      unset label 6
    }
    loops_told = 1
    unset lmargin; unset rmargin; unset tmargin; unset bmargin
  }
}
unset multiplot
unset output
