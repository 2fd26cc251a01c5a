#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""bundle.py CORE.js CALL.js CORE.wasm CODEMIRROR OUT LICENCE..: what a page needs of the bench and its editor as one piece of HTML, with the
licences of what is in it, as the Debian packages of their sources tell them."""
import base64
import gzip
import sys
from pathlib import Path


def main(core, call, program, codemirror, out, *licences):
    def text(name):
        content = Path(name).read_text(encoding="utf-8")
        if "</script" in content.lower() or "</style" in content.lower():
            sys.exit(f"{name} would end the element that it stands in")
        return content

    scripts = ["lib/codemirror.js", "mode/yaml/yaml.js", "addon/hint/show-hint.js"]
    styles = ["lib/codemirror.css", "addon/hint/show-hint.css"]
    # The same program gives the same bytes.
    packed = base64.b64encode(gzip.compress(Path(program).read_bytes(), 9, mtime=0)).decode()
    parts = ["<style>\n" + "\n".join(text(f"{codemirror}/{name}") for name in styles) + "</style>\n"]
    parts += [f"<script>\n{text(name)}</script>\n" for name in [*(f"{codemirror}/{name}" for name in scripts), core, call]]
    parts.append(f'<script type="text/plain" id="core">{packed}</script>\n')
    told = "".join(f"==== {name} ====\n{text(name)}\n" for name in licences)
    parts.append(f'<script type="text/plain" id="licences">\n{told}</script>\n')
    Path(out).write_text("".join(parts), encoding="utf-8")


main(*sys.argv[1:])
