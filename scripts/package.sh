#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# package.sh: builds the program, the libraries and the Python module, and puts them into build/packages, with their checksums: Debian
# packages slipbench, slipbench-mpi, libslipbench-dev and python3-slipbench, and slipbench-VERSION-linux-PROCESSOR.tar.gz, whose program
# needs nothing that is installed. The bench in a page is in the first and the last, if scripts/wasm.sh has built it. What lintian calls
# an error or a warning ends it with exit code 1.
# The sources of muParser come from where apt gets its packages, or from the folder SLIPBENCH_MUPARSER_SOURCE.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
folder=build/packages

# fetch_muparser: its sources of the version that is installed, into build/muparser, by apt and with its signatures. Lists are of
# binary packages mostly: the same places are asked for sources, beside the machine's own lists.
fetch_muparser() {
  local apt=$PWD/build/apt version list
  version=$(dpkg-query -W -f '${source:Version}' libmuparser-dev)
  [ "$(cat build/muparser/version 2>/dev/null)" != "$version" ] || return 0
  rm -rf "$apt" build/muparser
  mkdir -p "$apt"/{sources,lists/partial,cache/archives/partial} build/muparser
  for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.{sources,list}; do
    [ ! -f "$list" ] || sed 's/^Types:.*/Types: deb-src/; s/^deb /deb-src /' "$list" >"$apt/sources/$(basename "$list")"
  done
  local options=(-q -o Dir::Etc::SourceList=/dev/null -o "Dir::Etc::SourceParts=$apt/sources" -o "Dir::State::Lists=$apt/lists"
    -o "Dir::Cache=$apt/cache" -o APT::Sandbox::User=)
  { apt-get "${options[@]}" update && (cd build/muparser && apt-get "${options[@]}" source --only-source "muparser=$version"); } \
    >build/muparser.log 2>&1 || { tail -n 20 build/muparser.log >&2; fail 'the sources of muParser cannot be fetched, see above'; }
  mv build/muparser/muparser-*/* build/muparser/
  printf '%s\n' "$version" >build/muparser/version
}

# licences ROOT: the licences of all that the program of a tarball contains, told by what the linker has read, and how to make it again.
licences() {
  local to=$1/share/doc/slipbench/licences packages package
  mkdir -p "$to"
  # In the program with their headers or as a text; muParser by its sources.
  packages=(libeigen3-dev libfmt-dev libcli11-dev libexpected-dev libjs-chart.js libmuparser-dev libudunits2-data)
  mapfile -t -O "${#packages[@]}" packages < <(awk '/^LOAD \/.*\.a$/ {print $2}' build/release/static/slipbench.map | grep -v "^$PWD/" |
    xargs realpath | sort -u | xargs dpkg -S | cut -d: -f1 | sort -u)
  {
    printf '%s\n' "slipbench is licensed under the Apache License 2.0 (LICENSE). The program bin/slipbench of this archive is linked with the" \
      "GNU Scientific Library, so that as a whole it is under the terms of the GNU General Public License, version 3 or later" \
      "(licences/GPL-3): whoever passes it on passes on these terms, and the sources." '' \
      "Those of slipbench: version $2, $(build/release/slipbench --version --verbose | grep '^commit'); scripts/package.sh makes this archive of them." \
      "Those of all else in it are the source packages of Debian below, got by 'apt-get source NAME=VERSION'." \
      "The licence of each is the file of its name in licences/." '' "$(printf '%-20s %-20s %s' package source version)"
    dpkg-query -W -f '${Package} ${source:Package} ${source:Version}\n' "${packages[@]}" | sort -u | while read -r package source version; do
      printf '%-20s %-20s %s\n' "$package" "$source" "$version"
    done
  } >"$1/share/doc/slipbench/LICENCES"
  for package in "${packages[@]}"; do
    cp -L "/usr/share/doc/$package/copyright" "$to/$package"
  done
  # The texts that those name.
  (cd "$to" && grep -hoE '/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]' ./* | sort -u | xargs -I{} cp -L {} .)
  [ -f "$to/GPL-3" ] || fail 'no library names the GPL: has the program another licence than its note says?'
}

# pack_static: the tarball, of the files of the Debian package and the program that needs no libraries.
pack_static() {
  local version name stage
  version=$(dpkg-deb -f "$folder"/slipbench_*.deb Version)
  name=slipbench-$version-linux-$(uname -m)
  stage=$(mktemp -d)
  dpkg-deb -x "$folder"/slipbench_*.deb "$stage"
  mv "$stage/usr" "$stage/$name"
  rm -r "$stage/$name/lib/slipbench/slipbench-hdf5.so" "$stage/$name/share/lintian" "$stage/$name/share/doc/slipbench/copyright"
  strip -o "$stage/$name/bin/slipbench" build/release/static/slipbench
  mkdir "$stage/$name/share/slipbench/units"
  cp /usr/share/xml/udunits/*.xml "$stage/$name/share/slipbench/units/"
  cp LICENSE "$stage/$name/share/doc/slipbench/"
  licences "$stage/$name" "$version"
  tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$(git log -1 --format=%ct 2>/dev/null || stat -c %Y CHANGELOG.md)" \
    -C "$stage" -c "$name" | gzip -9n >"$folder/$name.tar.gz"
  rm -r "$stage"
}

scripts/setup.sh package
if [ -z "${SLIPBENCH_MUPARSER_SOURCE:-}" ]; then
  say 'getting the sources of muParser'
  fetch_muparser
fi
say "building the packages' files on $(nproc) cores"
configure release -D "SLIPBENCH_MUPARSER_SOURCE=${SLIPBENCH_MUPARSER_SOURCE:-$PWD/build/muparser}"
build release --target slipbench_parts slipbench_static
say 'packing'
rm -rf "$folder"
cpack --config build/release/CPackConfig.cmake -B "$folder" >build/packages.log 2>&1 || { cat build/packages.log >&2; fail 'cpack failed, see above'; }
rm -rf "$folder/_CPack_Packages"
pack_static
(cd "$folder" && sha256sum ./*.deb ./*.tar.gz >SHA256SUMS)
say 'asking lintian'
lintian --fail-on error,warning --allow-root "$folder"/*.deb || fail 'lintian found the above'
say "packages: $(cd "$folder" && echo ./*.deb ./*.tar.gz)"
