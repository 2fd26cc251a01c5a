# SPDX-License-Identifier: Apache-2.0
# Coefficients of friction in panels, one row of them for each: mu over the slip rate at several
# normal forces (or pressures), mu over these at several slip rates, and mu as a map over both. The
# states that a run visited are marked in all of them. A panel that would show straight level lines
# is left out.
# `slipbench plot --law` sets the variables and data blocks used here and loads this file.
load STYLE

# From light to dark without a turn, so that it says the same in grey.
set palette defined (0 "#fdf7d8", 0.25 "#f6cf80", 0.5 "#dd8c5f", 0.75 "#9c4868", 1 "#3b1d52")

# The states of the run: filled circles in slip, open squares in stick.
state(status, value) = column(1) == status ? value : NaN
slip_fill = "#ffffff"

height = (1.0 - head) / COEFFICIENTS

do for [i=1:COEFFICIENTS] {
  bottom = 1.0 - head - i * height
  both = BY_RATE[i] && BY_LOAD[i]
  set bmargin at screen bottom + foot
  set tmargin at screen bottom + 0.82 * height
  set key at graph 0.0, graph 1.02 bottom left horizontal Left reverse maxrows 2 samplen 1.5 width 0 font ",12"
  set label 1 NAME[i] at screen 0.1, screen bottom + 0.96 * height left font ",15" textcolor rgb ink
  set label 2 CUT[i] at screen 0.98, screen bottom + 0.96 * height right font ",12" textcolor rgb quiet_text
  set yrange [0:1.12 * TOP[i]]
  set ylabel "coefficient mu" offset 1,0

  if (BY_RATE[i]) {
    set lmargin at screen 0.1
    set rmargin at screen (both ? 0.32 : 0.50)
    set xrange [0:RATE_END[i]]
    set xlabel RATE_LABEL[i]
    set xtics RATE_STEP[i]
    plot \
      for [k=1:words(OVER_RATE_NAMES[i])] $OVER_RATE index (i-1) using 1:(column(k+1)) with lines \
        linewidth 2 dashtype dashes[k] linecolor rgb colour[k] \
        title (BY_LOAD[i] ? word(OVER_RATE_NAMES[i], k) : ""), \
      $STATES index (i-1) using 2:(state(1, $4)) with points pointtype 4 pointsize 0.7 linewidth 1.2 \
        linecolor rgb "black" notitle, \
      $STATES index (i-1) using 2:(state(2, $4)) with points pointtype 7 pointsize 0.7 \
        linecolor rgb "black" notitle, \
      $STATES index (i-1) using 2:(state(2, $4)) with points pointtype 7 pointsize 0.45 \
        linecolor rgb slip_fill notitle, \
      $MARKS index (i-1) using 1:2:3 with labels point pointtype 2 pointsize 0.8 linecolor rgb ink \
        textcolor rgb ink offset 0.6,0.8 left \
        font ",12" notitle
  }
  unset label 1
  unset label 2
  if (BY_LOAD[i]) {
    set lmargin at screen (both ? 0.385 : 0.1)
    set rmargin at screen (both ? 0.60 : 0.50)
    set xrange [0:LOAD_END[i]]
    set xlabel LOAD_LABEL[i]
    set xtics LOAD_STEP[i]
    if (!both) {
      set label 1 NAME[i] at screen 0.1, screen bottom + 0.96 * height left font ",15" textcolor rgb ink
      set label 2 CUT[i] at screen 0.98, screen bottom + 0.96 * height right font ",12" textcolor rgb quiet_text
    } else { set ylabel "" }
    plot \
      for [k=1:words(OVER_LOAD_NAMES[i])] $OVER_LOAD index (i-1) using 1:(column(k+1)) with lines \
        linewidth 2 dashtype dashes[k] linecolor rgb colour[k] \
        title (BY_RATE[i] ? word(OVER_LOAD_NAMES[i], k) : ""), \
      $STATES index (i-1) using 3:(state(1, $4)) with points pointtype 4 pointsize 0.7 linewidth 1.2 \
        linecolor rgb "black" notitle, \
      $STATES index (i-1) using 3:(state(2, $4)) with points pointtype 7 pointsize 0.7 \
        linecolor rgb "black" notitle, \
      $STATES index (i-1) using 3:(state(2, $4)) with points pointtype 7 pointsize 0.45 \
        linecolor rgb slip_fill notitle
    unset label 1
    unset label 2
  }

  # The map; its legend tells the marks of all panels.
  set lmargin at screen (both ? 0.68 : 0.60)
  set rmargin at screen 0.885
  set xrange [0:RATE_END[i]]
  set yrange [0:LOAD_END[i]]
  set cbrange [0:TOP[i]]
  set colorbox user origin 0.90, bottom + foot size 0.014, 0.67 * height
  set cbtics scale 0.3 font ",12"
  set cblabel "mu" offset 0.5,0
  set xlabel RATE_LABEL[i]
  set xtics MAP_STEP[i]
  set ylabel LOAD_LABEL[i]
  plot \
    $MAP index (i-1) using 1:2:3 with image notitle, \
    $STATES index (i-1) using 2:(state(1, $3)) with points pointtype 5 pointsize 0.8 \
      linecolor rgb "black" notitle, \
    $STATES index (i-1) using 2:(state(1, $3)) with points pointtype 5 pointsize 0.45 \
      linecolor rgb "#888888" notitle, \
    $STATES index (i-1) using 2:(state(2, $3)) with points pointtype 7 pointsize 0.8 \
      linecolor rgb "black" notitle, \
    $STATES index (i-1) using 2:(state(2, $3)) with points pointtype 7 pointsize 0.5 \
      linecolor rgb slip_fill notitle, \
    keyentry with points pointtype 4 pointsize 0.8 linewidth 1.2 linecolor rgb ink \
      title (STICKS[i] ? STICK_NAME[i] : ""), \
    keyentry with points pointtype 6 pointsize 0.8 linewidth 1.2 linecolor rgb ink \
      title (SLIPS[i] ? "visited in slip" : "")
  unset colorbox
}
unset multiplot
unset output
