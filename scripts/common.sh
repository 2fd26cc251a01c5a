# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# What the scripts share. Sourced after `set -euo pipefail`; leaves the shell in the project's root.

export LC_ALL=C.UTF-8
unset CDPATH
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit

# Also over the scripts that one script calls, time counts from the first.
SLIPBENCH_STARTED=${SLIPBENCH_STARTED:-$(date +%s)}
export SLIPBENCH_STARTED

# say TEXT: one line of progress with the seconds since the start.
say() { printf '[%3d s] %s\n' "$(($(date +%s) - SLIPBENCH_STARTED))" "$1"; }

# fail TEXT [CODE]: one line that says what is wrong, and the end.
fail() {
  printf '%s: error: %s\n' "$(basename "$0")" "$1" >&2
  exit "${2:-1}"
}

# configure PRESET [OPTION..]: quiet unless it fails.
configure() {
  local output
  output=$(cmake --preset "$@" 2>&1) ||
    { printf '%s\n' "$output" >&2; fail "configuring preset '$1' failed, see above"; }
}

# build PRESET [--target NAME]: a terminal shows ninja's moving line; a log a line for each tenth, and what goes wrong.
build() {
  local command=(cmake --build --preset "$1" --parallel "$(nproc)" "${@:2}")
  if [ -t 1 ]; then
    "${command[@]}"
  else
    "${command[@]}" 2>&1 | show_tenths
  fi || fail "building preset '$1' failed, see above"
}

show_tenths() {
  local line said=0 tenth
  while IFS= read -r line; do
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
      tenth=$((10 * BASH_REMATCH[1] / BASH_REMATCH[2]))
      [ "$tenth" -le "$said" ] || say "  ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]} built"
      said=$tenth
    else
      printf '%s\n' "$line"
    fi
  done
}
