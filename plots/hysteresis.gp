# SPDX-License-Identifier: Apache-2.0
# Loops of a friction result, one row of panels for each friction definition: force against motion
# for each component that moves, or, for motion in a plane, the paths of the motion and of the force.
# The last full cycle is heavy, what was before it is light; the dissipated energy stands above. Of a
# long run the cycle has all of its rows; of the rest some are drawn, as points: between two of them
# there may be many cycles.
# `slipbench plot --as hysteresis` sets the variables and data blocks used here and loads this file.
load STYLE
set xzeroaxis linewidth 0.6 linecolor rgb axis_colour
set yzeroaxis linewidth 0.6 linecolor rgb axis_colour
height = (1.0 - head) / DEFINITIONS

# A panel's left and right end, of `n` panels in a row.
left(n, p) = 0.11 + (p - 1) * 0.9 / n
right(n, p) = n == 1 ? 0.78 : left(n, p) + 0.9 / n - 0.11

array force[3]
array force_label[3]
array low[3]
array high[3]
array from[3]
array to[3]
array with_limit[3]
array motion[3]
array motion_label[3]
array motion_step[3]

array motion_format[3]
array still[3]
rest = THINNED ? "with points pointtype 7 pointsize 0.25" : "with lines"
limit_of_all = THINNED ? "with points pointtype 7 pointsize 0.25" : "with lines linewidth 2 dashtype 2"
set label 5 NOTE at screen 0.08, screen 1.0 - 50.0 / HEIGHT left font ",12" textcolor rgb quiet_text

do for [i=1:DEFINITIONS] {
  bottom = 1.0 - head - i * height
  force[1] = FORCE_1[i]; force[2] = FORCE_2[i]; force[3] = FORCE_3[i]
  force_label[1] = FORCE_1_LABEL[i]; force_label[2] = FORCE_2_LABEL[i]; force_label[3] = FORCE_3_LABEL[i]
  low[1] = FORCE_1_LOW[i]; low[2] = FORCE_2_LOW[i]; low[3] = FORCE_3_LOW[i]
  high[1] = FORCE_1_HIGH[i]; high[2] = FORCE_2_HIGH[i]; high[3] = FORCE_3_HIGH[i]
  from[1] = MOTION_1_FROM[i]; from[2] = MOTION_2_FROM[i]; from[3] = MOTION_3_FROM[i]
  to[1] = MOTION_1_TO[i]; to[2] = MOTION_2_TO[i]; to[3] = MOTION_3_TO[i]
  with_limit[1] = FORCE_1_LIMIT[i]; with_limit[2] = FORCE_2_LIMIT[i]; with_limit[3] = FORCE_3_LIMIT[i]
  motion[1] = MOTION_1[i]; motion[2] = MOTION_2[i]; motion[3] = MOTION_3[i]
  motion_label[1] = MOTION_1_LABEL[i]; motion_label[2] = MOTION_2_LABEL[i]; motion_label[3] = MOTION_3_LABEL[i]
  motion_step[1] = MOTION_1_STEP[i]; motion_step[2] = MOTION_2_STEP[i]; motion_step[3] = MOTION_3_STEP[i]
  motion_format[1] = MOTION_1_FORMAT[i]; motion_format[2] = MOTION_2_FORMAT[i]; motion_format[3] = MOTION_3_FORMAT[i]
  still[1] = STILL_1[i]; still[2] = STILL_2[i]; still[3] = STILL_3[i]
  cycled = CYCLED[i]
  # The limit of a long run is that of its cycle, if it has one.
  limit_in_all = !(THINNED && cycled)
  whole_colour = cycled ? faint : ink
  whole_width = cycled ? 1 : 2
  whole_name = cycled ? "before and after" : "force"
  set label 1 NAME[i] at screen 0.08, screen bottom + 0.95 * height left font ",15" textcolor rgb ink
  set label 2 ENERGY[i] at screen 0.98, screen bottom + 0.95 * height right font ",12" textcolor rgb quiet_text

  if (PLANAR[i]) {
    stays = still[1] && still[2]
    set bmargin; set tmargin; set lmargin; set rmargin
    set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
    set key at graph 0.5, graph 1.02 bottom center horizontal Left reverse maxrows 1 samplen 1.5 width -2 font ",12"
    set origin 0.04, bottom + 0.01 * height
    set size ratio -1 0.46, 0.83 * height
    set xrange [*:*]
    set yrange [*:*]
    set xlabel motion_label[1]
    set ylabel motion_label[2]
    set xtics motion_step[1]
    set ytics motion_step[2]
    set format x motion_format[1]
    set format y motion_format[2]
    plot $DATA using (column(motion[1])):(column(motion[2])) @rest linewidth whole_width \
        linecolor rgb whole_colour title "path of the motion", \
      $DATA every ::0::0 using (stays ? column(motion[1]) : NaN):(column(motion[2])) with points pointtype 7 \
        linecolor rgb ink notitle, \
      $CYCLE index (i-1) using (cycled ? column(motion[1]) : NaN):(column(motion[2])) \
        with lines linewidth 2.5 linecolor rgb ink title (cycled ? "last full cycle" : "")
    set offsets 0, 0, 0, 0
    set format x "% h"
    set format y "% h"
    unset label 1
    unset label 2
    unset label 5
    set origin 0.52, bottom + 0.01 * height
    set size ratio -1 0.46, 0.83 * height
    set parametric
    set trange [0:2*pi]
    set xrange [-1.15 * TOP[i]:1.15 * TOP[i]]
    set yrange [-1.15 * TOP[i]:1.15 * TOP[i]]
    set xlabel force_label[1]
    set ylabel force_label[2]
    set xtics FORCE_STEP[i]
    set ytics FORCE_STEP[i]
    plot \
      LIMIT_AXIS_1[i] * cos(t) * DIRECTION_X[i] - LIMIT_AXIS_2[i] * sin(t) * DIRECTION_Y[i], \
      LIMIT_AXIS_1[i] * cos(t) * DIRECTION_Y[i] + LIMIT_AXIS_2[i] * sin(t) * DIRECTION_X[i] \
        with lines linewidth 2 dashtype 2 linecolor rgb limit_colour title "largest limit", \
      $DATA using (column(force[1])):(column(force[2])) @rest linewidth whole_width \
        linecolor rgb whole_colour title "path of the force", \
      $DATA every ::0::0 using (stays ? column(force[1]) : NaN):(column(force[2])) with points pointtype 7 \
        linecolor rgb ink notitle, \
      $CYCLE index (i-1) using (cycled ? column(force[1]) : NaN):(column(force[2])) \
        with lines linewidth 2.5 linecolor rgb ink title (cycled ? "last full cycle" : "")
    unset parametric
    set xtics autofreq
    set ytics autofreq
    set size noratio
  } else {
    do for [p=1:LOOPS[i]] {
      set lmargin at screen left(LOOPS[i], p)
      set rmargin at screen right(LOOPS[i], p)
      set bmargin at screen bottom + foot
      set tmargin at screen bottom + 0.83 * height
      @legend
      set xrange [from[p]:to[p]]
      set yrange [low[p]:high[p]]
      set xlabel motion_label[p]
      set ylabel force_label[p]
      set xtics motion_step[p]
      set format x motion_format[p]
      set label 6 (still[p] ? "neither the motion nor the force changes" : "") at graph 0.5, graph 0.75 center \
        font ",12" textcolor rgb quiet_text
      plot \
        $DATA using (number(motion[p])):(with_limit[p] && limit_in_all ? column(LIMIT[i]) : NaN) @limit_of_all \
          linecolor rgb limit_colour title (with_limit[p] && limit_in_all ? "limit" : ""), \
        $DATA using (number(motion[p])):(with_limit[p] && limit_in_all ? below(i) : NaN) @limit_of_all \
          linecolor rgb limit_colour notitle, \
        $CYCLE index (i-1) using (number(motion[p])):(with_limit[p] && !limit_in_all ? column(LIMIT[i]) : NaN) \
          with lines linewidth 2 dashtype 2 linecolor rgb limit_colour title (with_limit[p] && !limit_in_all ? "limit" : ""), \
        $CYCLE index (i-1) using (number(motion[p])):(with_limit[p] && !limit_in_all ? below(i) : NaN) \
          with lines linewidth 2 dashtype 2 linecolor rgb limit_colour notitle, \
        $DATA every ::0::0 using (still[p] && with_limit[p] ? number(motion[p]) : NaN):(column(LIMIT[i])) \
          with points pointtype 1 linecolor rgb limit_colour notitle, \
        $DATA every ::0::0 using (still[p] && with_limit[p] ? number(motion[p]) : NaN):(below(i)) \
          with points pointtype 1 linecolor rgb limit_colour notitle, \
        $DATA using (number(motion[p])):(column(force[p])) @rest linewidth whole_width \
          linecolor rgb whole_colour title whole_name, \
        $DATA every ::0::0 using (still[p] ? number(motion[p]) : NaN):(column(force[p])) with points pointtype 7 \
          linecolor rgb ink notitle, \
        $CYCLE index (i-1) using (cycled ? number(motion[p]) : NaN):(column(force[p])) \
          with lines linewidth 2.5 linecolor rgb ink title (cycled ? "last full cycle" : "")
      set xtics autofreq
      set format x "% h"
      unset label 1
      unset label 2
      unset label 5
      unset label 6
    }
    unset lmargin; unset rmargin; unset tmargin; unset bmargin
  }
}
unset multiplot
unset output
