#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The address and undefined-behaviour sanitizers on the tests of the law and of what reads text: YAML, units, numbers.
# Takes some 5 minutes on two cores, with the build. SLIPBENCH_PRESET=asan-ubsan scripts/test.sh runs all tests under them.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

configure asan-ubsan
say "building the tests of the law and of the reader's ground with sanitizers on $(nproc) cores"
build asan-ubsan --target law_tests ground_tests
say 'testing them'
exec ctest --preset asan-ubsan --parallel "$(nproc)" --no-label-summary \
  -R '^(law|driver/(base/(files|text|units)|yaml))/'
