#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# files.sh COMPONENT ROOT DOC PACKAGE VERSION CONTACT: what SlipbenchDebianFiles.cmake wants in the usr folder ROOT of a package,
# whose documentation goes to DOC.
set -euo pipefail
component=$1 root=$2 doc=$3 package=$4 version=$5 contact=$6
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# Of one commit the same bytes, whenever and wherever they are packed.
date=$(date -u -R -d "@${SOURCE_DATE_EPOCH:-$(git -C "$source" log -1 --format=%ct 2>/dev/null || stat -c %Y "$source/CHANGELOG.md")}")

{
  printf '%s\n' 'Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/' 'Upstream-Name: slipbench' '' \
    'Files: *' 'Copyright: 2026 the slipbench authors' 'License: Apache-2.0'
  [ "$component" = dev ] || sed -n '/^Binaries/,$ {s/^$/./; s/^/ /; p}' "$source/NOTICE" | sed '1i Comment:'
  printf '%s\n' '' 'License: Apache-2.0' ' On Debian systems the text of the Apache License, version 2.0, is in' \
    ' /usr/share/common-licenses/Apache-2.0.'
} >"$doc/copyright"
printf '%s (%s) unstable; urgency=medium\n\n  * What changed is in CHANGELOG.md of the package slipbench.\n\n -- %s  %s\n' \
  "$package" "$version" "$contact" "$date" | gzip -9n >"$doc/changelog.gz"

# What CPack does in its own way, or a package of another number than the library's would cost, is known to lintian.
overrides=$root/share/lintian/overrides/$package
mkdir -p "$(dirname "$overrides")"
case "$component" in
  program | dev) printf '%s\n' '# CPack writes the call in place of a trigger.' "$package: maintscript-calls-ldconfig *" >"$overrides" ;;
esac
[ "$component" != dev ] || printf '%s\n' '# Before 1.0 the libraries of the C interface stand beside their headers.' \
  "$package: package-name-doesnt-match-sonames *" "$package: link-to-shared-library-in-wrong-package *" \
  '# They are found where the prefix is, wherever it is moved.' "$package: pkg-config-unavailable-for-cross-compilation *" >>"$overrides"
export LC_ALL=C.UTF-8 PATH=$root/bin:$PATH
pages=$root/share/man/man1
# page COMMAND NAME WHAT: a manual page of the command's --help.
page() {
  SOURCE_DATE_EPOCH=$(date -d "$date" +%s) help2man --no-info --section 1 --version-string "$version" --source "slipbench $version" \
    --name "$3" "$1" | sed "s/^\.TH [A-Z]*/.TH ${2^^}/; s/^$1 \\\\-/$2 \\\\-/" | gzip -9n >"$pages/$2.1.gz"
}
case "$component" in
  program) ;;
  mpi)
    mkdir -p "$pages"
    page slipbench-mpi slipbench-mpi 'sweeps and calibrations of slipbench over the ranks of MPI'
    exit 0
    ;;
  *) exit 0 ;;
esac
# The licence is among Debian's own.
rm -f "$root/share/doc/slipbench/LICENSE"
mkdir -p "$pages" "$root/share/bash-completion/completions" "$root/share/zsh/vendor-completions" "$root/share/fish/vendor_completions.d"
slipbench completion bash >"$root/share/bash-completion/completions/slipbench"
slipbench completion zsh >"$root/share/zsh/vendor-completions/_slipbench"
slipbench completion fish >"$root/share/fish/vendor_completions.d/slipbench.fish"
page slipbench slipbench 'test bench for connector friction'
slipbench --help | sed -n '/^Subcommands:/,/^$/ s/^  \([a-z]*\) \+\(.*\)/\1 \2/p' | while read -r name what; do
  page "slipbench $name" "slipbench-$name" "${what,}"
done
