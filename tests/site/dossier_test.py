#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The validation dossier: dossier_test.py --slipbench PROGRAM --source DIR

Each claim that the program lists has a row, its numbers are those of a run of the checks, the commands it shows run them, and a case that is
damaged turns the rows of its claims red and those of no others. Decks have their pictures, and their round trips are judged.
"""
import argparse
import collections
import html
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

import yaml

failures = []


def expect(condition, message):
    """Notes a failure and goes on, so that one run shows all of them."""
    if not condition:
        failures.append(message)


def say(*words, folder=None):
    return subprocess.run([given.slipbench, *words], capture_output=True, text=True, cwd=folder)


def rows(folder):
    """The rows of the table at the head, {(group, claim): (class, [texts of its cells])}."""
    place = re.search(r'data-table="(\d+)"', (folder / "dossier.md").read_text())[1]
    found = re.findall(r'<tr class="([\w-]+)" data-claim="([\w-]+)/([^"]*)">(.*?)</tr>', (folder / f".tables/{place}.html").read_text(), re.DOTALL)
    return {(group, html.unescape(name)): (
        verdict, [html.unescape(re.sub(r"<[^>]*>", " ", cell)).strip() for cell in re.findall(r"<td[^>]*>(.*?)</td>", cells)])
            for verdict, group, name, cells in found}


def written(cases, folder):
    """The head table of a dossier of some cases."""
    dossier.write(pages.Site(given.slipbench, folder), cases, draw=False)
    return rows(folder)


def check_claims(table):
    for group in ("laws", "connections", "closed-forms", "curves", "criteria", "keys"):
        lines = [line for line in say("list", group).stdout.splitlines() if line.startswith("  ")]
        for line in lines:
            rowed = [name for where, name in table if where == group and line.startswith(f"  {name} ")]
            expect(rowed or group == "keys" and line.split()[0] in required, f"no row of {group}: {line}")
        expect(len([1 for where, _ in table if where == group]) <= len(lines), f"more rows of {group} than the program lists")
    for program in say("export", "--help").stdout.partition("--to ")[2].split()[0].split("|"):
        expect(("decks", f"export --to {program}") in table, f"no row of export --to {program}")
    for program in ("abaqus", "radioss", "lsdyna", "opensees"):
        expect(("decks", f"import {program}") in table, f"no row of import {program}")


def check_numbers(table, told):
    """Counts and worst numbers, found again from the cases' files and the verdicts alone."""
    checks = collections.defaultdict(list)
    for case in told:
        for asked, found in zip(yaml.safe_load((given.source / case["file"]).read_text())["checks"], case["checks"]):
            measures = [one for one in found["measures"] if one["tolerance"] is not None] or [
                {"deviation": found["worst_deviation"], "tolerance": found["tolerance"]}]
            share = max(one["deviation"] / one["tolerance"] if one["tolerance"] else 0 for one in measures)
            for key in (("closed-forms", asked["against"].get("closed_form")), ("curves", asked["against"].get("curve"))):
                checks[key].append((case["case"], share))
    for (group, name), (verdict, cells) in table.items():
        if group not in ("closed-forms", "curves"):
            continue
        own = [one for one in checks[group, name] if one]
        minimal = sum(f"closed_form: {name}," in case for case in minimal_cases) if group == "closed-forms" else 0
        expect(int(cells[3]) == len(own) + minimal, f"{name}: {cells[3]} checks in place of {len(own)} and {minimal}")
        expect(verdict == ("passed" if own else "not-shown"), f"{name}: {verdict}")
        if own:
            worst = max(share for _, share in own)
            number = 0.0 if cells[4] == "0" else float(cells[4].strip("<% ")) / 100
            expect(abs(number - worst) <= 1e-4, f"{name}: worst {cells[4]} in place of {worst:.6f}")


def check_kinds(table):
    """Kinds of truth are what curves and cases say."""
    for key, kinds in ((("curves", "calculix_sine"), "run of CalculiX 4 computed apart 2"), (("curves", "dahl_loop"), "closed form 3"),
                       (("laws", "renard"), "run of OpenRadioss"), (("keys", "dynamics"), "published number 3")):
        expect(kinds in " ".join(table[key][1][1].split()), f"{key}: its kinds of truth are {table[key][1][1]}")


def check_commands(folder):
    """Each command of the page of curves, run as it stands, says as many cases passed as it names."""
    text = html.unescape((folder / "dossier/curves.md").read_text())
    commands = re.findall(r"<pre><code>(slipbench check [^<]*)</code>", text)
    expect(len(commands) >= 15, f"only {len(commands)} commands")
    for command in commands:
        done = say(*shlex.split(command)[1:], folder=given.source)
        expect(f"{len(shlex.split(command)) - 2} case" in done.stdout and done.returncode == 0, f"{command}: {done.stdout}{done.stderr}")


def check_decks(table, folder):
    """Each claim on decks that has checks has its picture, light and dark; a round trip is judged where its export tells no loss of the law."""
    sections = re.split(r"^## ", (folder / "dossier/decks.md").read_text(), flags=re.MULTILINE)[1:]
    for section in sections:
        name = section.split(" {", 1)[0]
        verdict, cells = table["decks", name]
        if cells[3] == "0":
            continue
        pictures = re.findall(r"!\[[^\]]+\]\((\S+\.svg)#only-(light|dark)\)", section)
        expect([look for _, look in pictures] == ["light", "dark"], f"{name}: its pictures are {pictures}")
        for picture, _ in pictures:
            path = folder / "dossier" / picture
            expect(path.exists() and "<path" in path.read_text(), f"{name}: {picture} is no picture")
        if name.split()[-1] in ("abaqus", "radioss", "lsdyna", "opensees", "table"):
            expect(verdict == "passed" and re.match(r"(<? ?[\d.]+ %|0)(;|$)", cells[4]), f"{name}: {verdict}, {cells[4]}: none of its round trips is judged")
    for off, losses, wanted in ((0.0, {}, "passed"), (0.9e-12, {"dropped": ["checks: a deck has none"]}, "passed"),
                                (1.1e-12, {"dropped": ["history: x"]}, "failed"), (1.1e-12, {"approximated": ["coefficient: a table"]}, "told"), (0.0, {"dropped": ["force_limit: x"]}, "told")):
        told = {"text": "", "force_most": 300 * off, "force_largest": 300, "rows_without_counterpart": 0}
        found = dossier_evidence.round_trip("a case", told, losses, "").verdict()
        expect(found == wanted, f"a round trip off by {off} of its force, with {losses}: {found}")


def check_damage(sound, scratch):
    """A case with another law: the rows that it holds are red, and the others as before."""
    cases = scratch / "damaged/cases"
    shutil.copytree(given.source / "cases", cases, ignore=shutil.ignore_patterns("bad"))
    stribeck, belt = cases / "verification/stribeck.yaml", cases / "verification/belt_helix.yaml"
    expect("kinetic: 0.2," in stribeck.read_text(), "stribeck.yaml is another case than this test knows")
    stribeck.write_text(stribeck.read_text().replace("kinetic: 0.2,", "kinetic: 0.21,", 1))
    vibration = cases / "verification/coulomb_free_vibration.yaml"
    vibration.write_text(vibration.read_text().replace("[VM73]", "[nobody]"))
    belt.write_text(belt.read_text().replace("friction:", "frictoin:"))  # does not even run
    damaged = written(cases, scratch / "red")
    expect("published" not in damaged["keys", "dynamics"][1][1], "a number whose source nobody knows counts as published")
    red = {key for key, (verdict, cells) in damaged.items() if verdict == "failed" and cells[5] == "failed"}
    for key in (("laws", "stribeck"), ("closed-forms", "stribeck_coefficient"), ("connections", "SLOT"), ("criteria", "pointwise"),
                ("connections", "SLIPRING"), ("closed-forms", "helical_capstan")):
        expect(key in red, f"{key} is not red although its case is damaged")
    for key in (("laws", "renard"), ("connections", "HINGE"), ("closed-forms", "capstan"), ("criteria", "area"), ("decks", "export --to abaqus")):
        expect(key not in red, f"{key} is red although its cases are sound")
    for key, (verdict, cells) in sound.items():
        expect(verdict != "failed", f"{key} is red although its cases are sound: {cells}")
    expect(sound.keys() == damaged.keys(), "damage changes the list of claims")


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--slipbench", required=True, type=pathlib.Path)
parser.add_argument("--source", required=True, type=pathlib.Path)
given = parser.parse_args()
given.slipbench, given.source = given.slipbench.resolve(), given.source.resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(given.source / "docs/site"))
import dossier  # noqa: E402
import dossier_evidence  # noqa: E402
import pages  # noqa: E402

with tempfile.TemporaryDirectory() as name:
    scratch = pathlib.Path(name)
    minimal_cases = [say("new", one).stdout for one in pages.Site(given.slipbench, scratch).types()]
    required = json.loads(say("schema").stdout)["required"]
    say("check", "cases", "-q", "--json", scratch / "told.json", folder=given.source)
    told = json.loads((scratch / "told.json").read_text())["cases"]
    table = written(given.source / "cases", scratch / "sound")
    check_claims(table)
    check_numbers(table, told)
    check_kinds(table)
    check_commands(scratch / "sound")
    check_decks(table, scratch / "sound")
    check_damage(table, scratch)
print("\n".join(failures))
print(f"dossier: {len(table)} claims, {len(failures)} failures")
sys.exit(1 if failures else 0)
