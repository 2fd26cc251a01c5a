#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bare_root.sh: unpacks the tarball of build/packages (scripts/package.sh) into an empty root, where nothing else is, no library, no
# shell, and runs its program there, as root: its cases pass their checks, a case gives the bytes that the built program gives, units
# are converted, a report and a functional mock-up unit are written, and what cannot be had is told. Exit: 0, or 1 and what went wrong.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../../scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/common.sh"

tarballs=(build/packages/slipbench-*-linux-*.tar.gz)
[ -f "${tarballs[0]}" ] || fail 'no tarball in build/packages; scripts/package.sh makes it'
root=$(mktemp -d)
trap 'rm -rf --one-file-system "$root"' EXIT
tar -xzf "${tarballs[0]}" -C "$root" --strip-components=1
mkdir "$root/proc" "$root/data" "$root/built"

# inside ARGUMENT..: the program, with nothing but a file system of processes, as every Linux has it.
inside() {
  env -i "$(command -v unshare)" --mount --pid --fork --root="$root" --mount-proc /bin/slipbench "$@" 2>&1
}
# says WORDS ARGUMENT..: the program says that, whatever its exit code is.
says() {
  local said
  said=$(inside "${@:2}") || true
  grep -qF -- "$1" <<<"$said" || fail "slipbench ${*:2} does not say '$1': $said"
}

! readelf -lW "$root/bin/slipbench" | grep -qE 'INTERP|DYNAMIC' || fail 'the program is not static'
say "$(inside --version)"
says ' 0 failed' check /share/slipbench/cases/examples /share/slipbench/cases/verification
for name in shock_absorber belt hinge_wear stick_slip_belt; do
  inside run "/share/slipbench/cases/examples/$name.yaml" -o /data >/dev/null
  build/release/slipbench run "cases/examples/$name.yaml" -o "$root/built" >/dev/null
  cmp "$root/data/$name.csv" "$root/built/$name.csv" || fail "$name: other rows than the program of build/release writes"
done
inside new HINGE -o /data/first.yaml >/dev/null
sed -i 's/R_p: 5 /R_p: 25.4 /; s/predefined: {R_p: = R_p/predefined: {R_p: 1 in/' "$root/data/first.yaml"
grep -q '1 in' "$root/data/first.yaml" || fail 'the case of a HINGE has no R_p'
says PASS run /data/first.yaml -o /data
inside report /data/first.yaml -o /data/first.html >/dev/null
grep -q '</html>' "$root/data/first.html" || fail 'the report is not whole'
inside export /data/first.yaml --to fmu -o /data/first.fmu >/dev/null
[ -s "$root/data/first.fmu" ] || fail 'no functional mock-up unit is written'
says 'linked without libraries' run /data/first.yaml -o /data --format h5
says gnuplot plot /data/first.yaml -o /data/first.svg
for name in gsl yaml-cpp udunits2 muparser expat1 minizip md fmt cli11 eigen3 c6; do
  [ -s "$root/share/doc/slipbench/licences/lib$name-dev" ] || fail "no licence of lib$name-dev"
done
grep -q 'GNU Scientific Library' "$root/share/doc/slipbench/LICENCES" || fail 'no word of the GPL'
say 'the tarball works in an empty root'
