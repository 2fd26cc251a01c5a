#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sets up, builds everything and runs all tests; arguments go to ctest (-L unit, -R hinge, ...).
# SLIPBENCH_PRESET=dev|asan-ubsan|coverage picks another preset than release.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
preset=${SLIPBENCH_PRESET:-release}

scripts/setup.sh tests
say "building preset '$preset' on $(nproc) cores"
configure "$preset"
build "$preset"
say 'testing'
# The last lines are ctest's own.
exec ctest --preset "$preset" --parallel "$(nproc)" --no-label-summary "$@"
