# SPDX-License-Identifier: Apache-2.0
# A friction result over time, a column of panels for each friction definition, two in a row: its
# motions, its force with the limit, normal force and coefficient, and energies, all over one time
# axis with stick (white), slip (light) and no friction (dark) shaded, and hatched where they take
# turns too fast to be drawn.
# `slipbench plot --as history` sets the variables and data blocks used here and loads this file.
load STYLE
set xzeroaxis linewidth 0.6 linecolor rgb axis_colour
in_row = DEFINITIONS > 1 ? 2 : 1
width = 1.0 / in_row
group = (1.0 - head) / ((DEFINITIONS + in_row - 1) / in_row)
# Beside four panels a column has the labels of its time axis and its name.
axis_room = 50.0 / HEIGHT
name_room = NAME[1] eq "" ? 0 : 25.0 / HEIGHT
tall = (group - axis_room - name_room) / 4.0

do for [i=1:DEFINITIONS] {
  column_left = ((i - 1) % in_row) * width
  group_foot = 1.0 - head - ((i - 1) / in_row + 1) * group
  set lmargin at screen column_left + 0.1
  set rmargin at screen column_left + width - 0.11
  set xrange [BEGIN:END_TIME]
  set xtics rotate by 0
  set ylabel font ",12"
  @legend
  set label 1 NAME[i] at screen column_left + 0.02, screen group_foot + group - 0.5 * name_room left font ",15" textcolor rgb ink

  do for [p=1:4] {
    base = group_foot + axis_room + (4 - p) * tall
    set bmargin at screen base + 0.14 * tall
    set tmargin at screen base + 0.84 * tall
    if (p < 4) { set xlabel ""; set format x "" } else { set xlabel TIME_LABEL; set format x TIME_FORMAT }
    shades_told = p == 1
    unset y2tics
    set y2label ""
    set y2range [0:1]
    set border 3
    if (p == 1) {
      two = strlen(MOTION2_LABEL[i]) > 0
      low = MOTION_LOW[i]; high = MOTION_HIGH[i]
      set yrange [low:high]
      set ylabel MOTION_LABEL[i]
      set ytics MOTION_STEP[i]
      if (two) {
        set border 11
        set y2range [MOTION2_LOW[i]:MOTION2_HIGH[i]]
        set y2tics MOTION2_STEP[i] font ",12" textcolor rgb ink
        set y2label MOTION2_LABEL[i]
      }
      plot @SHADES, \
        for [k=1:words(MOTIONS[i])] $DATA using \
          1:(word(MOTION_AXES[i], k) eq "1" ? number(int(word(MOTIONS[i], k))) : NaN) \
          with lines linewidth 2 dashtype dashes[k] linecolor rgb colour[k] \
          title (word(MOTION_AXES[i], k) eq "1" ? word(MOTION_NAMES[i], k) : ""), \
        for [k=1:words(MOTIONS[i])] $DATA using \
          1:(word(MOTION_AXES[i], k) eq "2" ? number(int(word(MOTIONS[i], k))) : NaN) axes x1y2 \
          with lines linewidth 2 dashtype dashes[k] linecolor rgb colour[k] \
          title (word(MOTION_AXES[i], k) eq "2" ? word(MOTION_NAMES[i], k)." (right)" : "")
      unset label 1
    }
    if (p == 2) {
      low = SIGNED[i] ? -1.15 * TOP[i] : -0.04 * TOP[i]; high = 1.15 * TOP[i]
      set yrange [low:high]
      set ylabel SHORT_LABEL[i]
      set ytics FORCE_STEP[i]
      plot @SHADES, \
        for [k=1:words(BESIDE[i])] $DATA using 1:(column(int(word(BESIDE[i], k)))) with lines \
          linewidth 1.5 dashtype dashes[k+1] linecolor rgb colour[k+1] title word(BESIDE_NAMES[i], k), \
        $DATA using 1:(column(FORCE[i])) with lines linewidth 2 linecolor rgb ink title FORCE_NAME[i], \
        $DATA using 1:(number(LIMIT[i])) with lines linewidth 2 dashtype 2 \
          linecolor rgb limit_colour title (LIMIT[i] > 0 ? "limit" : ""), \
        $DATA using 1:(LIMIT[i] > 0 && SIGNED[i] ? below(i) : NaN) with lines linewidth 2 \
          dashtype 2 linecolor rgb limit_colour notitle
    }
    if (p == 3) {
      low = NORMAL_LOW[i]; high = NORMAL_HIGH[i]
      set yrange [low:high]
      set y2range [MU_LOW[i]:MU_HIGH[i]]
      set ylabel NORMAL_LABEL[i]
      set ytics NORMAL_STEP[i]
      set border 11
      set y2tics MU_STEP[i] font ",12" textcolor rgb ink
      set y2label "coefficient mu"
      plot @SHADES, \
        $DATA using 1:(number(NORMAL[i])) with lines linewidth 2 linecolor rgb ink \
          title (NORMAL[i] > 0 ? "F_N" : ""), \
        $DATA using 1:(number(MU[i])) axes x1y2 with lines linewidth 2 dashtype dashes[2] \
          linecolor rgb colour[2] title (MU[i] > 0 ? "mu (right)" : "")
    }
    if (p == 4) {
      low = ENERGY_LOW[i]; high = ENERGY_HIGH[i]
      set yrange [low:high]
      set ylabel ENERGY_LABEL[i]
      set ytics ENERGY_STEP[i]
      plot @SHADES, \
        $DATA using 1:(number(WORK[i])) with lines linewidth 6 \
          linecolor rgb (DARK ? "#2f5f92" : "#7aa6d6") title (WORK[i] > 0 ? "work" : ""), \
        $DATA using 1:(number(STORED[i])) with lines linewidth 2 dashtype dashes[2] \
          linecolor rgb colour[3] title (STORED[i] > 0 ? "stored" : ""), \
        $DATA using 1:(number(DISSIPATION[i])) with lines linewidth 2 linecolor rgb ink \
          title (DISSIPATION[i] > 0 ? "dissipated" : "")
    }
  }
}
unset multiplot
unset output
