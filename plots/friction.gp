# SPDX-License-Identifier: Apache-2.0
# A friction result in panels: force against time with its limit, stick (white), slip (grey) and no
# contact (dotted); force against motion; for motion in a plane the path of motion and of force.
# `slipbench plot` sets the variables and the data block this file uses, and then loads it.
eval "set terminal ".TERMINAL
set output PICTURE
set encoding utf8
set border 3 linewidth 1 linecolor rgb "#444444"
set tics nomirror out scale 0.5 textcolor rgb "#222222"
set termoption noenhanced
unset key

slip_grey = "#d8d8d8"
open_grey = "#9a9a9a"
limit_red = "#b03020"
array colour[3] = ["#1f6fb4", "#e08a00", "#2a8f5b"]
array dashes[3] = [4, 5, 2]

set multiplot title TITLE noenhanced font ",16" offset 0,0.2
head = 60.0 / (60.0 + 440.0 * DEFINITIONS)
height = (1.0 - head) / DEFINITIONS

do for [i=1:DEFINITIONS] {
  bottom = 1.0 - head - i * height
  low = SIGNED[i] ? -1.25 * TOP[i] : -0.06 * TOP[i]
  high = 1.25 * TOP[i]
  slip_block = sprintf("$SLIP_%d", i)
  open_block = sprintf("$OPEN_%d", i)
  wide = PLANAR[i] ? 0.40 : 0.58

  # Force against time.
  set size noratio
  set lmargin at screen 0.075
  set rmargin at screen wide
  set bmargin at screen bottom + 0.16 * height
  set tmargin at screen bottom + 0.86 * height
  set xrange [BEGIN:END_TIME]
  set yrange [low:high]
  set xlabel TIME_LABEL noenhanced
  set ylabel FORCE_LABEL[i] noenhanced
  set label 1 NAME[i] at graph 0.01, graph 1.13 noenhanced font ",13" left
  set key at graph 1.0, graph 1.015 bottom right horizontal Left reverse samplen 1.6 width 1 noenhanced
  set xzeroaxis linewidth 0.6 linecolor rgb "#888888"
  show_limit = LIMIT[i] > 0
  plot \
    @slip_block using ($1):(low):1:2:(low):(high) with boxxyerror fillstyle solid noborder fillcolor rgb slip_grey title (SLIPS[i] ? "slip" : "")
  unset label 1
}
unset multiplot
