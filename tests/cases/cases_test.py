#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of the case files against the program: cases_test.py TEST --slipbench EXE --source DIR

TEST is one of
  schema     cases/examples and cases/verification validate against `slipbench schema`, cases/bad does not
  check      `slipbench check cases/` passes, every case has checks, every tolerance says why
  bad        every file of cases/bad is refused with exit code 2 and a message with file:line:column
  semantic   every file of semantic/ is refused with exit code 2, at the place and with the words its first line wants
  sensitive  checks notice a wrong coefficient: with mu raised by 1 % the verification cases fail
  twins      predefined and user-defined examples give the same result, column by column
  guide      the complete cases in docs/user-guide.md and README.md pass, and what they show of the program's
             output is what it says
The needs beyond python3 itself are python3-yaml and python3-jsonschema.
"""

import argparse
import csv
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import jsonschema
import yaml

POSITION = re.compile(r":\d+:\d+: error: ")
failures = []


def expect(condition, message):
    """Notes a failure and goes on, so that one run shows all of them."""
    if not condition:
        failures.append(message)


def run(*arguments, cwd=None):
    """Runs the program; returns exit code and both outputs as one text."""
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=cwd, timeout=120)
    return done.returncode, done.stdout + done.stderr


def files(*folders):
    found = sorted(path for folder in folders for path in (source / folder).glob("*.yaml"))
    expect(found, f"no case files in {folders}")
    return found


def schema():
    code, text = run("schema")
    expect(code == 0, f"slipbench schema ended with {code}")
    document = json.loads(text)
    jsonschema.Draft202012Validator.check_schema(document)
    validator = jsonschema.Draft202012Validator(document)
    for path in files("cases/examples", "cases/verification"):
        for error in validator.iter_errors(yaml.safe_load(path.read_text())):
            expect(False, f"{path.name}: does not validate: {error.json_path}: {error.message:.200}")
    for path in files("cases/bad"):
        valid = validator.is_valid(yaml.safe_load(path.read_text()))
        expect(not valid, f"bad/{path.name}: validates, although it must not")


def check():
    code, text = run("check", source / "cases")
    expect(code == 0, f"slipbench check cases/ ended with {code}:\n{text}")
    for path in files("cases/examples", "cases/verification"):
        expect(f"{path.parent.name}/{path.stem} " in text, f"{path.name}: not in the verdict table")
        case = yaml.safe_load(path.read_text())
        expect(case.get("checks"), f"{path.name}: has no checks")
        expect(case.get("title"), f"{path.name}: has no title")
        expect(path.read_text().startswith("# "), f"{path.name}: does not begin with what it shows")
        for one in case.get("checks", []):
            expect(one["tolerance"].get("why"), f"{path.name}: '{one['name']}': the tolerance does not say why")


def bad():
    for path in files("cases/bad"):
        expect(path.read_text().startswith("# "), f"bad/{path.name}: does not say what is wrong")
        for command in ("check", "run"):
            with tempfile.TemporaryDirectory() as folder:
                code, text = run(command, path, cwd=folder)
                expect(code == 2, f"bad/{path.name}: {command} ended with {code}, wanted 2")
                expect(path.name + ":" in text and POSITION.search(text),
                       f"bad/{path.name}: {command} names no file:line:column:\n{text}")
                expect(not list(pathlib.Path(folder).iterdir()), f"bad/{path.name}: {command} left files behind")


def semantic():
    for path in files("tests/cases/semantic"):
        place, words = path.read_text().splitlines()[0].removeprefix("# wants ").split(" ... ")
        code, text = run("check", path)
        expect(code == 2, f"semantic/{path.name}: ended with {code}, wanted 2")
        said = [line for line in text.splitlines() if f"{path.name}:{place}" in line]
        expect(any(words in line for line in said), f"semantic/{path.name}: wanted '{place} ... {words}', found:\n{text}")


def sensitive():
    # Cases whose checks do not use the coefficient: normal forces only, or no coefficient at all.
    indifferent = {"coulomb_slider_stick", "wedging", "contact_force_translator_terms", "stick_stiffness_modes",
                   "ujoint_factors_table", "ujoint_bent"}
    seen = 0
    for path in files("cases/verification"):
        case = yaml.safe_load(path.read_text())
        mu = case.get("parameters", {}).get("mu")
        if mu is None or path.stem in indifferent:
            continue
        seen += 1
        # Every number a check compares with is fixed before the run: a case whose expectation moves along with
        # the parameter would prove nothing, so it is compared with the result of the true coefficient.
        text = re.sub(r"coefficient: = mu\b", f"coefficient: {1.01 * mu!r}", path.read_text())
        expect(text != path.read_text(), f"{path.name}: has a parameter mu that is no coefficient")
        with tempfile.TemporaryDirectory() as folder:
            for data in path.parent.glob("*.csv"):
                (pathlib.Path(folder) / data.name).write_text(data.read_text())
            changed = pathlib.Path(folder) / path.name
            changed.write_text(text)
            code, _ = run("check", changed)
        expect(code == 1, f"{path.name}: with mu 1 % too high check ended with {code}, wanted 1")
    expect(seen >= 15, f"only {seen} cases tried")


def result(path, folder):
    """The columns of a case's result, {name: [numbers]}."""
    code, text = run("run", path, "-o", folder)
    expect(code == 0, f"{path.name}: run ended with {code}:\n{text}")
    lines = (pathlib.Path(folder) / (path.stem + ".csv")).read_text().splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def twins():
    examples = source / "cases/examples"
    with tempfile.TemporaryDirectory() as folder:
        predefined = result(examples / "shock_absorber.yaml", folder)
        written_out = result(examples / "shock_absorber_user_defined.yaml", folder)
    expect(list(predefined) == list(written_out), "the twins have different columns")
    for name, values in predefined.items():
        # The same operations in the same order: equal to the last bit.
        expect(values == written_out.get(name), f"the twins differ in column {name}")


def unhurried(text):
    """A text of the program without what differs from run to run and machine to machine."""
    text = re.sub(r"\d+(\.\d+)? m?s$", "TIME", text, flags=re.MULTILINE)
    text = re.sub(r" +TIME", " TIME", text)
    return re.sub(r" +\d+ cores?$", " CORES", text, flags=re.MULTILINE)


def guide():
    fence = re.compile(r"^```(\w+) ?([^\n]*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
    for document in ("docs/user-guide.md", "README.md"):
        cases = 0
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "bin").mkdir()
            (folder / "bin/slipbench").symlink_to(program)
            path = f"{folder / 'bin'}:{os.environ['PATH']}"
            for kind, title, body in fence.findall((source / document).read_text()):
                if kind == "csv":
                    (folder / title).write_text(body)
                elif kind == "yaml" and title.startswith("case "):
                    cases += 1
                    name = title.removeprefix("case ")
                    (folder / name).write_text(body)
                    code, output = run("check", name, cwd=folder)
                    expect(code == 0, f"{document}, {name}: check ended with {code}:\n{output}")
                elif kind == "console":
                    commands = [line[2:] for line in body.splitlines() if line.startswith("$ ")]
                    shown = "\n".join(line for line in body.splitlines() if not line.startswith("$ "))
                    done = subprocess.run(["bash", "-c", "\n".join(commands)], cwd=folder, text=True, timeout=120,
                                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                          env={**os.environ, "PATH": path, "LC_ALL": "C.UTF-8"})
                    expect(unhurried(shown.strip()) == unhurried(done.stdout.strip()),
                           f"{document}: '{commands[0]}' shows other words than it says:\n{done.stdout}")
        expect(cases, f"{document}: no complete case found")


tests = {f.__name__: f for f in (schema, check, bad, semantic, sensitive, twins, guide)}
parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("test", choices=tests)
parser.add_argument("--slipbench", required=True, help="the program")
parser.add_argument("--source", required=True, type=pathlib.Path, help="the root of the repository")
options = parser.parse_args()
program = str(pathlib.Path(options.slipbench).resolve())
source = options.source.resolve()

tests[options.test]()
for message in failures:
    print(message, file=sys.stderr)
print(f"{options.test}: {len(failures)} failures")
sys.exit(1 if failures else 0)
