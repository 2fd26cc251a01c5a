#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# setup.sh [docs|tests|farm|mutation|package|wasm]: installs the Debian packages of scripts/packages.txt that are missing, with `docs`
# those of scripts/packages-docs.txt too, with `tests` those of scripts/packages-test.txt besides (a browser among them), with `farm`
# those of scripts/packages-farm.txt as well (MPI, Slurm, Dask), with `mutation`, `package` or `wasm` those of scripts/packages-mutation.txt,
# scripts/packages-package.txt or scripts/packages-wasm.txt; with all there it touches nothing.
# Exit: 0 all there, 1 the installation failed, 2 a wrong argument, 4 no apt-get here (says what is needed), 5 not root and no sudo.
# SLIPBENCH_SETUP=skip leaves the machine as it is, for systems where the needs are met in another way.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

lists=(scripts/packages.txt)
case "$#:${1:-}" in
  0:) ;;
  1:docs) lists+=(scripts/packages-docs.txt) ;;
  1:tests) lists+=(scripts/packages-docs.txt scripts/packages-test.txt) ;;
  1:farm) lists+=(scripts/packages-docs.txt scripts/packages-test.txt scripts/packages-farm.txt) ;;
  1:mutation) lists+=(scripts/packages-mutation.txt) ;;
  1:package) lists+=(scripts/packages-package.txt) ;;
  1:wasm) lists+=(scripts/packages-wasm.txt) ;;
  *) fail "wanted nothing, 'docs', 'tests', 'farm', 'mutation', 'package' or 'wasm', found '$*'" 2 ;;
esac

[ "${SLIPBENCH_SETUP:-}" != skip ] || exit 0

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  {
    echo 'slipbench needs (the first word is the name of the Debian package):'
    grep -hv '^#' "${lists[@]}" | sed 's/^/  /'
  } >&2
  fail 'no apt-get on this system: install the above, then run again with SLIPBENCH_SETUP=skip' 4
fi

mapfile -t packages < <(awk '!/^#/ && NF {print $1}' "${lists[@]}")
installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${packages[@]}" 2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
  grep -qxF "$package installed" <<<"$installed" || missing+=("$package")
done
if [ "${#missing[@]}" -eq 0 ]; then
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null ||
    fail "not root and no sudo; as root run: apt-get install ${missing[*]}" 5
  as_root=(sudo)
  # Without a terminal nobody can type a password.
  [ -t 0 ] || as_root=(sudo -n)
fi
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 \
    apt-get -q -y -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=120 -o Acquire::Retries=3 "$@" </dev/null
}

log=$(mktemp)
trap 'rm -f "$log"' EXIT
die() {
  tail -n 20 "$log" >&2
  fail "$1"
}

say "installing ${missing[*]}"
# Package lists may be absent (a fresh machine) or out of date (a version that left the mirror):
# they are fetched only then. One broken source among several is apt's warning, not the end.
if ! apt install --no-install-recommends "${missing[@]}" >"$log" 2>&1; then
  say 'fetching package lists'
  apt update >"$log" 2>&1 || die 'apt-get update failed, see above'
  apt install --no-install-recommends "${missing[@]}" >>"$log" 2>&1 ||
    die 'apt-get install failed, see above (is the network up?)'
fi
say 'packages installed'
