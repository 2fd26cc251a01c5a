#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# package.sh: builds the program, the libraries and the Python module, and puts them into Debian packages in build/packages: slipbench,
# slipbench-mpi, libslipbench-dev and python3-slipbench, with their checksums. What lintian calls an error or a warning ends it with exit code 1.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
folder=build/packages

scripts/setup.sh package
say "building the packages' files on $(nproc) cores"
configure release
build release --target slipbench_parts
say 'packing'
rm -rf "$folder"
cpack --config build/release/CPackConfig.cmake -B "$folder" >build/packages.log 2>&1 || { cat build/packages.log >&2; fail 'cpack failed, see above'; }
rm -rf "$folder/_CPack_Packages"
(cd "$folder" && sha256sum ./*.deb >SHA256SUMS)
say 'asking lintian'
lintian --fail-on error,warning --allow-root "$folder"/*.deb || fail 'lintian found the above'
say "packages: $(cd "$folder" && echo ./*.deb)"
