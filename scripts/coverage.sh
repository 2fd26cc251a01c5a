#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# coverage.sh: how many lines and branches of law/ and reference/ the tests run, and how many lines of what reads files (YAML,
# cases, decks, tables): lines by gcovr, branches by scripts/branches.py, which says what counts as one. Contract checks are off,
# and what is always inlined is not. Fails with less than 98 % of lines or 95 % of branches of law/ and reference/, or 95 % of
# lines of the readers. Takes 45 to 75 minutes on two cores; law.txt, readers.txt and branches.txt in build/coverage list by file what was not run.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scripts/setup.sh mutation
configure coverage
say "building with counters on $(nproc) cores"
build coverage
find build/coverage -name '*.gcda' -delete
missed=()
say 'running the tests of both'
ctest --preset coverage --parallel "$(nproc)" --no-label-summary --output-on-failure \
  -R '^(law|property|reference|fuzz|import|driver/(base|yaml|case|read|import|results|commands|calibrate)|cases/(bad|check|hostile|mistakes|calibration))/?' \
  >build/coverage/tests.log 2>&1 || { tail -n 40 build/coverage/tests.log >&2; missed+=(tests); }

# covered NAME FILTERS.. -- BARS..: counts what the tests ran of some folders; the bars are arguments of gcovr.
covered() {
  local name=$1 filters=()
  shift
  while [ "$1" != -- ]; do
    filters+=(--filter "$1")
    shift
  done
  say "counting $name"
  # It waits for ever where one of its workers fails, as by its assertion that a function begins at one line, which says nothing of
  # lines and branches.
  PYTHONOPTIMIZE=1 timeout 1200 gcovr --root . --object-directory build/coverage "${filters[@]}" -j "$(nproc)" --txt "build/coverage/$name.txt" --print-summary "${@:2}" build/coverage || missed+=("$name")
}
covered law law/ reference/ -- --fail-under-line 98
/usr/bin/python3 scripts/branches.py build/coverage build/coverage/branches.txt 95 law reference || missed+=(branches)
covered readers driver/yaml/ driver/read/ driver/import/ driver/table/ driver/base/ driver/calibrate/read_fit driver/sweep/read_sweep driver/report/read_result driver/results/result_layout -- --fail-under-line 95
[ "${#missed[@]}" -eq 0 ] || fail "a test or gcovr fails, or less is covered than the bars ask for: ${missed[*]}, see above"
say 'enough is covered'
