#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# docs.sh [PROGRAM [FOLDER]]: builds the documentation site into FOLDER/site, to be opened at index.html, with or without a
# server; FOLDER is build. PROGRAM is the slipbench that draws the pictures and tells the reference; without it
# build/release/slipbench is built. A warning of mkdocs or doxygen is an error.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
slipbench=${1:-build/release/slipbench}
folder=$(realpath -m "${2:-build}")

scripts/setup.sh docs
if [ $# -eq 0 ]; then
  say 'building the program'
  configure release
  build release --target slipbench slipbench_fmu slipbench_python
fi

say 'laying the pages together'
export SLIPBENCH_PAGES=$folder/docs
rm -rf "$SLIPBENCH_PAGES"
mkdir -p "$SLIPBENCH_PAGES/assets/katex"
/usr/bin/python3 -B docs/site/pages.py "$slipbench" "$SLIPBENCH_PAGES"
cp -L /usr/share/javascript/katex/katex.min.{js,css} "$SLIPBENCH_PAGES/assets/katex/"
cp -LR /usr/share/javascript/katex/fonts "$SLIPBENCH_PAGES/assets/katex/"
{
  cat docs/Doxyfile
  printf '%s\n' "OUTPUT_DIRECTORY = \"$SLIPBENCH_PAGES\"" 'HTML_OUTPUT = api' 'INPUT = law reference c' 'VERBATIM_HEADERS = NO'
} | doxygen - || fail 'doxygen found the above'

say 'building the site'
PYTHONDONTWRITEBYTECODE=1 mkdocs build --strict --clean --config-file docs/site/mkdocs.yml --site-dir "$folder/site" 2>&1 |
  { grep -E 'WARNING|ERROR|Error' || true; } || fail 'mkdocs found the above'
say "site built: $folder/site/index.html"
