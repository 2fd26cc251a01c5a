#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# minimal_debian.sh: installs the packages of build/packages (scripts/package.sh) in a minimal Debian of their own, made by debootstrap in
# a temporary folder, as root; runs and draws the case of README.md, looks for manual pages and completion, imports the module and compiles against the
# library. The installation of the program and the first picture may take 60 s. Exit: 0, or 1 and what went wrong.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../../scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../scripts/common.sh"
most=60

scripts/setup.sh package
packages=(build/packages/*.deb)
[ -f "${packages[0]}" ] || fail 'no packages in build/packages; scripts/package.sh makes them'
root=$(mktemp -d)
trap 'rm -rf --one-file-system "$root"' EXIT
say 'making a minimal Debian'
# shellcheck disable=SC2016  # apt's own word
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | head -n 1)
debootstrap --variant=minbase "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$root" "$mirror" >"$root.log" 2>&1 ||
  { tail -n 20 "$root.log" >&2; fail 'debootstrap failed, see above'; }
rm -f "$root.log"
cp /etc/resolv.conf /etc/hosts "$root/etc/"
cp "${packages[@]}" "$root/root/"
# shellcheck disable=SC2016  # a fence
sed -n '/^```yaml case shaft.yaml$/,/^```$/ {//!p}' README.md >"$root/root/shaft.yaml"

# inside COMMANDS: runs them there; mounts end with them.
inside() {
  unshare --mount --pid --fork --root="$root" --mount-proc env -i HOME=/root DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 \
    PATH=/usr/sbin:/usr/bin:/sbin:/bin bash -euc "cd /root; $1"
}
install() { inside "apt-get install -q -y $1 >install.log 2>&1 || { tail -n 20 install.log; exit 1; }"; }

# Manual pages are left out of a minimal Debian by a rule of dpkg's; here they are wanted.
rm -f "$root"/etc/dpkg/dpkg.cfg.d/*
say 'installing the program'
started=$(date +%s)
install ./slipbench_*.deb
inside 'slipbench run shaft.yaml && slipbench plot shaft.yaml -o shaft.svg'
taken=$(($(date +%s) - started))
grep -q '</svg>' "$root/root/shaft.svg" || fail 'the picture is not whole'
[ "$taken" -le "$most" ] || fail "installation and first picture took $taken s, more than $most"
say "installed, run and drawn in $taken s"
commands=$(inside 'slipbench --help' | sed -n '/^Subcommands:/,/^$/ s/^  \([a-z]*\) .*/\1/p')
[ "$(wc -w <<<"$commands")" -gt 10 ] || fail "only the commands $commands are in the help"
for name in '' $commands; do
  [ -s "$root/usr/share/man/man1/slipbench${name:+-$name}.1.gz" ] || fail "there is no manual page of slipbench $name"
done
for file in bash-completion/completions/slipbench zsh/vendor-completions/_slipbench fish/vendor_completions.d/slipbench.fish; do
  [ -s "$root/usr/share/$file" ] || fail "there is no $file"
done

if [ -f build/wasm/live.html ]; then
  inside 'slipbench report --live shaft.yaml -o live.html'
  cmp "$root/usr/share/slipbench/live.html" build/wasm/live.html || fail 'the bench in a page is older than the one built'
  [ "$(stat -c %s "$root/root/live.html")" -gt "$(stat -c %s build/wasm/live.html)" ] || fail 'the page does not hold the bench'
fi

say 'installing the module and the library'
install './python3-slipbench_*.deb ./libslipbench-dev_*.deb g++ pkg-config'
inside 'python3 -c "import slipbench; run = slipbench.load(\"shaft.yaml\").run(); assert len(run[\"CSF1\"]) > 100, run"'
cat >"$root/root/law.c" <<'C'
#include <slipbench/c/slip_law.h>
#include <stdio.h>
int main(void) { return slip_law_version() > 0 ? 0 : 1; }
C
# shellcheck disable=SC2016  # expanded inside
inside 'gcc law.c $(pkg-config --cflags --libs slipbench-c) -o law && ./law'
say 'all packages work'
