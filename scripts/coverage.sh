#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# coverage.sh: how many lines and branches of law/ and reference/ their own tests run, by gcovr. Branches that only an exception
# takes, or that the compiler makes where nothing leads, do not count. Fails with less than 98 % of lines or 95 % of branches.
# Takes about a quarter of an hour on two cores; build/coverage/lines.txt lists by file what was not run.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
programs=(law_tests property_tests reference_tests)

scripts/setup.sh mutation
configure coverage
say "building the tests with counters on $(nproc) cores"
build coverage --target "${programs[@]}"
find build/coverage -name '*.gcda' -delete
for program in "${programs[@]}"; do
  say "running $program"
  "build/coverage/tests/$program" >"build/coverage/$program.log" 2>&1 ||
    { tail -n 20 "build/coverage/$program.log" >&2; fail "$program fails, see above"; }
done
say 'counting'
gcovr --root . --object-directory build/coverage --filter 'law/' --filter 'reference/' \
  --exclude-throw-branches --exclude-unreachable-branches -j "$(nproc)" --txt build/coverage/lines.txt \
  --csv build/coverage/files.csv --print-summary --fail-under-line 98 --fail-under-branch 95 build/coverage ||
  fail 'less is covered than the bars ask for (or gcovr failed), see above and build/coverage/lines.txt'
say 'enough is covered'
