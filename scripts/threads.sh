#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# threads.sh [SECONDS]: the Python module in four threads under the thread sanitizer of g++: runs, updates of one law, sweeps. A race
# is printed, and ends it with exit code 66. The build takes some 12 minutes on two cores.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

folder=build/tsan-python
say 'building the Python module with the thread sanitizer'
# -O1: without any optimisation GCC does not take Eigen's prefetch.
cmake -S . -B "$folder" -G Ninja -D CMAKE_BUILD_TYPE=Debug -D CMAKE_UNITY_BUILD=ON -D SLIPBENCH_BUILD_TESTS=OFF -D SLIPBENCH_BUILD_BENCH=OFF \
  -D SLIPBENCH_INSTALL=OFF -D CMAKE_CXX_FLAGS="-O1 -g1 -fsanitize=thread" >/dev/null
cmake --build "$folder" --parallel "$(nproc)" --target slipbench_python
say 'running four threads'
# The memory keeps its layout, into which the sanitizer maps its own. Python is not compiled with it: only what reaches the module counts.
LD_PRELOAD=$(g++ -print-file-name=libtsan.so) TSAN_OPTIONS="halt_on_error=1 exitcode=66 ignore_noninstrumented_modules=1" \
  PYTHONPATH=$folder/python setarch -R /usr/bin/python3 tests/python/threads.py "${1:-10}"
