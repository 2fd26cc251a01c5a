#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of the links of all .md files in a folder: links_test.py --source DIR

  - a relative link leads to a file or folder that is there, and its anchor to a heading of that file
  - every page of docs/guide, docs/theory and docs/tutorials begins with a list of all its sections, and the README.md beside it
    lists every page with its sections
  - no line of those pages has 160 characters or more, but for rows of tables and what a program reads or prints

Web addresses are not looked up. Needs nothing beside python3.
"""

import argparse
import pathlib
import re
import sys
import tempfile

LINK = re.compile(r"\]\(<?([^)\s>]+)>?\)")
failures = []
counts = {"files": 0, "links": 0, "anchors": 0}


def expect(condition, message):
    """Notes a failure and goes on, so that one run shows all of them."""
    if not condition:
        failures.append(message)


def numbered_text(path):
    """(line number, line) outside of fences, with code spans blanked: there brackets are no links."""
    fence = None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        mark = re.match(r"\s*(```+|~~~+)", line)
        if mark and fence is None:
            fence = mark.group(1)
        elif fence and line.strip() == fence:
            fence = None
        elif fence is None:
            yield number, line


def headings(path):
    """(level, title, anchor) of each heading; an anchor that occurs again is numbered, as the web page does it."""
    seen, found = {}, []
    for _, line in numbered_text(path):
        heading = re.match(r"(#+) +(.*?) *#*$", line)
        if heading:
            plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.group(2)).lower()
            anchor = re.sub(r"[^\w\- ]", "", plain).strip().replace(" ", "-")
            seen[anchor] = seen.get(anchor, -1) + 1
            found.append((len(heading.group(1)), heading.group(2), anchor + (f"-{seen[anchor]}" if seen[anchor] else "")))
    return found


def links(path):
    """(line number, target) of each link but web addresses."""
    for number, line in numbered_text(path):
        for target in LINK.findall(re.sub(r"`[^`]*`", "``", line)):
            if not re.match(r"\w+:", target):
                yield number, target


def check_links(path, root):
    counts["files"] += 1
    for number, target in links(path):
        counts["links"] += 1
        name, _, anchor = target.partition("#")
        place = (path.parent / name).resolve() if name else path
        where = f"{path.relative_to(root)}:{number}: {target}"
        if not place.exists():
            expect(False, f"{where}: no such file")
        elif not place.is_relative_to(root):
            expect(False, f"{where}: outside of the project")
        elif anchor:
            counts["anchors"] += 1
            expect(place.suffix == ".md" and anchor in [a for _, _, a in headings(place)], f"{where}: no such heading")


def check_contents(folder, root):
    index = folder / "README.md"
    listed = {target for _, target in links(index)}
    for page in sorted(folder.glob("*.md")):
        name = page.relative_to(root)
        sections = [(level, title, anchor) for level, title, anchor in headings(page) if level > 1]
        own = {target for _, target in links(page)}
        expect(page == index or page.name in listed, f"{folder.relative_to(root)}/README.md: does not list {page.name}")
        for level, title, anchor in sections:
            expect(page == index or level > 3 or f"#{anchor}" in own, f"{name}: its contents do not list '{title}'")
            target = f"#{anchor}" if page == index else f"{page.name}#{anchor}"
            expect(level > 2 or target in listed, f"{folder.relative_to(root)}/README.md: does not list '{title}' of {page.name}")
        for number, line in numbered_text(page):
            expect(len(line) < 160 or line.startswith("|"), f"{name}:{number}: {len(line)} characters")


def check(root):
    root = root.resolve()
    for path in sorted(root.rglob("*.md")):
        # Hidden folders and folders of builds hold no pages of the project; tests/site follows the links of the site's own.
        parts = path.relative_to(root).parts
        if parts[:2] != ("docs", "site") and not any(part.startswith(".") or part == "build" for part in parts):
            check_links(path, root)
    for folder in ("docs/guide", "docs/theory", "docs/tutorials"):
        check_contents(root / folder, root)


def check_itself():
    """Faults of every kind in a small folder are found, and nothing else."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name in ("docs/guide", "docs/theory", "docs/tutorials"):
            (root / name).mkdir(parents=True)
            (root / name / "README.md").write_text("# Pages\n\n[page](page.md): [A b](page.md#a-b)\n")
            (root / name / "page.md").write_text("# Page\n\n- [A b](#a-b)\n\n## A b\n\n`[x](no.md)`\n")
        check(root)
        expect(not failures, f"sound pages fail: {failures}")
        failures.clear()
        (root / "docs/guide/page.md").write_text("# Page\n\n[no](no.md) [no](#no) [up](../../../up.md)\n\n## A b\n\n"
                                                 "## C\n\n" + "long " * 40 + "\n")
        check(root)
        wanted = ("page.md:3: no.md: no such file", "page.md:3: #no: no such heading", "up.md: no such file",
                  "page.md: its contents do not list 'A b'", "README.md: does not list 'C' of page.md",
                  "page.md: its contents do not list 'C'", "page.md:9: 200 characters")
        found = list(failures)
        failures.clear()
        for want in wanted:
            expect(any(want in one for one in found), f"not found: {want}; found {found}")
        expect(len(found) == len(wanted), f"found {found}")
    counts.update(files=0, links=0, anchors=0)


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--source", required=True, type=pathlib.Path)
check_itself()
check(parser.parse_args().source)
print("\n".join(failures))
print(f"links: {counts['files']} files, {counts['links']} links, {counts['anchors']} anchors, {len(failures)} failures")
sys.exit(1 if failures else 0)
