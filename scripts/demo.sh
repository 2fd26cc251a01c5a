#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# From a fresh clone to checked cases and pictures: sets up, builds the program, checks cases/, draws some of them
# calibrates one, and makes a page of the examples and of those that compare with curves.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
slipbench=build/release/slipbench

scripts/setup.sh
say "building the program on $(nproc) cores"
configure release
build release --target slipbench

say 'checking the cases'
"$slipbench" check cases/ || fail "slipbench check cases/ ended with exit code $?"

say 'drawing some cases'
mkdir -p out
pictures=()
# draw CASE PICTURE
draw() {
  "$slipbench" plot "cases/$1.yaml" -o "out/$2.svg" || fail "drawing cases/$1.yaml failed"
  pictures+=("out/$2.svg")
}
draw examples/shock_absorber shock_absorber
draw examples/slide_plane_circle circle
draw examples/puck puck
draw verification/documented_and_as_coded documented_and_as_coded
"$slipbench" plot --law cases/examples/modified_darmstad.yaml -o out/coefficient.svg || fail 'drawing the coefficient failed'
pictures+=(out/coefficient.svg)

say 'calibrating a slider against measured data'
"$slipbench" calibrate cases/calibration/slider_loop_fit.yaml -o out || fail "slipbench calibrate ended with exit code $?"

say 'writing the report'
"$slipbench" report cases/examples cases/validation -o out/report.html || fail "slipbench report ended with exit code $?"
say 'done'
printf 'Pictures: %s      Report: out/report.html      Fit: out/slider_loop_fit.html\n' "${pictures[*]}"
