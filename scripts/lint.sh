#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# lint.sh [COMMIT]: clang-format and clang-tidy on the C++ files that differ from COMMIT. By default from where the branch left
# origin/main or main, and on main itself from the commit before. A header is read by clang-tidy as a part of
# one source that includes it, and only findings in files of the change count.
# SLIPBENCH_BASE names COMMIT, too; SLIPBENCH_TIDY_SOURCES is how many sources clang-tidy reads at most.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
base=${1:-${SLIPBENCH_BASE:-}}
most=${SLIPBENCH_TIDY_SOURCES:-40}
database=build/lint/compile_commands.json

# find_base: sets base, or leaves it empty and says in why_none why there is none.
find_base() {
  local branch
  if ! command -v git >/dev/null; then
    why_none='there is no git here'
    return
  fi
  if [ "$(git rev-parse --show-toplevel 2>/dev/null)" != "$PWD" ]; then
    why_none='this is no git repository'
    return
  fi
  if [ -n "$base" ]; then
    git rev-parse -q --verify "$base^{commit}" >/dev/null || fail "there is no commit '$base' here" 2
    return
  fi
  for branch in origin/main main; do
    base=$(git merge-base HEAD "$branch" 2>/dev/null) && break
  done
  if [ -z "$base" ] || [ "$base" = "$(git rev-parse HEAD)" ]; then
    base=$(git rev-parse -q --verify 'HEAD~1^{commit}') || why_none='there is no commit before this one (the first, or a shallow clone)'
  fi
}

# source_of HEADER: prints a source that includes it, itself or through other headers.
source_of() {
  local names=("$1") seen=() found sources
  while [ "${#names[@]}" -gt 0 ]; do
    seen+=("${names[@]}")
    mapfile -t found < <(git grep --untracked -lF "${names[@]/#/-e#include \"}" -- '*.cpp' '*.hpp')
    mapfile -t sources < <(printf '%s\n' "${found[@]}" | grep -Fx -f <(compiled))
    if [ "${#sources[@]}" -gt 0 ]; then
      # The header's own source, if it has one; then one that is read anyway.
      printf '%s\n' "${sources[@]}" | grep -Fx "${1%.hpp}.cpp" ||
        printf '%s\n' "${sources[@]}" | grep -Fxm1 -f <(printf '%s\n' "${changed[@]}") || printf '%s\n' "${sources[0]}"
      return
    fi
    mapfile -t names < <(printf '%s\n' "${found[@]}" | grep '\.hpp$' | grep -Fxv -f <(printf '%s\n' "${seen[@]}"))
  done
}

# compiled: prints the sources of the compile database.
compiled() { sed -n "s|^ *\"file\": \"$PWD/\(.*\)\".*|\1|p" "$database"; }

why_none=
find_base
if [ -n "$why_none" ]; then
  mapfile -t changed < <(find bench driver law reference tests -name '*.[ch]pp' | sort)
  say "what has changed is not known, $why_none: clang-format reads all ${#changed[@]} files, clang-tidy none; lint.sh COMMIT names a base"
else
  mapfile -t changed < <({
    git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.hpp'
    git ls-files --others --exclude-standard -- '*.cpp' '*.hpp'
  } | sort -u)
  say "${#changed[@]} C++ files changed since $(git log -1 --format='%h (%s)' "$base")"
fi
[ "${#changed[@]}" -gt 0 ] || exit 0

clang-format-14 --dry-run -Werror "${changed[@]}" || fail "run clang-format-14 -i on the files above"
say "clang-format finds nothing"
[ -z "$why_none" ] || exit 0

configure lint
sources=()
for file in "${changed[@]}"; do
  case "$file" in
    *.cpp) source=$(compiled | grep -Fx "$file" || true) ;;
    *.hpp) source=$(source_of "$file" || true) ;;
  esac
  if [ -n "$source" ]; then sources+=("$source"); else say "clang-tidy does not read $file: no source of the build has it"; fi
done
mapfile -t sources < <(printf '%s\n' "${sources[@]}" | sort -u | grep .)
[ "${#sources[@]}" -gt 0 ] || { say 'clang-tidy has nothing to read'; exit 0; }
if [ "${#sources[@]}" -gt "$most" ]; then
  say "clang-tidy reads $most of ${#sources[@]} sources; SLIPBENCH_TIDY_SOURCES=${#sources[@]} has it read all"
  sources=("${sources[@]:0:most}")
fi
filter=$(printf ',{"name":"%s"}' "${changed[@]/#//}")
# What it says on standard error is how much it left out; a source that cannot be read is a finding.
printf '%s\0' "${sources[@]}" | xargs -0 -r -n 1 -P "$(nproc)" clang-tidy-14 -p build/lint --quiet \
  --warnings-as-errors='*' --line-filter="[${filter:1}]" 2>/dev/null || fail 'clang-tidy-14 found the above'
say "clang-tidy finds nothing in ${#sources[@]} sources"
