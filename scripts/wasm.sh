#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# wasm.sh: builds the bench in a page, build/wasm/live.html, which `slipbench report --live` and the documentation site put
# into their pages. Libraries are compiled from the sources of the Debian packages that the program is built with: they
# are fetched from where this machine's apt has its packages, once. SLIPBENCH_SOURCES may name a folder that has them:
# what `apt-get source --download-only fmtlib gsl muparser yaml-cpp` brings.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scripts/setup.sh wasm
folder=$PWD/build/wasm
sources=$folder/sources
mkdir -p "$sources"

# apt-get source, from the sources of this machine's own package lists, in a configuration that leaves them alone.
fetch() {
  local apt=$folder/apt
  mkdir -p "$apt/parts" "$apt/lists/partial"
  for list in /etc/apt/sources.list.d/*.sources; do
    [ ! -e "$list" ] || sed 's/^Types:.*/Types: deb-src/' "$list" >"$apt/parts/$(basename "$list")"
  done
  cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null | sed -n 's/^deb /deb-src /p' >"$apt/parts/all.list" || true
  printf '%s\n' 'Dir::Etc::sourcelist "/dev/null";' "Dir::Etc::sourceparts \"$apt/parts\";" "Dir::State::lists \"$apt/lists\";" \
    'APT::Sandbox::User "root";' >"$apt/apt.conf"
  # Other people's repositories may have no sources; ours are looked for in those that have.
  APT_CONFIG=$apt/apt.conf apt-get -q update >"$apt/log" 2>&1 || true
  (cd "$sources" && APT_CONFIG=$apt/apt.conf apt-get -q source --download-only "$@" >>"$apt/log" 2>&1) ||
    { tail -n 20 "$apt/log" >&2; fail 'apt-get source failed, see above'; }
}

missing=()
declare -A headers=([fmtlib]=libfmt-dev [gsl]=libgsl-dev [muparser]=libmuparser-dev [yaml-cpp]=libyaml-cpp-dev)
for source in "${!headers[@]}"; do
  version=$(dpkg-query -W -f='${source:Version}' "${headers[$source]}")
  [ -z "${SLIPBENCH_SOURCES:-}" ] || cp -n "$SLIPBENCH_SOURCES/${source}_"* "$sources/"
  [ -e "$sources/${source}_${version#*:}.dsc" ] || missing+=("$source=$version")
done
if [ "${#missing[@]}" -gt 0 ]; then
  say "fetching sources: ${missing[*]}"
  fetch "${missing[@]}"
fi
for source in "${!headers[@]}"; do
  [ -e "$sources/$source" ] || dpkg-source -x "$sources/${source}_"*.dsc "$sources/$source" >"$folder/log" 2>&1 ||
    { cat "$folder/log" >&2; fail "unpacking $source failed, see above"; }
done

# Debian's emscripten finds its modules for Node where Debian's own Node looks for them; other builds of Node do not.
export NODE_PATH=/usr/share/nodejs
say 'building'
configure wasm
build wasm --target slipbench_live_page
say "built: build/wasm/live.html, $(($(stat -c %s build/wasm/live.html) / 1024)) KiB"
