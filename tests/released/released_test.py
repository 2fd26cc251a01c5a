#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the examples, fits and sweeps of every released version: they are still read, pass their checks, and give what they gave.

usage: released_test.py --slipbench EXE [--keep VERSION]

With --keep, at a release, it copies cases/examples into a folder VERSION beside this file, with the least, largest and last value of
each column of their results, and below it cases/calibration with the numbers that the fits found, and cases/sweeps with the least,
largest and last value of each column of a part of their rows. Of a folder of more than 60 kB it takes the smallest fits or sweeps.
What of a version is kept already stays as it is.
"""
import argparse
import csv
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# Of the largest magnitude in a column: rounding by another compiler, grown over some thousand increments. A change of results is larger.
TOLERANCE = 1e-8
# Of the standard error of a number that a fit found: where a search ends hangs on rounding, but far below what the data tell.
FIT_TOLERANCE = 1e-3
# The part of a sweep's samples that is run.
PART = "1/20"
MOST_BYTES = 60_000
COLUMN_HEAD = ["case", "column", "least", "largest", "last"]
FIT_HEAD = ["fit", "unknown", "value", "standard_error"]


def outcome(program, command, file, written, *more):
    """The text of the file `written` that a command of the program writes."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, command, file, "-o", folder, *more], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{command} {file} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
        return (pathlib.Path(folder) / written).read_text()


def columns_of(text):
    """The least, largest and last value of each column of rows, by name."""
    names, *rows = csv.reader(line for line in text.splitlines() if not line.startswith("#"))
    columns = [[float(value) for value in column] for column in zip(*rows)]
    return {name: (min(column), max(column), column[-1]) for name, column in zip(names, columns)}


def results_of(program, folder):
    """The columns of the runs of all cases of a folder, by case."""
    return {case.stem: columns_of(outcome(program, "run", case, f"{case.stem}.csv")) for case in sorted(folder.glob("*.yaml"))}


def files_with(folder, key):
    """The files of a folder that have a key at their outermost level."""
    return [file for file in sorted(folder.glob("*.yaml")) if re.search(rf"^{key}:", file.read_text(), re.MULTILINE)]


def sweeps_of(program, folder):
    """The columns of a part of the rows of all sweeps of a folder, by sweep."""
    return {file.stem: columns_of(outcome(program, "sweep", file, f"{file.stem}.{PART.replace('/', 'of')}.csv", "--part", PART))
            for file in files_with(folder, "sweep")}


def fits_of(program, folder):
    """What all fits of a folder found, by fit: {unknown: (value, standard error or None)}."""
    found = {}
    for file in files_with(folder, "calibrate"):
        document = json.loads(outcome(program, "calibrate", file, f"{file.stem}.json"))
        found[file.stem] = {one["name"]: (one["value"], one["standard_error"]) for one in document["unknowns"]}
    return found


def with_named(file):
    """A file and the files beside it that it names, and those that they name."""
    found, open_ones = set(), [file]
    while open_ones:
        one = open_ones.pop()
        found.add(one)
        if one.suffix == ".yaml":
            # A name stands between blanks, quotes, brackets or commas.
            words = set(re.split(r"[\s'\"{}\[\],]+", one.read_text()))
            open_ones += [other for other in file.parent.iterdir() if other.name in words and other not in found]
    return found


def copy_small(source, target, key):
    """Copies the files with a key and what they name, the smallest first, as long as all is small."""
    groups = [with_named(file) for file in files_with(source, key)]
    taken = set()
    for group in sorted(groups, key=lambda group: sum(file.stat().st_size for file in group)):
        if sum(file.stat().st_size for file in taken | group) <= MOST_BYTES:
            taken |= group
    if not taken:
        sys.exit(f"{source} has no file with '{key}:' that is small enough")
    target.mkdir()
    for file in taken:
        shutil.copy(file, target)


def write_table(file, head, rows):
    with open(file, "w", newline="") as out:
        csv.writer(out, lineterminator="\n").writerows([head, *rows])


def read_table(file):
    with open(file, newline="") as text:
        return list(csv.DictReader(text))


def column_rows(results):
    return [[case, name, *values] for case, columns in results.items() for name, values in columns.items()]


def keep(program, version, cases):
    """Keeps what is not kept yet of a version."""
    if not version.exists():
        shutil.copytree(cases / "examples", version)
        write_table(version / "results.csv", COLUMN_HEAD, column_rows(results_of(program, version)))
    fits, sweeps = version / "calibration", version / "sweeps"
    if not fits.exists():
        copy_small(cases / "calibration", fits, "calibrate")
        found = fits_of(program, fits)
        write_table(fits / "fits.csv", FIT_HEAD,
                    [[fit, name, value, "" if error is None else error] for fit, unknowns in found.items() for name, (value, error) in unknowns.items()])
    if not sweeps.exists():
        copy_small(cases / "sweeps", sweeps, "sweep")
        write_table(sweeps / "results.csv", COLUMN_HEAD, column_rows(sweeps_of(program, sweeps)))


def column_faults(folder, now):
    """What of the columns of runs or sweeps is not as it was."""
    kept = read_table(folder / "results.csv")
    if {row["case"] for row in kept} != set(now):
        yield f"{folder.name}: results.csv is not of the files beside it"
    for row in kept:
        where = f"{folder.name}/{row['case']}: {row['column']}"
        found = now.get(row["case"], {}).get(row["column"])
        wanted = [float(row[key]) for key in ("least", "largest", "last")]
        size = max(map(abs, wanted))
        if found is None:
            yield f"{where}: the column is gone"
        elif any(not abs(a - b) <= TOLERANCE * size for a, b in zip(found, wanted)):
            yield f"{where}: least, largest and last are {found}, were {wanted}"


def fit_faults(folder, now):
    """What of the numbers of fits is not as it was."""
    kept = read_table(folder / "fits.csv")
    if {(row["fit"], row["unknown"]) for row in kept} != {(fit, name) for fit, unknowns in now.items() for name in unknowns}:
        yield f"{folder.name}: fits.csv is not of the fits beside it"
    for row in kept:
        where = f"{folder.name}/{row['fit']}: {row['unknown']}"
        value, error = now.get(row["fit"], {}).get(row["unknown"], (None, None))
        wanted = float(row["value"])
        if value is None:
            yield f"{where}: the unknown is gone"
            continue
        # A number that no data tell has no error, and stays where it was.
        room = FIT_TOLERANCE * float(row["standard_error"]) if row["standard_error"] else TOLERANCE * abs(wanted)
        if not abs(value - wanted) <= room:
            yield f"{where}: is {value}, was {wanted}, within {room}"
        if (error is None) != (row["standard_error"] == ""):
            yield f"{where}: its standard error is {error}, was {row['standard_error'] or None}"
        elif error is not None and not abs(error - float(row["standard_error"])) <= room:
            yield f"{where}: its standard error is {error}, was {row['standard_error']}"


def version_faults(program, version):
    """What of a version is not as it was."""
    checked = subprocess.run([program, "check", version, "--quiet"], capture_output=True, text=True)
    if checked.returncode != 0:
        yield f"{version.name}: slipbench check ended with {checked.returncode}:\n{checked.stdout}{checked.stderr}"
    yield from column_faults(version, results_of(program, version))
    for part, faults, run in (("calibration", fit_faults, fits_of), ("sweeps", column_faults, sweeps_of)):
        if not (version / part).is_dir():
            yield f"{version.name}: its {part} are not kept: released_test.py --keep {version.name}"
            continue
        yield from (f"{version.name}: {fault}" for fault in faults(version / part, run(program, version / part)))


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--slipbench", required=True, help="the program")
parser.add_argument("--keep", metavar="VERSION", help="keep today's examples, fits and sweeps as those of VERSION")
options = parser.parse_args()
here = pathlib.Path(__file__).resolve().parent
if options.keep:
    keep(options.slipbench, here / options.keep, here.parents[1] / "cases")
    sys.exit()

versions = sorted(folder for folder in here.iterdir() if folder.is_dir())
if not versions:
    sys.exit(f"no version is kept in {here}")
faults = [fault for version in versions for fault in version_faults(options.slipbench, version)]
print(*faults, f"{len(versions)} versions, {len(faults)} faults", sep="\n")
sys.exit(1 if faults else 0)
