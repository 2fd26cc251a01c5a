#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# torture.sh [KILLS] [TRIAL,..]: ends run, check, calibrate, sweep and report at 300 random moments, interrupts them, and takes
# disk, memory, rights and inputs from them (tests/torture/torture.py): nothing half written has a final name, no temporary file
# is left, an interruption takes less than a second. 300 kills and the rest take 3 minutes. Exit: 0 as it should be, 1 not.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
kills=${1:-300}
[[ $kills =~ ^[0-9]+$ ]] || fail "wanted a number of kills, found '$kills'" 2

configure release
build release --target slipbench
say "torturing build/release/slipbench"
/usr/bin/python3 tests/torture/torture.py build/release/slipbench . --kills "$kills" --only "${2:-}" || fail 'something was not as it should be'
say 'done'
