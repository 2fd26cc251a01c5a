#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# fuzz.sh TARGET|all|list [SECONDS]: feeds a reader of tests/fuzz with inputs of libFuzzer (clang 14) under the address and
# undefined-behaviour sanitizers, 60 s unless told otherwise, on the inputs of cases/ and tests/decks, and on runs of some cases.
# `list` names the targets. The build before it takes 15 to 30 minutes once, on two cores; after a change what that touches.
# A finding is a crash, a broken promise, an allocation of 256 MB, or 2 s of one processor (SLIPBENCH_FUZZ_TIMEOUT) for an input of
# up to 16 KB. What takes so long under the sanitizers is tried again without them, in the release build, which is made if it is not
# there. Exit: 0 nothing found, 1 something found (the input's file is named), 2 a wrong argument.
# What is found and mended goes into tests/fuzz/corpus/TARGET, which ctest replays.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
limit=${SLIPBENCH_FUZZ_TIMEOUT:-2}
# The sanitizer's shadow, red zones and freed blocks take about as much again as the program.
memory=256
longest=16384
mapfile -t targets < <(sed -n 's/^set(fuzz_targets \(.*\))$/\1/p' tests/fuzz/CMakeLists.txt | tr ' ' '\n')
target=${1:-}
seconds=${2:-60}
[[ $seconds =~ ^[0-9]+$ ]] || fail "wanted a number of seconds, found '$seconds'" 2
if [ "$target" = list ]; then
  printf '%s\n' "${targets[@]}"
  exit 0
fi
if [ "$target" != all ]; then
  printf '%s\n' "${targets[@]}" | grep -qxF -- "$target" || fail "wanted 'all' or one of ${targets[*]}; found '$target'" 2
  targets=("$target")
fi

# with_head BYTES FOLDER FILE..: copies files into a folder, with some bytes before them, under names of their own.
with_head() {
  local head=$1 folder=$2 file
  for file in "${@:3}"; do
    { printf '%s' "$head"; cat "$file"; } >"$folder/$(cksum <<<"$file" | tr -d ' ')_$(basename "$file")"
  done
}

# files_with KEY: cases that have a key at their first level.
files_with() { find cases -name '*.yaml' -size -16k -exec grep -lE "^$1:" {} +; }

# runs FOLDER: results of a few cases.
runs() {
  local file
  rm -rf "$1"
  mkdir -p "$1"
  for file in cases/examples/{puck,universal_joint,belt,hinge_wear,backlash_brake}.yaml cases/verification/clutch_engagement.yaml; do
    # The scanner of UDUNITS-2 leaks.
    ASAN_OPTIONS=detect_leaks=0 build/fuzz/slipbench run "$file" -o "$1" >"$1/said" 2>&1 || { cat "$1/said"; fail "no seed of $file"; }
  done
}

# seed TARGET FOLDER: what the project has for a reader, and what was found before.
seed() {
  local files=()
  case "$1" in
    case_text) mapfile -t files < <(files_with '(connector|friction|title)'); with_head '' "$2" "${files[@]}" ;;
    fit) mapfile -t files < <(files_with calibrate); with_head '' "$2" "${files[@]}" ;;
    sweep) mapfile -t files < <(files_with sweep); with_head '' "$2" "${files[@]}" ;;
    csv) mapfile -t files < <(find cases reference -name '*.csv' -size -16k); with_head @ "$2" "${files[@]}" ;;
    table) mapfile -t files < <(find cases reference -name '*.csv' -size -16k); with_head '' "$2" "${files[@]}" ;;
    expression)
      local number=0 line
      while IFS= read -r line; do
        number=$((number + 1))
        printf "%s" "$line" >"$2/expression_$number"
      done < <(grep -arhoE '= [^,}"#]+' cases --include='*.yaml' | sort -u)
      ;;
    result)
      local run
      runs build/fuzz/runs
      for run in build/fuzz/runs/*.json; do
        run=${run%.json}
        { head -n 20 "$run.csv"; echo %%%; cat "$run.json"; echo %%%; head -n 20 "$run.events.csv"; } >"$2/run_$(basename "$run")"
      done
      ;;
    comparison) /usr/bin/python3 tests/fuzz/comparison_seeds.py "$2" reference/curves/*.csv ;;
    abaqus | radioss | lsdyna | opensees)
      mapfile -t files < <(find "tests/decks/$1" cases/bad/decks -type f -size -16k ! -name '*.expected')
      with_head '' "$2" "${files[@]}"
      ;;
  esac
  mapfile -t files < <(find "tests/fuzz/corpus/$1" -type f 2>/dev/null)
  with_head '' "$2" "${files[@]}"
}

# dictionary TARGET: words that an input may have.
dictionary() {
  {
    printf '%s\n' nan inf -1 0 1e400 1e308 1e-308 -0 99999999999999999999 2147483648 0.5 '= ' sin max min pi '#' '"' "'"
    case "$1" in
      case_text | fit | sweep) grep -hoE '[`.][A-Za-z_][A-Za-z0-9_]*' docs/case-reference.md | cut -c2- ;;
      expression) grep -hoE '\b[a-z]+\(' docs/guide/*.md | sort | uniq -c | awk '$1 > 2 {print $2}' ;;
      abaqus | radioss | lsdyna | opensees)
        find "tests/decks/$1" -type f -exec grep -hoE '[*/]?[A-Za-z][A-Za-z_ ]{2,}' {} +
        find "driver/import/$1" -name '*.cpp' -exec grep -hoE '"[A-Za-z_*/][A-Za-z_ /]+"' {} + | tr -d '"'
        ;;
      result | table | csv) printf '%s\n' '# columns: ' '# friction: ' '# case: ' 't,' 'CU1' 'CSF1' '[mm]' '%%%' "'descr': " "'<f8'" "'shape': " ;;
    esac
  } | sort -u | sed 's/ *$//; /^$/d; s/\\/\\\\/g; s/"/\\"/g; s/.*/"&"/'
}

# is_slow TARGET INPUT: whether an input takes that long of a processor without sanitizers, which may take twenty times as long.
is_slow() {
  configure release
  build release --target fuzz_replay
  (ulimit -t "$limit" && exec build/release/tests/fuzz/fuzz_replay "$1" "$2") >/dev/null 2>&1 && return 1 || return 0
}

# try TARGET: runs a target for its time; says what was covered, and in findings how many inputs were found.
try() {
  local name=$1 program work=$PWD/build/fuzz/corpus/$1 found=$PWD/build/fuzz/findings/$1 log=$PWD/build/fuzz/$1.log started left code executed edges input
  program=$PWD/build/fuzz/tests/fuzz/fuzz_$name
  rm -rf "$work.seeds" "$found"
  mkdir -p "$work" "$work.seeds" "$found"
  seed "$name" "$work.seeds"
  dictionary "$name" >"$PWD/build/fuzz/$name.dict"
  started=$(date +%s)
  executed=0
  while left=$((seconds - $(date +%s) + started)) && [ "$left" -gt 0 ]; do
    code=0
    ASAN_OPTIONS=quarantine_size_mb=16:detect_stack_use_after_return=0 nice -n 10 "$program" \
      -max_total_time="$left" -timeout="$limit" -malloc_limit_mb=$memory -rss_limit_mb=$((2 * memory + 128)) \
      -max_len=$longest -dict="$PWD/build/fuzz/$name.dict" -artifact_prefix="$found/" -print_final_stats=1 \
      "$work" "$work.seeds" >"$log" 2>&1 || code=$?
    executed=$((executed + $(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1 | grep . || echo 0)))
    edges=$(grep -oE 'cov: [0-9]+' "$log" | tail -n 1 | cut -c6- || true)
    [ "$code" -ne 0 ] || break
    input=$(find "$found" -type f -name 'timeout-*' | head -n 1)
    if [ -n "$input" ] && ! is_slow "$name" "$input"; then
      rm "$input"
      continue
    fi
    findings=$((findings + 1))
    tail -n 40 "$log"
    input=$(find "$found" -type f | head -n 1)
    say "$name: FOUND ${input:-nothing, but libFuzzer ends with $code}"
    break
  done
  say "$name: $executed inputs in $(($(date +%s) - started)) s, ${edges:-0} edges covered"
}

configure fuzz
say "building ${targets[*]} for libFuzzer on $(nproc) cores"
programs=("${targets[@]/#/fuzz_}")
# Seeds of results are what the program itself writes.
[[ " ${targets[*]} " != *' result '* ]] || programs+=(slipbench)
build fuzz --target "${programs[@]}"
findings=0
for target in "${targets[@]}"; do try "$target"; done
[ "$findings" -eq 0 ] || fail "$findings of ${#targets[@]} targets found something; the inputs are in build/fuzz/findings" 1
say "${#targets[@]} targets found nothing"
