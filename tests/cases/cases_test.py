#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests of the case files against the program: cases_test.py TEST --slipbench EXE --source DIR

TEST is one of
  schema     cases/examples and cases/verification validate against `slipbench schema`, cases/bad does not; fit files
             against `slipbench schema --fit`
  check      `slipbench check cases/` passes, every case has checks, every tolerance says why, no data have the name
             of a result
  bad        every file of cases/bad is answered with the whole message and the exit code of the .expected file beside it,
             quickly and without a file left behind, and so are the flags, environments and prepared files of
             cases/bad/commands; with --write, the .expected files are written anew from what the program says, to be read
             before they are believed
  mistakes   each typical mistake of a new user (mistakes.yaml) is answered with its place, its cause and a remedy
  sensitive  checks notice a wrong coefficient or gap: with mu, a direction's coefficient or the width of a dead zone
             raised by 1 % the verification cases fail
  calibration  the fits of cases/calibration find the numbers that their data were made with, within 4 standard errors,
             and name the ones that no data tell; the calibrated cases pass their checks
  sweeps     the sweeps of cases/sweeps keep `slipbench schema --sweep`; threads and parts change no byte of their rows,
             and a row is what `slipbench run` gives with its values
  increments every file of increments/, integrated exactly, ends its steps alike with 1, 3, 7 and 50 increments each
  twins      predefined and user-defined examples give the same result, column by column
  suite      a suite with hostile names and broken cases: JUnit XML keeps the schema junit.xsd, JSON, annotations, what
             files are written and which are refused, --filter, --failed-first, --fail-fast, --quiet, interruption, the
             progress bar on a terminal and nowhere else
  hostile    texts and names of files that would be commands, markup or messages elsewhere stay data in all that is written:
             nothing is run, XML and JSON give the texts back, no line of a log begins with one
  same_bytes locale (one with a decimal comma), time zone, folder, environment, number of threads and repetition change no
             byte of results, pictures, pages, decks and sweeps, nor of what is said but for times of the clock
  guide      the complete cases in docs/guide, docs/tutorials and README.md pass, and what they show of the program's output
             is what it says; a page may use the files of those before it in its folder
The needs beyond python3 itself are python3-yaml, python3-jsonschema and xmllint.
"""

import argparse
import concurrent.futures
import csv
import difflib
import importlib.util
import itertools
import json
import os
import pathlib
import pty
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import jsonschema
import yaml

sys.dont_write_bytecode = True
import same_results  # noqa: E402
import transcript  # noqa: E402

PATIENCE = 900  # seconds, more than any build takes for its cases: with counters and without optimisation some 100
POSITION = re.compile(r":\d+:\d+: ")
failures = []


def expect(condition, message):
    """Notes a failure and goes on, so that one run shows all of them."""
    if not condition:
        failures.append(message)


def run(*arguments, cwd=None, env=None):
    """Runs the program; returns exit code and both outputs as one text."""
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=cwd, timeout=PATIENCE,
                          env={**os.environ, **(env or {})})
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
    fit_schema()


def fit_schema():
    """The schema of fit files: what is sound in form validates, whatever else is wrong with it."""
    code, text = run("schema", "--fit")
    expect(code == 0, f"slipbench schema --fit ended with {code}")
    document = json.loads(text)
    jsonschema.Draft202012Validator.check_schema(document)
    validator = jsonschema.Draft202012Validator(document)
    for path in sorted((source / "cases/calibration").glob("**/*.yaml")):
        fit = yaml.safe_load(path.read_text())
        if "calibrate" in fit:
            for error in validator.iter_errors(fit):
                expect(False, f"{path.name}: does not validate: {error.json_path}: {error.message:.200}")
    faulty_in_form = {"bounds_of_three", "case_for_a_fit", "confidence_one", "huber_without_threshold",
                      "key_at_the_wrong_level", "missing_experiments", "missing_time", "sigma_zero", "too_many_experiments", "unknown_key",
                      "unknown_key_of_an_experiment", "unknown_loss", "weight_negative"}
    for path in files("cases/bad/calibration"):
        valid = validator.is_valid(yaml.safe_load(path.read_text()))
        expect(valid != (path.stem in faulty_in_form), f"bad/calibration/{path.name}: validates: {valid}")


def check():
    code, text = run("check", source / "cases")
    expect(code == 0, f"slipbench check cases/ ended with {code}:\n{text}")
    expect("warning:" not in text, f"a shipped case gives a warning:\n{text}")
    for path in files("cases/examples", "cases/verification"):
        expect(f"{path.parent.name}/{path.stem} " in text, f"{path.name}: not in the verdict table")
        case = yaml.safe_load(path.read_text())
        expect(case.get("checks"), f"{path.name}: has no checks")
        expect(case.get("title"), f"{path.name}: has no title")
        expect(path.read_text().startswith("# "), f"{path.name}: does not begin with what it shows")
        for one in case.get("checks", []):
            expect(one["tolerance"].get("why"), f"{path.name}: '{one['name']}': the tolerance does not say why")
    for path in (source / "cases").rglob("*.yaml"):
        if "bad" in path.relative_to(source).parts:
            continue  # whatever there is, nothing is to be written: that test looks after it
        for ending in (".csv", ".events.csv", ".json", ".solver.csv"):
            expect(not path.with_suffix(ending).exists(), f"{path.name}: 'run' beside it would write {path.stem}{ending}")


def usual(path):
    """The command that a bad file is tried with, where its .expected file does not say so yet."""
    if path.suffix != ".yaml":
        return f"slipbench import {path.name}"
    text = path.read_text(errors="replace")
    for key, command in (("calibrate", "calibrate"), ("sweep", "sweep")):
        if re.search(rf"^{key}:", text, re.MULTILINE):
            return f"slipbench {command} {path.name}"
    return f"slipbench check {path.name}"


def bad():
    folder = source / "cases/bad"
    inputs = [path for ending in ("yaml", "inp", "rad", "k", "tcl") for path in folder.rglob(f"*.{ending}") if path.parent.name != "sound"]
    for path in inputs:
        expected = path.with_suffix(".expected")
        if not expected.exists():
            expect(options.write, f"bad/{path.relative_to(folder)}: {expected.name} is missing; --write makes it")
            if options.write:
                expected.write_text(transcript.write([transcript.Entry([], usual(path), 2)]))
    tried = [(path, entries) for path in sorted(folder.rglob("*.expected")) for entries in [transcript.read(path.read_text())]]
    with tempfile.TemporaryDirectory() as scratch, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as crew:
        scratch = pathlib.Path(scratch)
        stage = transcript.Stage(program, scratch)
        # Files are tried in one copy of the folder, which they must leave as it was; a command without a file of its own
        # has a copy of the sound files beside it to itself.
        shutil.copytree(folder, scratch / "bad")
        before = {path: path.read_bytes() for path in (scratch / "bad").rglob("*") if path.is_file()}

        def outcome(path, entry):
            if any(other.suffix != ".expected" for other in path.parent.glob(f"{path.stem}.*")):
                return stage.execute(entry.command, scratch / "bad" / path.parent.relative_to(folder))
            own = pathlib.Path(tempfile.mkdtemp(dir=scratch))
            shutil.copytree(path.parent / "sound", own / "work")
            return stage.execute(entry.command, own / "work")

        outcomes = {(path, n): crew.submit(outcome, path, entry) for path, entries in tried for n, entry in enumerate(entries)}
        for (path, n), one in outcomes.items():
            outcomes[path, n] = one.result()
        after = {path: path.read_bytes() for path in (scratch / "bad").rglob("*") if path.is_file()}
        for path in sorted(before.keys() | after.keys()):
            expect(before.get(path) == after.get(path), f"{path.relative_to(scratch)}: was written, changed or removed")
    alone = memory_is_its_own()
    for path, entries in tried:
        name = path.relative_to(folder)
        expect(entries, f"bad/{name}: has no command")
        for n, entry in enumerate(entries):
            found = outcomes[path, n]
            expect(found.code in (0, 1, 2, 3, 4, 130, 141, 143), f"bad/{name}: '{entry.command}' ended with {found.code}:\n{found.said}")
            if alone:
                expect(found.seconds < 1 and found.megabytes < 64,
                       f"bad/{name}: '{entry.command}' took {found.seconds:.2f} s and {found.megabytes:.0f} MB")
            if options.write:
                entry.code, entry.said = found.code, found.said
                continue
            wanted = f"exit {entry.code}\n{entry.said}".splitlines()
            said = f"exit {found.code}\n{found.said}".splitlines()
            expect(said == wanted, f"bad/{name}: '{entry.command}': " + "\n".join(difflib.unified_diff(wanted, said, "wanted", "found", lineterm="", n=1)))
        if options.write:
            path.write_text(transcript.write(entries))
    bad_forms(tried)
    print(f"{len(inputs)} bad files, {sum(len(entries) for _, entries in tried)} commands")


def memory_is_its_own():
    """Whether time and memory are the program's: a sanitizer and counters of gcov take more of both for themselves."""
    return b"__gcov" not in pathlib.Path(program).read_bytes() and subprocess.run(["bash", "-c", 'ulimit -v 500000; exec "$0" --version', program], capture_output=True).returncode == 0


def bad_forms(tried):
    """What holds for the messages, whatever their words: they say where; and a file says what is wrong with it."""
    for path, entries in tried:
        name = path.relative_to(source / "cases")
        beside = path.with_suffix(".yaml")
        if not beside.exists():
            continue
        lines = beside.read_text(errors="replace").splitlines()
        if path.parent.name != "text":
            expect(lines[0].startswith("# "), f"{name}: does not say what is wrong")
        said = "".join(entry.said for entry in entries)
        for line in lines[:2]:
            if line.startswith("# wants "):
                place, words = line.removeprefix("# wants ").split(" ... ")
                expect(any(place in told and words in told for told in said.splitlines()), f"{name}: wanted '{place} ... {words}', found:\n{said}")
        if path.parent.name not in ("decks", "sweeps") and entries[0].code == 2:
            expect(POSITION.search(said), f"{name}: names no file:line:column:\n{said}")
    # A run and a check refuse alike, and a fit that is given to 'check' is sent on.
    for path in files("cases/bad"):
        with tempfile.TemporaryDirectory() as folder:
            code, text = run("run", path.name, "-o", folder, cwd=path.parent)
            wanted = transcript.read(path.with_suffix(".expected").read_text())[0].said
            expect(code == 2 and wanted in text, f"bad/{path.name}: run ended with {code} and does not say what check does:\n{text}")
            expect(not list(pathlib.Path(folder).iterdir()), f"bad/{path.name}: run left files behind")
    for path in files("cases/bad/calibration"):
        if path.stem == "case_for_a_fit":
            continue
        with tempfile.TemporaryDirectory() as folder:
            code, text = run("check", path, cwd=folder)
            expect(code == 2, f"bad/calibration/{path.name}: check ended with {code}, wanted 2")
            expect("slipbench calibrate" in text,
                   f"bad/calibration/{path.name}: check does not name the right command:\n{text}")


def mistakes():
    document = yaml.safe_load((source / "tests/cases/mistakes.yaml").read_text())
    commands = {"slider.yaml": "run slider.yaml --no-output", "rig.yaml": "run rig.yaml --no-output",
                "rig.csv": "run rig.yaml --no-output", "fit.yaml": "calibrate fit.yaml --no-output"}
    tried = document["mistakes"]
    accepted = [one["mistake"] for one in tried if "accepted" in one]
    lacking = [f"{one['mistake']} ({one['lacks']})" for one in tried if "lacks" in one]
    for mistake in tried:
        name = mistake["mistake"]
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder) / "work"
            folder.mkdir()
            texts = dict(document["files"])
            changed = mistake.get("in", "slider.yaml")
            for old, new in [*([mistake["change"]] if "change" in mistake else []), *mistake.get("more", [])]:
                expect(old == "all" or texts[changed].count(old) == 1, f"{name}: '{old}' is not there once")
                texts[changed] = new if old == "all" else texts[changed].replace(old, new)
            for file, text in texts.items():
                (folder / file).write_text(text)
            code, said = run(*shlex.split(mistake.get("run", commands[changed])), cwd=folder)
        if mistake.get("accepted"):
            expect(code == 0, f"{name}: is no longer accepted; what does it say?\n{said}")
            continue
        # Place, cause and remedy stand in one message.
        answers = [line for line in said.splitlines() if all(re.search(part, line) for part in mistake["says"])]
        expect(answers, f"{name}: wanted {' ... '.join(mistake['says'])}, found:\n{said}")
        expect(code in (2, 4) or any("warning" in line or "FAIL" in line for line in answers), f"{name}: ended with {code}:\n{said}")
    expect(len(tried) >= 109, f"only {len(tried)} mistakes are tried")
    good = len(tried) - len(accepted) - len(lacking)
    print(f"{good} of {len(tried)} get place, cause and remedy; accepted: {', '.join(accepted)}; lacking: {', '.join(lacking)}")


def sensitive():
    # Cases whose checks do not use the coefficient: normal forces only, or no coefficient at all.
    indifferent = {"coulomb_slider_stick", "wedging", "contact_force_translator_terms", "stick_stiffness_modes",
                   "ujoint_factors_table", "ujoint_bent"}
    keys = {"mu": "coefficient", "forward": "forward", "backward": "backward", "g": "width"}
    seen = dict.fromkeys(keys, 0)
    for path in files("cases/verification"):
        parameters = yaml.safe_load(path.read_text()).get("parameters", {})
        for name, key in keys.items():
            value = parameters.get(name)
            if not isinstance(value, (int, float)) or path.stem in indifferent:
                continue
            # Every number a check compares with is fixed before the run: a case whose expectation moves along with
            # the parameter would prove nothing, so it is compared with the result of the true number.
            text = re.sub(rf"\b{key}: = {name}\b", f"{key}: {1.01 * value!r}", path.read_text())
            if name != "mu" and text == path.read_text():
                continue
            seen[name] += 1
            expect(text != path.read_text(), f"{path.name}: has a parameter {name} that is no {key}")
            with tempfile.TemporaryDirectory() as folder:
                for data in path.parent.glob("*.csv"):
                    (pathlib.Path(folder) / data.name).write_text(data.read_text())
                changed = pathlib.Path(folder) / path.name
                changed.write_text(text)
                code, _ = run("check", changed)
            expect(code == 1, f"{path.name}: with {name} 1 % too high check ended with {code}, wanted 1")
    for name, least in {"mu": 15, "forward": 2, "backward": 2, "g": 5}.items():
        expect(seen[name] >= least, f"only {seen[name]} cases tried with another {name}")


def calibration():
    folder = source / "cases/calibration"
    specification = importlib.util.spec_from_file_location("generate", folder / "generate.py")
    generate = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(generate)
    fits = {path.stem for path in files("cases/calibration") if path.stem.endswith("_fit")}
    expect(fits == set(generate.TRUTHS), f"fits without a truth in generate.py, or the other way: {fits}")
    for fit, truths in generate.TRUTHS.items():
        with tempfile.TemporaryDirectory() as results:
            code, text = run("calibrate", folder / f"{fit}.yaml", "-o", results)
            expect(code == 0, f"{fit}: ended with {code}:\n{text}")
            if code != 0:
                continue
            found = json.loads((pathlib.Path(results) / f"{fit}.json").read_text())
            calibrated = list(pathlib.Path(results).glob("*.calibrated.yaml"))
            expect(len(calibrated) == 1, f"{fit}: wrote {len(calibrated)} calibrated cases, wanted 1")
            for path in calibrated:
                code, text = run("check", path)
                expect(code == 0, f"{path.name}: check ended with {code}:\n{text}")
        # The sigma of each fit is the noise of its data: the residuals agree with it.
        deviation = found["statistics"]["deviation"]
        expect(0.9 < deviation < 1.1, f"{fit}: the residuals are {deviation} of the noise")
        unknowns = {unknown["name"]: unknown for unknown in found["unknowns"]}
        expect(set(unknowns) == set(truths), f"{fit}: the unknowns are {sorted(unknowns)}")
        never_visited = {name for name, unknown in unknowns.items() if unknown["frozen"]}
        wanted = {name for name, truth in truths.items() if truth is None}
        expect(never_visited == wanted, f"{fit}: never visited are {sorted(never_visited)}, wanted {sorted(wanted)}")
        for name, truth in truths.items():
            if truth is None or name not in unknowns or name in never_visited:
                continue
            value, error = unknowns[name]["value"], unknowns[name]["standard_error"]
            expect(abs(value - truth) <= 4.0 * error, f"{fit}: {name} is {value} +- {error}, wanted {truth}")
            # An error that is any size holds any truth: the widest of them is 1.7 %.
            expect(error <= 0.02 * abs(truth), f"{fit}: {name} is only known to {error}")


def sweeps():
    code, text = run("schema", "--sweep")
    expect(code == 0, f"slipbench schema --sweep ended with {code}")
    validator = jsonschema.Draft202012Validator(json.loads(text))
    for path in files("cases/sweeps"):
        document = yaml.safe_load(path.read_text())
        if "sweep" not in document:
            continue
        for error in validator.iter_errors(document):
            expect(False, f"{path.name}: does not validate: {error.json_path}: {error.message:.200}")
        with tempfile.TemporaryDirectory() as folder:
            target = pathlib.Path(folder)
            code, text = run("sweep", path, "-o", folder)
            expect(code == 0, f"{path.name}: ended with {code}:\n{text}")
            whole = [line for line in (target / f"{path.stem}.csv").read_text().splitlines() if line[0] != "#"]
            runs = len(document["sweep"]["vary"]) + 2 if document["sweep"].get("sobol_indices") else 1
            expect(len(whole) == 1 + runs * document["sweep"]["samples"], f"{path.name}: {len(whole)} lines")
            parts = whole[:1]
            for part in (1, 2, 3):
                code, text = run("sweep", path, "-o", folder, "--part", f"{part}/3", "-j", str(part))
                expect(code == 0, f"{path.name}: part {part} ended with {code}:\n{text}")
                rows = (target / f"{path.stem}.{part}of3.csv").read_text().splitlines()
                parts += [line for line in rows if line[0] not in "#i"]
            expect(parts == whole, f"{path.name}: the parts are not the whole")
            row = dict(zip(whole[0].split(","), whole[18].split(",")))
            settings = [word for name in document["sweep"]["vary"] for word in ("--set", f"{name}={row[name]}")]
            code, text = run("run", path.parent / document["sweep"]["case"], "-o", folder, *settings)
            expect(code == 0, f"{path.name}: its case ended with {code}:\n{text}")
            lines = (target / document["sweep"]["case"].replace(".yaml", ".csv")).read_text().splitlines()
            last = list(csv.DictReader(line for line in lines if not line.startswith("#")))[-1]
            for name, collected in document["sweep"]["collect"].items():
                if "last" in collected:
                    expect(float(row[name]) == float(last[collected["last"]]), f"{path.name}: {name}: {row[name]}")


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


def increments():
    watched = re.compile("CSF|CSM|CASU|DISS|STRAIN_E|WORK|LOST")
    for path in files("tests/cases/increments"):
        ends = [0.0]
        for step in yaml.safe_load(path.read_text())["history"]:
            ends.append(ends[-1] + step["duration"])
        rows = {}
        for n in (1, 3, 7, 50):
            done = subprocess.run([program, "run", path, "--set", f"n={n}", "-o", "-", "--quiet"], capture_output=True,
                                  text=True, timeout=PATIENCE)
            expect(done.returncode == 0, f"increments/{path.name}: n = {n} ended with {done.returncode}:\n{done.stderr}")
            table = csv.DictReader(line for line in done.stdout.splitlines() if not line.startswith("#"))
            rows[n] = [row for row in table if min(abs(float(row["t"]) - end) for end in ends) < 1e-9]
        if not all(len(ended) == len(ends) for ended in rows.values()):
            continue  # a run that failed, said above
        for column in filter(watched.match, rows[50][0]):
            fine = [float(row[column]) for row in rows[50]]
            size = max(max(fine) - min(fine), 1e-9 * max(map(abs, fine)), 1e-12)
            for n in (1, 3, 7):
                worst = max(abs(float(row[column]) - value) for row, value in zip(rows[n], fine, strict=True))
                # The integration's own tolerance is 1e-10 of each piece.
                expect(worst <= 1e-9 * size, f"increments/{path.name}: {column} of n = {n} is off by {worst / size:.1e}")


def unhurried(text):
    """A text of the program without what differs from run to run and machine to machine."""
    text = re.sub(r"\d+(\.\d+)? m?s$", "TIME", text, flags=re.MULTILINE)
    text = re.sub(r" +TIME", " TIME", text)
    return re.sub(r" +\d+ cores?$", " CORES", text, flags=re.MULTILINE)


def guide():
    folders = []
    for name in ("docs/guide", "docs/tutorials"):
        contents = (source / name / "README.md").read_text()
        pages = list(dict.fromkeys(re.findall(r"\]\((\w[\w-]*\.md)\)", contents)))
        on_disk = {path.name for path in (source / name).glob("*.md")} - {"README.md"}
        expect(set(pages) == on_disk, f"{name}/README.md: its pages are {pages}, the folder has {sorted(on_disk)}")
        folders.append([f"{name}/{page}" for page in pages])
    for documents in (*folders, ["README.md"]):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "bin").mkdir()
            (folder / "bin/slipbench").symlink_to(program)
            cases = sum(examples(document, folder) for document in documents)
        expect(cases, f"{documents}: no complete case found")


def examples(document, folder):
    """Runs what one page shows, in a folder; returns how many complete cases there are."""
    fence = re.compile(r"^```(\w+) ?([^\n]*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
    path = f"{folder / 'bin'}:{os.environ['PATH']}"
    cases = 0
    for kind, title, body in fence.findall((source / document).read_text()):
        if kind == "csv":
            (folder / title).write_text(body)
        elif kind == "yaml" and title.startswith("file "):
            (folder / title.removeprefix("file ")).write_text(body)
        elif kind == "yaml" and title.endswith(".yml"):
            # A file for a continuous integration, to be pasted: at least it can be read.
            expect(isinstance(yaml.safe_load(body), dict), f"{document}: {title} is no YAML map")
        elif kind == "yaml" and title.startswith("case "):
            cases += 1
            name = title.removeprefix("case ")
            (folder / name).write_text(body)
            code, output = run("check", name, cwd=folder)
            expect(code == 0, f"{document}, {name}: check ended with {code}:\n{output}")
        elif kind == "console":
            commands = [line[2:] for line in body.splitlines() if line.startswith("$ ")]
            shown = "\n".join(line for line in body.splitlines() if not line.startswith("$ "))
            done = subprocess.run(["bash", "-c", "\n".join(commands)], cwd=folder, text=True, timeout=PATIENCE,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  env={**os.environ, "PATH": path, "LC_ALL": "C.UTF-8"})
            expect(unhurried(shown.strip()) == unhurried(done.stdout.strip()),
                   f"{document}: '{commands[0]}' shows other words than it says:\n{done.stdout}")
    return cases


def same_bytes():
    names = ["hinge", "press_fit", "belt", "renard", "stick_slip_belt", "shock_absorber"]

    def outcome(folder, environment, jobs):
        """All that is said and written, in a folder of that name."""
        folder = folder / "cases"  # JUnit names it
        folder.mkdir(parents=True)
        for path in [*(source / f"cases/examples/{name}.yaml" for name in names), *(source / "cases/sweeps").glob("slot*.yaml")]:
            shutil.copy(path, folder)
        commands = [["run", *(f"{name}.yaml" for name in names), "-o", "out"], ["report", "hinge.yaml", "belt.yaml", "-o", "page.html"],
                    ["check", ".", "--jobs", jobs, "--json", "check.json", "--junit", "check.xml"], ["plot", "press_fit.yaml", "-o", "picture.svg"],
                    ["sweep", "slot_sweep.yaml", "-j", jobs, "-o", "swept"], ["export", "hinge.yaml", "--to", "abaqus", "-o", "deck.inp"]]
        found = {}
        for command in commands:
            done = subprocess.run([program, *map(str, command)], cwd=folder, env=environment, capture_output=True, timeout=300)
            expect(done.returncode == 0, f"{command}: ended with {done.returncode}:\n{done.stdout.decode()}{done.stderr.decode()}")
            found[command[0]] = done.stdout + done.stderr
        found |= {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file() and path.suffix != ".yaml"}
        return {name: re.sub(rb' time="[0-9.]+"| *TIME| +\d threads?', b"", same_results.constant(content)) for name, content in found.items()}

    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        comma = scratch / "locales/de_DE.UTF-8"
        comma.parent.mkdir()
        subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", comma], check=True, capture_output=True)
        german = {**os.environ, "LOCPATH": str(comma.parent), "LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}
        said = subprocess.run(["/usr/bin/printf", "%.1f", "1,5"], env=german, capture_output=True, text=True).stdout
        expect(said == "1,5", f"the locale has no decimal comma, it shows {said!r}")
        (scratch / ".gnuplot").write_text("set grid\nset title 'of the user'\n")
        plain = {"PATH": os.environ["PATH"], "XDG_CACHE_HOME": str(scratch / "cache")}
        wanted = outcome(scratch / "plain", plain, 1)
        expect(len(wanted) > 25, f"only {sorted(wanted)} to compare")
        for what, folder, environment, jobs in (
                ("repetition", "again", plain, 1), ("threads", "threads", plain, 7), ("folder", "ein anderer Ördner/& deeper", plain, 1), ("locale", "locale", german, 2),
                ("time zone", "zone", {**plain, "TZ": "Pacific/Kiritimati"}, 1),
                ("environment", "environment", {**os.environ, "COLUMNS": "40", "HOME": str(scratch), "OMP_NUM_THREADS": "3", "MALLOC_PERTURB_": "165"}, 3)):
            found = outcome(scratch / folder, environment, jobs)
            expect(set(found) == set(wanted), f"{what}: other files, {sorted(set(found) ^ set(wanted))}")
            for name in sorted(set(found) & set(wanted)):
                lines = itertools.zip_longest(found[name].split(b"\n"), wanted[name].split(b"\n"))
                other = next((pair for pair in lines if pair[0] != pair[1]), None)
                expect(other is None, f"{what}: other bytes in {name}, first {other}")


SLIDER = """slipbench: 1
units: {{length: mm, force: N, time: s}}
parameters: {{mu: {mu}}}
connector: {{type: SLOT}}
friction:
  - {{predefined: {{}}, coefficient: = mu, stick: {{stiffness: 1000}}}}
history:
  - {{step: slide, increments: {increments}, motion: {{CP1: {{to: 0.1}}}}, force: {{f2: 100}}}}
checks:
  - name: {name}
    quantity: FLIM
    against: {{expression: = 20}}
    tolerance: {{relative: 1.0e-12, why: rounding}}
"""


def slider(mu=0.2, increments=10, name="limit"):
    """A case that passes with mu = 0.2 and fails with another."""
    return SLIDER.format(mu=mu, increments=increments, name=name)


def suite():
    for part in (suite_junit, suite_json, suite_annotations, suite_report, suite_files, suite_choice, suite_memory,
                 suite_interruption, suite_progress):
        with tempfile.TemporaryDirectory() as folder:
            part(pathlib.Path(folder))


def suite_junit(folder):
    schema_file = source / "tests/cases/junit.xsd"

    def validate(name):
        done = subprocess.run(["xmllint", "--noout", "--schema", schema_file, folder / name], capture_output=True, text=True)
        expect(done.returncode == 0, f"{name}: is no valid JUnit XML:\n{done.stderr}")
        return xml.etree.ElementTree.parse(folder / name).getroot()

    (folder / "cases/a & b").mkdir(parents=True)
    hostile = r'"<check> & \"quotes\" ]]> \n::error::injected \U0001f527 größe"'
    (folder / "cases/a & b/'<hostile>\"\x01\n.yaml").write_text(slider(mu=0.3, name=hostile))
    (folder / "cases/holds.yaml").write_text(slider())
    (folder / "cases/unchecked.yaml").write_text(slider().split("checks:")[0])
    (folder / "cases/broken.yaml").write_bytes(b"slipbench: 1\n\xff\xfe\x00<broken>\n")
    (folder / "cases/fails.yaml").write_text(slider().replace("f2: 100", "f2: 1.0e300, f3: 1.0e300"))
    with open(os.fsencode(folder / "cases") + b"/no_utf8_\xff.yaml", "w") as file:
        file.write(slider(mu=0.3))
    code, text = run("check", "cases", "--junit", "slip.xml", cwd=folder)
    expect(code == 3, f"a suite whose worst is a numerical failure ended with {code}:\n{text}")
    root = validate("slip.xml")
    tests = root.findall("./testsuite/testcase")
    counts = {"tests": len(tests), "failures": len(root.findall(".//failure")), "errors": len(root.findall(".//error")),
              "skipped": len(root.findall(".//skipped"))}
    expect(counts == {"tests": 6, "failures": 2, "errors": 2, "skipped": 1}, f"JUnit: found {counts}")
    for element in (root, *root):
        for name in counts if element is not root else ("tests", "failures", "errors"):
            inside = element.findall(".//testcase" if name == "tests" else f".//{name.removesuffix('s') if name != 'skipped' else name}")
            expect(int(element.get(name)) == len(inside), f"JUnit: {element.get('name')}: {name} is {element.get(name)}")
        sums = sum(float(test.get("time")) for test in element.findall(".//testcase"))
        # Each of the times is rounded to a microsecond.
        expect(abs(float(element.get("time")) - sums) < 1e-5, f"JUnit: {element.get('name')}: times do not add up")
    expect([suite.get("name") for suite in root] == ["a & b", "cases"], "JUnit: not one suite a folder")
    expect(all(float(test.get("time")) > 0 for test in tests), "JUnit: a case took no time")
    expect("timestamp" not in root[0].attrib and "hostname" not in root[0].attrib, "JUnit: has a date or machine")
    expect("\n::error" not in text and "\x07" not in text and "\x1b" not in text, f"a name broke the table:\n{text!r}")

    # But for the times, the same suite gives the same text, whatever the threads.
    def timeless(name):
        return re.sub(r'time="[0-9.]+"', "", (folder / name).read_text())
    run("check", "cases", "-j", 5, "--junit", "again.xml", cwd=folder)
    expect(timeless("again.xml") == timeless("slip.xml"), "JUnit: differs with the threads")
    code, _ = run("check", source / "cases", "--junit", folder / "repository.xml")
    expect(code == 0 and int(validate("repository.xml").get("tests")) > 300, "JUnit of the repository's own cases")


def hostile():
    """Gives every text of a case, and its file, a name made of commands and markup, and reads what comes out."""
    text = '</title></script><script>alert(1)</script><img src=x onerror=alert(2)> $(touch ran) `touch ran` "; system("touch ran"); ' \
           "set output '|touch ran' # %{touch ran} =cmd|'/c calc'!A1 ]]> --> {/Symbol s} @x_2 ::error::injected,=1+1;@SUM(A1),-2+3,\"=1+1\""
    quoted = json.dumps("\n" + text.replace("::error", "\n::error"))
    case = slider(mu=0.3, name=quoted).replace("slipbench: 1\n", f"slipbench: 1\ntitle: {quoted}\n")
    case = re.sub(r"step: \w+", lambda _: "step: " + quoted, re.sub(r"why: [^}\n]+", lambda _: "why: " + quoted, case))
    expect(case.count("::error") >= 4, f"not every text of the case is replaced:\n{case}")
    for name in ("plain", "$(touch ran)", "`touch ran`", "\"; system('touch ran'); #", "<script>alert(1)<script>", "=1+1", "a,=1+1;\"-1", "|touch ran"):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            file = name + ".yaml"
            (folder / file).write_text(case)
            sweep = {"slipbench": 1, "title": text, "sweep": {"case": file, "sampler": "grid", "vary": {"mu": {"grid": [0.1, 0.2]}}, "collect": {"peak": {"max": "CSF1"}}}}
            (folder / "sweep.yaml").write_text(yaml.safe_dump(sweep))
            said = []
            commands = [["run", file, "-o", "out"], ["run", file, "-o", "told", "--explain", "0.5"], ["report", file, "-o", "page.html"],
                        ["check", file, "--junit", "check.xml", "--json", "check.json", "--report", "check.html"],
                        ["convert", f"out/{name}.csv", "-o", "rows.npy"], ["sweep", "sweep.yaml", "-o", "swept"]]
            commands += [["plot", file, "-o", f"picture.{kind}"] for kind in ("svg", "png")]
            commands += [["export", file, "--to", to, "-o", f"deck.{to}"] for to in ("abaqus", "radioss", "lsdyna", "opensees", "table", "fmu")]
            for command in commands:
                code, output = run(*command, cwd=folder, env={"GITHUB_ACTIONS": "true"})
                expect(code in (0, 1), f"{command} ended with {code}:\n{output}")
                said += output.splitlines()
            said += plots_of_hostile_result(folder, f"out/{name}.csv", text)
            told = [line for line in said if re.match(r"\s*::", line) and not line.startswith("::error file=")]
            expect(not told, f"lines that pass for messages to the runner: {told}")
            expect(not list(folder.rglob("ran")), f"{name}: a text was run as a command")
            for written in folder.rglob("*"):
                if written.suffix in (".html", ".svg", ".xml"):
                    expect("<script>alert" not in written.read_text() and "<img src=x" not in written.read_text(), f"{written.name} has the text as markup")
                if written.suffix in (".svg", ".xml"):
                    xml.etree.ElementTree.parse(written)
                if written.suffix == ".csv" and written != folder / f"out/{name}.csv":  # that one has been spoilt
                    # What a spreadsheet takes for a cell, whichever of the two separates: no formula but a number.
                    cells = re.split(r"[,;\n]", written.read_text())
                    formulas = [cell for cell in cells if cell.lstrip('"')[:1] in tuple("=+-@") and not re.fullmatch(r"-[\d.e+-]+", cell)]
                    expect(not formulas, f"{written.name}: a spreadsheet takes these for formulas: {formulas[:3]}")
                if written.suffix in (".csv", ".inp", ".rad", ".k", ".tcl"):
                    expect(not re.search(r"(?m)^\s*(::|=cmd|\$\(|`)", written.read_text()), f"{written.name} has a line that begins with the text")
            expect(json.loads((folder / "check.json").read_text())["cases"][0]["checks"][0]["name"] == " " + text.replace("::error", " ::error"),
                   "JSON changes a name")


def plots_of_hostile_result(folder, result, text):
    """Gives a result's title, units, definition and columns such names, and plots it; returns the lines that the program said."""
    lines = (folder / result).read_text().splitlines()
    spoilt = []
    quoted = text.replace('"', "'")
    for line in lines:
        key = line.split(": ")[0]
        if key == "# title":
            line = f"{key}: {text}"
        elif key == "# units":
            line = f"{key}: length {text}, force {text}, time {text}"
        elif key == "# friction":
            line = f"{key}: {text} = CSF1"
        elif key == "# columns":
            line = re.sub(r"\[[^]]*\]", lambda _: f"[{text}]", line) + f", {quoted} [{text}]"
        elif line.startswith("t,"):
            line += f',"{quoted}"'
        elif not line.startswith("#"):
            line += "," + line.split(",")[0]
        spoilt.append(line + "\n")
    expect(sum(text in line for line in spoilt) == 4 and sum(quoted in line for line in spoilt) == 2, f"not every line of the head is replaced:\n{spoilt[:9]}")
    (folder / result).write_text("".join(spoilt))
    said, drawn = [], 0
    for number, options in enumerate(([], ["--as", "history"], ["--as", "hysteresis"], ["--as", "bands"], ["--as", "spectrum"], ["--y", quoted],
                                      ["--x", quoted, "--y", "CSF1"])):
        for ending in ("svg", "pdf") if number == 0 else ("svg",):
            picture = f"result_{number}.{ending}"
            code, output = run("plot", result, *options, "-o", picture, cwd=folder)
            expect(code == 0 or code == 2 and output.startswith(result), f"plot {result} {options} ended with {code}:\n{output}")
            expect((folder / picture).exists() == (code == 0), f"plot {result} {options} ended with {code}, with or without a picture:\n{output}")
            drawn += code == 0
            said += output.splitlines()
            if ending == "svg" and code == 0:
                shown = "".join(xml.etree.ElementTree.parse(folder / picture).getroot().itertext())
                expect("touch ran" in shown, f"plot {result} {options} shows nothing of the texts")
    expect(drawn >= 6, f"{result}: only {drawn} pictures are drawn, so this proves little")
    return said


def suite_json(folder):
    for name, mu in (("a", 0.2), ("b", 0.3)):
        (folder / f"{name}.yaml").write_text(slider(mu))
    (folder / "c.yaml").write_text("slipbench: 2\n")
    texts = []
    for jobs in (1, 4):
        code, _ = run("check", ".", "-j", jobs, "--json", "slip.json", cwd=folder)
        expect(code == 2, f"--json: ended with {code}")
        texts.append((folder / "slip.json").read_text())
    expect(texts[0] == texts[1], "--json: differs with the threads")
    document = json.loads(texts[0])
    expect([case["status"] for case in document["cases"]] == ["passed", "failed", "not_run"], f"--json: {document}")
    expect(document["totals"]["failed_checks"] == 1 and document["totals"]["exit_code"] == 2, f"--json: {document}")
    expect(document["cases"][1]["checks"][0]["passed"] is False, f"--json: {document}")
    expect(document["cases"][2]["line"] == 1, f"--json: {document}")


def suite_annotations(folder):
    (folder / "friction").mkdir()
    (folder / "friction/belt.yaml").write_text(slider(0.3, name='"pull\\n::error::injected"'))
    environment = {"GITHUB_ACTIONS": "true", "GITHUB_WORKSPACE": str(folder.resolve())}
    code, text = run("check", "belt.yaml", cwd=folder / "friction", env=environment)
    expect(code == 1, f"annotations: ended with {code}")
    told = [line for line in text.splitlines() if line.startswith("::")]
    expect(len(told) == 1 and told[0].startswith("::error file=friction/belt.yaml,line=10,col=5,title=belt%3A pull %3A%3Aerror"),
           f"annotations: found {told}")
    for environment in ({}, {"GITHUB_ACTIONS": "false"}):
        _, text = run("check", "belt.yaml", cwd=folder / "friction", env=environment)
        expect("\n::" not in text, f"annotations outside GitHub Actions:\n{text}")


def suite_report(folder):
    for name, mu in (("a", 0.2), ("b", 0.3), ("c", 0.2)):
        (folder / f"{name}.yaml").write_text(slider(mu))
    pages = []
    for jobs in (1, 4):
        code, text = run("check", ".", "-j", jobs, "--report", "slip.html", cwd=folder)
        expect(code == 1 and "1 failed" in text, f"--report: ended with {code}:\n{text}")
        pages.append((folder / "slip.html").read_bytes())
    expect(pages[0] == pages[1], "--report: differs with the threads")
    expect(b"FLIM off by 10 N" in pages[0], "--report: does not tell what failed")
    run("check", ".", "--fail-fast", "--report", "slip.html", cwd=folder)
    expect(b"an earlier case did not pass" in (folder / "slip.html").read_bytes(), "--report: hides what was not run")


def suite_files(folder):
    case = folder / "a.yaml"
    case.write_text(slider(0.3))
    for option in ("--junit", "--json", "--report"):
        for target, wanted, words in (("a.yaml/x", 4, "a.yaml is not a folder"), (".", 4, "is a folder"),
                                      ("a.yaml", 4, "is an input (a.yaml)"), ("./a.yaml", 4, "is an input (a.yaml)")):
            code, text = run("check", "a.yaml", option, target, cwd=folder)
            expect(code == wanted and words in text, f"{option} {target}: ended with {code}:\n{text}")
    expect(case.read_text() == slider(0.3), "a case was overwritten")
    code, text = run("check", "a.yaml", "--junit", "x", "--json", "./x", cwd=folder)
    expect(code == 2 and "--junit and --json would both write ./x" in text, f"two files in one: {code}:\n{text}")
    expect([file.name for file in folder.iterdir()] == ["a.yaml"], "files were left behind")
    # A verdict that cannot be kept is shown all the same: no file may grow beyond a block here.
    code, text = run("check", "a.yaml", "--junit", "x", cwd=folder)
    done = subprocess.run(["bash", "-c", 'ulimit -f 0; trap "" XFSZ; exec "$0" check a.yaml --junit y', program], cwd=folder,
                          capture_output=True, text=True, timeout=PATIENCE)
    expect(done.returncode == 4 and "y: cannot be written" in done.stderr, f"a full disk: {done.returncode}: {done.stderr}")
    expect("FAIL  a " in done.stdout and "1 failed" in done.stdout, f"a full disk hides the verdict:\n{done.stdout}")
    expect(sorted(file.name for file in folder.iterdir()) == ["a.yaml", "x"], "half a file was left behind")


def suite_choice(folder):
    names = ("belt_1", "belt_2", "hinge_1", "hinge_2", "slot")
    for name in names:
        (folder / f"{name}.yaml").write_text(slider(0.3 if name == "hinge_1" else 0.2))
    environment = {"XDG_CACHE_HOME": str(folder / "cache")}

    def told(*arguments, wanted):
        code, text = run("check", ".", *arguments, cwd=folder, env=environment)
        expect(code == wanted, f"check {arguments}: ended with {code}, wanted {wanted}:\n{text}")
        return re.findall(r"^  (?:PASS|FAIL)  (\w+)", text, re.MULTILINE), text

    expect(told(wanted=1)[0] == list(names), "all cases")
    expect(told("--filter", "belt", wanted=0)[0] == ["belt_1", "belt_2"], "--filter belt")
    expect(told("--filter", "*_1", "--filter", "slot", wanted=1)[0] == ["belt_1", "hinge_1", "slot"], "two filters")
    none, text = told("--filter", "bolt", wanted=2)
    expect(none == [] and "no case matches --filter 'bolt'; there are 5 cases" in text, f"--filter bolt:\n{text}")
    expect(told("--quiet", wanted=1)[0] == ["hinge_1"], "--quiet")
    for jobs in (1, 4):
        some, text = told("--fail-fast", "-j", jobs, wanted=1)
        expect(some == list(names[:3]) and "2 cases passed, 1 failed, 2 not run" in text, f"--fail-fast:\n{text}")
    last, _ = told("--failed-first", wanted=1)
    expect(last == ["hinge_1", "belt_1", "belt_2", "hinge_2", "slot"], f"--failed-first: {last}")
    environment = {"XDG_CACHE_HOME": "/dev/null"}
    without, _ = told("--failed-first", wanted=1)
    expect(without == list(names), f"--failed-first without memory: {without}")


def suite_memory(folder):
    """A case that keeps all its rows, of which there are far too many, fails alone."""
    limited = ["bash", "-c", 'ulimit -v 500000; exec "$0" "$@"', program]
    if subprocess.run([*limited, "--version"], capture_output=True).returncode != 0:
        return  # a sanitizer needs more than that for itself
    (folder / "greedy.yaml").write_text(slider(increments=2000000000).replace("    tolerance", "    criterion: peak\n    tolerance"))
    (folder / "small.yaml").write_text(slider())
    done = subprocess.run([*limited, "check", ".", "-j", "2"], cwd=folder, capture_output=True, text=True, timeout=PATIENCE)
    expect(done.returncode == 4, f"a greedy case: ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    expect("FAIL  greedy   cannot be run" in done.stdout and "PASS  small " in done.stdout, f"a greedy case:\n{done.stdout}")
    expect("greedy.yaml: error: check 'limit' keeps the rows it compares: 2e+09 rows need at least 66 GB of memory" in done.stderr, f"a greedy case:\n{done.stderr}")


def suite_interruption(folder):
    (folder / "a.yaml").write_text(slider())
    (folder / "endless.yaml").write_text(slider(increments=2000000000))
    for sent in (signal.SIGINT, signal.SIGTERM):
        running = subprocess.Popen([program, "check", ".", "-j", "2", "--junit", "slip.xml", "--json", "slip.json"], cwd=folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        head = running.stdout.readline()
        line = running.stdout.readline()
        expect("PASS  a " in line, f"a case that is done is not told while others run: {head}{line}")
        running.send_signal(sent)
        expect(running.wait(timeout=60) == 128 + sent, f"interrupted by {sent}: ended with {running.returncode}")
        running.stdout.close()
        expect(sorted(file.name for file in folder.iterdir()) == ["a.yaml", "endless.yaml"], "interrupted: files were left behind")


def screen(text):
    """What a terminal shows after a text of letters, returns, line feeds and "clear to the end of the line"."""
    lines, column = [""], 0
    for piece in re.findall(r"\x1b\[K|\r|\n|[^\x1b\r\n]+|\x1b", text):
        if piece == "\x1b[K":
            lines[-1] = lines[-1][:column]
        elif piece == "\r":
            column = 0
        elif piece == "\n":
            lines.append("")
        else:
            lines[-1] = lines[-1][:column].ljust(column) + piece + lines[-1][column + len(piece):]
            column += len(piece)
    return "\n".join(lines)


def suite_progress(folder):
    """A bar for those who watch; what the terminal shows at the end, and what a log holds, is without it."""
    for name in "abcdefgh":
        (folder / f"{name}.yaml").write_text(slider(0.3 if name == "a" else 0.2, increments=2000000))
    for name in "ab":
        (folder / f"{name}.yaml").write_text(slider(0.3 if name == "a" else 0.2))
    arguments = [program, "check", ".", "-j", "1", "--quiet"]

    def on_terminal(environment, stdout=None):
        master, slave = pty.openpty()
        running = subprocess.Popen(arguments, cwd=folder, stdin=slave, stdout=stdout or slave, stderr=slave,
                                   env={**os.environ, **environment})
        os.close(slave)
        shown = b""
        while True:
            try:
                piece = os.read(master, 4096)
            except OSError:  # the other side was closed
                break
            if not piece:
                break
            shown += piece
        os.close(master)
        if stdout:
            running.stdout.read()
            running.stdout.close()
        expect(running.wait(timeout=60) == 1, "progress: ended otherwise on a terminal")
        return shown.decode()

    bar = re.compile(r"\r\[=*> *\] \d of 8 cases, 1 failed, \d+ s left\x1b\[K")
    done = subprocess.run(arguments, cwd=folder, capture_output=True, text=True, timeout=PATIENCE)
    expect(done.stderr == "" and "\r" not in done.stdout and "\x1b" not in done.stdout, f"a bar in a log:\n{done!r}")
    try:
        for end in pty.openpty():
            os.close(end)
    except OSError as error:  # a container without /dev/pts
        print(f"progress: only tried in a log, this machine has no pseudo-terminals ({error})")
        return
    shown = on_terminal({"TERM": "xterm", "NO_COLOR": "1"})
    expect(bar.search(shown), f"no progress bar on a terminal:\n{shown!r}")
    expect(unhurried(screen(shown)) == unhurried(done.stdout), f"the bar is not erased:\n{shown!r}\n{done.stdout!r}")
    expect("\x1b" not in on_terminal({"TERM": "dumb"}), "a bar on a terminal that cannot erase it")
    expect(bar.search(on_terminal({"TERM": "xterm"}, stdout=subprocess.PIPE)), "no bar while the table goes to a file")


tests = {f.__name__: f for f in (schema, check, bad, mistakes, sensitive, calibration, sweeps, increments, twins, suite, hostile, same_bytes, guide)}
parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("test", choices=tests)
parser.add_argument("--slipbench", required=True, help="the program")
parser.add_argument("--source", required=True, type=pathlib.Path, help="the root of the repository")
parser.add_argument("--write", action="store_true", help="of bad: write the expected messages anew")
options = parser.parse_args()
program = str(pathlib.Path(options.slipbench).resolve())
source = options.source.resolve()
# What the program says must not depend on where the tests run.
for variable in ("GITHUB_ACTIONS", "GITHUB_WORKSPACE"):
    os.environ.pop(variable, None)

# Nor on what failed here before; what fails in a test is not to be remembered for its user.
with tempfile.TemporaryDirectory() as cache:
    os.environ["XDG_CACHE_HOME"] = cache
    tests[options.test]()
for message in failures:
    print(message, file=sys.stderr)
print(f"{options.test}: {len(failures)} failures")
sys.exit(1 if failures else 0)
