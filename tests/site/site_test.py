#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The documentation site: site_test.py --slipbench PROGRAM --source DIR [--site FOLDER]

It takes no more than some time of processors to build, all its links lead somewhere, nothing is fetched from elsewhere; in a browser its search
finds what a reader looks for, and its pages can be read, light, dark and on a phone.
--site takes a site that is built already.
"""
import argparse
import html.parser
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.parse

from browse import look

MOST = 300  # measures of the machine that building the site takes: 190 where it is idle, up to 230 beside compilers

failures = []


def expect(condition, message):
    """Notes a failure and goes on, so that one run shows all of them."""
    if not condition:
        failures.append(message)


class Page(html.parser.HTMLParser):
    """What a page refers to, and what can be referred to in it."""

    def __init__(self, path):
        super().__init__()
        self.links, self.fetched, self.names = [], [], set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.names |= {given[key] for key in ("id", "name") if given.get(key)}
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        elif tag == "link" and given.get("rel") not in ("canonical", "prev", "next"):
            self.fetched.append(given.get("href", ""))
        elif given.get("src"):
            self.fetched.append(given["src"])


def measure():
    """Measures the machine: the processor time of a fixed piece of work [s]."""
    begin = time.process_time()
    sorted(str(i) for i in range(1_000_000))
    return time.process_time() - begin


def check_links(site):
    pages = {path: Page(path) for path in site.rglob("*.html")}
    expect(len(pages) > 50, f"only {len(pages)} pages")
    count = 0
    for path, page in pages.items():
        # The reference of headers is doxygen's, as are its links.
        own = "api" not in path.relative_to(site).parts and path.name != "404.html"
        for target in page.links * own + page.fetched:
            address = urllib.parse.urlsplit(target)
            where = f"{path.relative_to(site)}: {target}"
            if target in page.fetched:
                expect(address.scheme in ("", "data", "javascript") and not address.netloc, f"{where}: fetched from elsewhere")
            if address.scheme or address.netloc or path.name == "404.html":
                continue
            count += 1
            to = (path.parent / urllib.parse.unquote(address.path)).resolve() if address.path else path
            to = to / "index.html" if to.is_dir() else to
            expect(to.is_file(), f"{where}: no such file")
            # A text for the bench in a page is no place in it.
            if address.fragment and to in pages and not address.fragment.startswith("text="):
                expect(urllib.parse.unquote(address.fragment) in pages[to].names | {"__skip"}, f"{where}: no such place")
    for path in site.rglob("*.css"):
        for target in re.findall(r"url\(\s*['\"]?([^)'\"]+)|@import\s+['\"]([^'\"]+)", path.read_text(errors="replace")):
            expect(not re.match(r"https?:|//", "".join(target)), f"{path.relative_to(site)}: fetches {target}")
    print(f"site: {len(pages)} pages, {count} links")


def check_nav(docs):
    nav = (docs / "site/mkdocs.yml").read_text()
    for page in (*docs.glob("guide/*.md"), *docs.glob("theory/*.md"), *docs.glob("tutorials/*.md")):
        expect(f"{page.relative_to(docs)}\n" in nav, f"docs/site/mkdocs.yml: nav lacks {page.relative_to(docs)}")


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--slipbench", required=True, type=pathlib.Path)
parser.add_argument("--source", required=True, type=pathlib.Path)
parser.add_argument("--site", type=pathlib.Path)
given = parser.parse_args()
with tempfile.TemporaryDirectory() as scratch:
    place = given.site
    if not place:
        if not shutil.which("mkdocs"):
            sys.exit("mkdocs is not there: install the Debian package mkdocs-material (scripts/setup.sh docs)")
        machine = measure()
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        built = subprocess.run([given.source / "scripts/docs.sh", given.slipbench.resolve(), scratch], capture_output=True, text=True,
                               env={**os.environ, "SLIPBENCH_SETUP": "skip"})
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        print(built.stdout, built.stderr, sep="")
        expect(built.returncode == 0, f"scripts/docs.sh ended with {built.returncode}")
        machine = max(machine, measure())
        print(f"site: {seconds:.0f} s of processors, {seconds / machine:.0f} times the measure of {machine:.2f} s")
        # A bound of seconds would judge the machine, and what else it does.
        expect(seconds < MOST * machine, f"the site takes {seconds / machine:.0f} times the measure, of at most {MOST}")
        place = pathlib.Path(scratch) / "site"
    check_nav(given.source / "docs")
    check_links(place.resolve())
    look(place.resolve(), scratch, given.source, given.slipbench.resolve(), expect)
print("\n".join(failures))
print(f"site: {len(failures)} failures")
sys.exit(1 if failures else 0)
