#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# nightly.sh [PART..]: all that takes too long for every change, one part after the other, or those named. All are tried, whatever
# one of them finds; the last lines say which found something. Exit: 0 nothing found, 1 something, 2 a wrong argument.
#   sanitizers  all tests under the address and undefined-behaviour sanitizers, the Python module too     1 h 30 min
#   threads     what runs in parallel, the Python module too, under the thread sanitizer             35 min
#   memory      reads of memory that was never written, by valgrind, in a dozen cases               3 min
#   difference  the law in double against itself in long double, over a million increments             5 min
#   properties  the properties of the law over random cases of other seeds every night                 1 min
#   fuzz        every target of scripts/fuzz.sh, SLIPBENCH_FUZZ_SECONDS (600) each                   2 h
#   long        10^8 increments, a CSV of 2 GB, 100,000 cases, 1,000 definitions, a table of 10^6 rows; 3 GB of disk       10 min
#   large       inputs of up to a megabyte, made of what is repeated: 2 s and 256 MB each             6 min
#   numbers     every number of the examples, decks and results as 13 that nobody means                       3 min
#   torture     scripts/torture.sh                                                                   3 min
#   packages    scripts/package.sh, and its packages in a minimal Debian and an empty root (as root)  10 min
#   live        scripts/wasm.sh: the bench in a page; its rows beside the program's, and the page in a browser          a build
#   compilers   results of g++ and clang 14 at -O1 and -O3, byte by byte                               30 min
#   coverage    scripts/coverage.sh: lines and branches that the tests run                             45 to 75 min
#   mutate      scripts/mutate.sh: which changes of the code no test sees, 600 others every night      45 min
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# The build of fuzz.sh serves.
sanitizers() {
  SLIPBENCH_PRESET=fuzz scripts/test.sh
  configure asan-ubsan
  build asan-ubsan --target slipbench_python slipbench
  ctest --preset asan-ubsan --no-label-summary -R '^python/'
}

threads() {
  configure tsan
  build tsan --target slipbench driver_tests ground_tests
  # The first race ends the program, with a code that no command has.
  export TSAN_OPTIONS="halt_on_error=1 exitcode=66"
  ctest --preset tsan --no-label-summary -R '^driver/(sweep|suite|farm|base/files|calibrate/(calibrate|observation|replay))'
  local out
  out=$(mktemp -d)
  race() { build/tsan/slipbench "$@" >"$out/said" 2>&1 || [ $? -ne 66 ] || { cat "$out/said"; fail "a race in: slipbench $*"; }; }
  race check cases/examples cases/verification -j 4 --report "$out/page.html"
  race sweep cases/sweeps/slot_sweep.yaml -j 4 -o "$out"
  race sweep cases/sweeps/slot_sweep.yaml -j 4 -o "$out" --no-rows --force
  race sweep cases/sweeps/press_fit_indices.yaml -j 4 -o "$out"
  race calibrate cases/calibration/wear_table_fit.yaml -o "$out"
  race calibrate cases/calibration/slider_loop_fit.yaml -o "$out" --bootstrap 20 --profile
  rm -r "$out"
  scripts/threads.sh
}

memory() {
  configure release
  build release --target slipbench
  local out name
  out=$(mktemp -d)
  for name in shock_absorber hinge_wear slide_plane_circle puck modified_darmstad belt press_fit universal_joint part_pairs \
    stick_slip_belt backlash_brake axial_strut; do
    say "  $name"
    valgrind -q --error-exitcode=99 --track-origins=yes build/release/slipbench run "cases/examples/$name.yaml" -o "$out" >"$out/said" 2>&1 ||
      [ $? -ne 99 ] || { cat "$out/said"; fail "valgrind finds something in cases/examples/$name.yaml"; }
  done
  valgrind -q --error-exitcode=99 build/release/slipbench calibrate cases/calibration/slider_loop_fit.yaml -o "$out" >"$out/said" 2>&1 ||
    [ $? -ne 99 ] || { cat "$out/said"; fail 'valgrind finds something in a calibration'; }
  rm -r "$out"
}

# Seeds of its own every night; each that finds something is printed.
difference() {
  configure release
  build release --target difference_tests
  SLIPBENCH_DIFFERENCE_INCREMENTS=1000000 SLIPBENCH_DIFFERENCE_SEED="$(date +%Y%m%d)000000" build/release/tests/difference_tests
}

# Of another seed every night; SLIPBENCH_TEST_SEED=DATE draws the cases of that night.
properties() {
  configure release
  build release --target property_tests
  SLIPBENCH_TEST_SEED="${SLIPBENCH_TEST_SEED:-$(date +%Y%m%d)}" build/release/tests/property_tests
}

fuzz() { scripts/fuzz.sh all "${SLIPBENCH_FUZZ_SECONDS:-600}"; }

long() {
  configure release
  build release --target slipbench
  /usr/bin/python3 tests/long/long_test.py --slipbench build/release/slipbench
}

large() {
  configure release
  build release --target fuzz_replay
  grow() { build/release/tests/fuzz/fuzz_replay "$1" --large "${@:2}" >build/large.log || { cat build/large.log; fail "too much, see above"; }; }
  grow case_text 999999 cases/examples/*.yaml cases/verification/{coefficient,wear}_table*.yaml
  grow fit 999999 cases/calibration/*_fit.yaml
  grow sweep 999999 cases/sweeps/*.yaml
  grow csv 999999 cases/calibration/*.csv
  grow table 999999 cases/calibration/*.csv
  grow lsdyna 999999 tests/decks/lsdyna
  grow opensees 999999 tests/decks/opensees
  grow result 999999 tests/fuzz/corpus/result
  grow comparison 999999 tests/fuzz/corpus/comparison
  grow expression 999999 tests/fuzz/corpus/expression
  # A formula has at most 10,000 characters: only a shorter one gets as far as the parser.
  grow expression 9999 tests/fuzz/corpus/expression
  grow abaqus 999999 tests/decks/abaqus
  grow radioss 999999 tests/decks/radioss
}

numbers() {
  configure release
  build release --target fuzz_replay
  change() { build/release/tests/fuzz/fuzz_replay "$1" --numbers "${@:2}" >build/numbers.log || { cat build/numbers.log; fail "too much, see above"; }; }
  change case_text cases/examples/*.yaml cases/verification/*.yaml
  change fit cases/calibration/*_fit.yaml
  change sweep cases/sweeps/*.yaml
  change result tests/fuzz/corpus/result
  change expression tests/fuzz/corpus/expression
  local dialect
  for dialect in abaqus lsdyna opensees radioss; do change "$dialect" "tests/decks/$dialect"; done
}

torture() { scripts/torture.sh; }
packages() { scripts/package.sh && tests/packages/minimal_debian.sh && tests/packages/bare_root.sh; }
live() {
  scripts/wasm.sh
  scripts/setup.sh tests
  configure release
  build release --target slipbench
  node tests/live/same_rows.cjs build/wasm/core.js build/release/slipbench cases/examples/*.yaml cases/verification/*.yaml
  /usr/bin/python3 tests/live/live_test.py build/release/slipbench
}
# The release is of g++ at -O3, that of fuzz.sh of clang at -O1.
compilers() {
  configure release
  build release --target slipbench
  configure fuzz
  build fuzz --target slipbench
  local name compiler flags
  while read -r name compiler flags; do
    say "  $compiler $flags"
    cmake -S . -B "build/$name" -G Ninja -D CMAKE_BUILD_TYPE=Debug -D CMAKE_UNITY_BUILD=ON -D SLIPBENCH_BUILD_TESTS=OFF -D SLIPBENCH_BUILD_BENCH=OFF \
      -D SLIPBENCH_PYTHON=OFF -D SLIPBENCH_INSTALL=OFF -D CMAKE_CXX_COMPILER="$compiler" -D CMAKE_CXX_FLAGS="$flags" >build/cmake.log 2>&1 ||
      { cat build/cmake.log; fail 'configuring failed, see above'; }
    cmake --build "build/$name" --parallel "$(nproc)" --target slipbench | show_tenths
  done <<<$'gcc-o1 g++ -O1\nclang-o3 clang++-14 -O3'
  for name in fuzz gcc-o1 clang-o3; do
    # Its scanner of units leaks, which is no result.
    ASAN_OPTIONS=detect_leaks=0 /usr/bin/python3 tests/cases/same_results.py build/release/slipbench "build/$name/slipbench"
  done
}

coverage() { scripts/coverage.sh; }

mutate() { scripts/mutate.sh --seed "$(date +%Y%m%d)"; }

parts=(sanitizers threads memory difference properties fuzz long large numbers torture packages live compilers coverage mutate)
for part in "$@"; do
  printf '%s\n' "${parts[@]}" | grep -qxF -- "$part" || fail "wanted some of ${parts[*]}; found '$part'" 2
done
[ "$#" -eq 0 ] || parts=("$@")
found=()
for part in "${parts[@]}"; do
  say "$part"
  # In a shell of its own, which ends at the first fault; behind || it would not.
  set +e
  (set -e; "$part")
  code=$?
  set -e
  [ "$code" -eq 0 ] || found+=("$part")
done
[ "${#found[@]}" -eq 0 ] || fail "found something: ${found[*]}"
say "nothing found: ${parts[*]}"
