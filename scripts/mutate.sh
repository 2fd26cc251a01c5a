#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# mutate.sh [--commit COMMIT] [--all | --count N --seed N] [--no-cases] [FILE..]: mutation tests of law/. All mutants are
# compiled in one build, each behind a switch; one is caught where a test that reaches it fails. Without FILE a sample over all
# files. The build takes about a quarter of an hour on two cores, a sample of 600 about another half, all of them a night.
# Exit: 0, or 1 if a mutant that tests/mutation/equivalent.txt does not explain survives or is not reached.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
commit=
if [ "${1:-}" = --commit ]; then
  commit=${2:?wanted a commit}
  shift 2
fi
targets=(law_tests property_tests)
[[ " $* " == *' --no-cases '* ]] || targets+=(slipbench)

scripts/setup.sh mutation
top=$PWD/build/mutate
rm -rf "$top/project"
mkdir -p "$top/project"
if [ -n "$commit" ]; then
  git archive "$commit" | tar -x -C "$top/project"
else
  git ls-files -z --deduplicate | xargs -0 ls -d 2>/dev/null | tar -c -T - | tar -x -C "$top/project"
fi
# settings FOLDER BUILD: bounds of arrays are checked, and errors of the compiler's own warnings do not count.
settings() {
  cmake -S "$1" -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE='-O1 -D_GLIBCXX_ASSERTIONS -w' \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_UNITY_BUILD=ON -DSLIPBENCH_BUILD_BENCH=OFF -DSLIPBENCH_PYTHON=OFF \
    -DSLIPBENCH_INSTALL=OFF >"$top/cmake.log" 2>&1 || { cat "$top/cmake.log" >&2; fail 'configuring failed, see above'; }
}
settings "$top/project" "$top/flags"
say 'rewriting the law'
/usr/bin/python3 tests/mutation/rewrite.py "$top/project" "$top/src" "$top/flags/compile_commands.json"
settings "$top/src" "$top/out"
say "building it on $(nproc) cores"
cmake --build "$top/out" --parallel "$(nproc)" --target "${targets[@]}" 2>&1 | show_tenths
say 'running tests against the mutants'
/usr/bin/python3 tests/mutation/judge.py "$top/out" "$top/src" --results "$top/verdicts.jsonl" "$@"
