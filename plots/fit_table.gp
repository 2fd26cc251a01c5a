# SPDX-License-Identifier: Apache-2.0
# A fitted table: its ordinates before (light) and after the fit with their intervals, a curve for each block of later
# independents. Hollow points have never been visited by the data.
# `slipbench calibrate` sets the variables and data blocks used here and loads this file.
load STYLE
array shape[6] = [7, 5, 9, 13, 11, 15]
array hollow[6] = [6, 4, 8, 12, 10, 14]
set lmargin at screen 0.09
set rmargin at screen 0.97
set bmargin at screen foot
set tmargin at screen 1.0 - head - 75.0 / HEIGHT
set xrange [FROM:TO]
set yrange [LOW:HIGH]
set ytics Y_STEP
@TICS
set xlabel X_LABEL
set ylabel LABEL offset 0.5,0
set label 1 SAYS_1 at screen 0.03, screen 1.0 - head - 8.0 / HEIGHT left font ",12" textcolor rgb quiet_text
set label 2 SAYS_2 at screen 0.03, screen 1.0 - head - 27.0 / HEIGHT left font ",12" textcolor rgb quiet_text
set key at screen 0.97, screen 1.0 - head - 70.0 / HEIGHT bottom right horizontal Left reverse maxrows 2 samplen 3 width 1 font ",12"
if (BLOCKS == 1) {
  plot \
    $UNSEEN using (0.5 * ($1 + $2)):(0.5 * (LOW + HIGH)):1:2:(LOW):(HIGH) with boxxyerror \
      fillstyle transparent pattern 4 noborder fillcolor rgb turns_shade title (UNSEEN ? "never visited" : ""), \
    $ORDINATES using 1:4:5 with filledcurves fillstyle solid 0.25 noborder linecolor rgb colour[2] title INTERVAL, \
    $ORDINATES using 1:2 with lines linewidth 1 dashtype 2 linecolor rgb faint title "before", \
    $ORDINATES using 1:3 with lines linewidth 2 linecolor rgb ink title "after", \
    $ORDINATES using 1:($6 > 0 ? NaN : $3) with points pointtype 7 pointsize 0.8 linecolor rgb ink notitle, \
    $ORDINATES using 1:($6 > 0 ? $3 : NaN) with points pointtype 6 pointsize 0.9 linecolor rgb ink notitle
} else {
  plot \
    for [b=1:BLOCKS] $ORDINATES index (b-1) using 1:2 with lines linewidth 1 dashtype 3 linecolor rgb faint notitle, \
    for [b=1:BLOCKS] $ORDINATES index (b-1) using 1:3:4:5 with yerrorbars pointtype 0 linewidth 1.2 linecolor rgb colour[b] notitle, \
    for [b=1:BLOCKS] $ORDINATES index (b-1) using 1:3 with lines linewidth 2 dashtype dashes[b] linecolor rgb colour[b] title NAME[b], \
    for [b=1:BLOCKS] $ORDINATES index (b-1) using 1:($6 > 0 ? NaN : $3) with points pointtype shape[b] pointsize 0.9 linecolor rgb colour[b] notitle, \
    for [b=1:BLOCKS] $ORDINATES index (b-1) using 1:($6 > 0 ? $3 : NaN) with points pointtype hollow[b] pointsize 1.0 linecolor rgb colour[b] notitle
}
unset multiplot
unset output
