#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders the notebooks of this folder: render.py [--check] [NAME..]

A notebook is a Python file in percent format: a line `# %% [markdown]` begins a cell of text, `# %%` one of code, and words behind it are
what its pictures show. NAME.py becomes NAME.md, with what the cells print, the value of a last expression (none if it ends with a
semicolon) and, in images/, their figures. --check writes nothing; it fails if a text differs from the page, or a picture from the one that is kept.

Needs NumPy, SciPy and matplotlib, and slipbench on PYTHONPATH; the program is looked for beside the module, then on the PATH.
"""
import argparse
import ast
import contextlib
import difflib
import io
import math
import os
import pathlib
import re
import sys
import traceback
import warnings

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import slipbench  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent
STYLE = {
    "figure.figsize": (6.4, 3.6), "figure.constrained_layout.use": True, "font.size": 9.5, "axes.titlesize": 10.0,
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.7, "lines.linewidth": 1.4, "legend.frameon": False,
    "axes.prop_cycle": matplotlib.cycler(color=["#1f5fa8", "#b3261e", "#3a7d44", "#8a5a00", "#5b4a9c"]),
    "svg.hashsalt": "slipbench", "svg.fonttype": "path", "path.simplify": True, "path.simplify_threshold": 0.2,
}


def cells_of(text):
    """The cells of a notebook: (whether it is code, its title, its text, its first line)."""
    cells = []
    for number, line in enumerate(text.splitlines(), 1):
        mark = re.match(r"# %%(?: \[(markdown)\])? ?(.*)$", line)
        if mark:
            cells.append([mark.group(1) is None, mark.group(2).strip(), [], number + 1])
        elif cells:
            cells[-1][2].append(line)
    for code, title, lines, first in cells:
        body = "\n".join(lines) if code else "\n".join(re.sub(r"^# ?", "", line) for line in lines)
        before = len(body) - len(body.lstrip("\n"))
        yield code, title, body.strip("\n"), first + before


def run_cell(code, names, file, first):
    """Runs a cell; returns what it prints, and the value of its last expression as it is shown."""
    tree = ast.parse("\n" * (first - 1) + code, file)
    last = None
    if tree.body and isinstance(tree.body[-1], ast.Expr) and not code.rstrip().endswith(";"):
        last = ast.Expression(tree.body.pop().value)
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, file, "exec"), names)
        value = eval(compile(last, file, "eval"), names) if last else None
    shown = printed.getvalue()
    return shown if value is None else shown + repr(value) + "\n"


def render(file):
    """Runs a notebook from its first cell; returns its page and the pictures of its figures, {name: bytes}."""
    page, images, names = [], {}, {"__name__": "__main__"}
    with matplotlib.rc_context(STYLE), warnings.catch_warnings():
        for doubtful in (RuntimeWarning, slipbench.SlipbenchWarning):
            warnings.simplefilter("error", doubtful)
        for code, title, body, first in cells_of(file.read_text()):
            page.append(f"```python\n{body}\n```" if code else body)
            if not code:
                continue
            shown = run_cell(body, names, str(file), first)
            if shown:
                page.append("```text\n" + "\n".join(line.rstrip() for line in shown.rstrip().splitlines()) + "\n```")
            for number in plt.get_fignums():
                image = f"{file.stem}_{len(images) + 1}.svg"
                drawn = io.BytesIO()
                plt.figure(number).savefig(drawn, format="svg", metadata={"Date": None, "Creator": None})
                plt.close(number)
                images[image] = drawn.getvalue()
                page.append(f"![{title}](images/{image})")
                if not title:
                    raise ValueError(f"{file.name}:{first - 1}: a cell with a figure says what it shows: # %% WHAT")
    note = f"*Written by [render.py](render.py) from [{file.name}]({file.name}), which the tests run.*"
    return "\n\n".join([*page, note]) + "\n", images


def same_picture(one, other):
    """Tells whether two pictures have the same lines and words, whose places may differ by what no eye sees: a last digit of another library."""
    number = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")
    # Names of markers and of what is cut are made of all digits.
    parts = [re.sub(r'(id="|href="#|url\(#)\w+', r"\1", text) for text in (one, other)]
    words = [number.sub("0", part) for part in parts]
    numbers = zip(*(map(float, number.findall(part)) for part in parts))
    return words[0] == words[1] and all(math.isclose(a, b, rel_tol=0.0, abs_tol=0.01) for a, b in numbers)


def faults_of(file, folder=FOLDER):
    """What of a page is not what its notebook gives now, a text each."""
    page = folder / f"{file.stem}.md"
    text, images = render(file)
    found = page.read_text() if page.exists() else ""
    faults = []
    if text != found:
        lines = difflib.unified_diff(found.splitlines(), text.splitlines(), page.name, "now", lineterm="", n=1)
        faults.append("\n".join(lines))
    for image, drawn in images.items():
        path = folder / "images" / image
        if not path.exists():
            faults.append(f"{page.name}: images/{image} is not there")
        elif not same_picture(path.read_text(), drawn.decode()):
            faults.append(f"{page.name}: images/{image} is not what matplotlib {matplotlib.__version__} draws now")
    kept = {path.name for path in (folder / "images").glob(f"{file.stem}_[0-9].svg")}
    faults += [f"{page.name}: images/{image} is of no figure" for image in sorted(kept - set(images))]
    return faults


def put_program_on_path():
    """Puts the folder of the program that was built with the module, or installed with it, first on the PATH."""
    above = pathlib.Path(slipbench.__file__).parent.parents
    for folder in [above[1], *(one / "bin" for one in above)]:
        if os.access(folder / "slipbench", os.X_OK) and (folder / "slipbench").is_file():
            os.environ["PATH"] = f"{folder}{os.pathsep}{os.environ.get('PATH', '')}"
            return


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("names", nargs="*", metavar="NAME")
    options = parser.parse_args()
    files = [FOLDER / f"{pathlib.Path(name).stem}.py" for name in options.names] or sorted(FOLDER.glob("*.py"))
    put_program_on_path()
    failed = False
    for file in files:
        if file.name == pathlib.Path(__file__).name:
            continue
        try:
            if options.check:
                faults = faults_of(file)
            else:
                text, images = render(file)
                (FOLDER / "images").mkdir(exist_ok=True)
                for old in (FOLDER / "images").glob(f"{file.stem}_[0-9].svg"):
                    old.unlink()
                for name, drawn in images.items():
                    (FOLDER / "images" / name).write_bytes(drawn)
                (FOLDER / f"{file.stem}.md").write_text(text)
                faults = []
        except Exception:  # noqa: BLE001 - whatever a cell raises is told, and the next notebook is run
            faults = [traceback.format_exc()]
        failed |= bool(faults)
        print("\n".join([f"{file.stem}: {'FAILED' if faults else 'passed' if options.check else 'written'}", *faults]))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
