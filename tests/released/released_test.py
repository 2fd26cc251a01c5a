#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the examples of every released version: they are still read, pass their checks, and give what they gave.

usage: released_test.py --slipbench EXE [--keep VERSION]

With --keep, at a release, it copies cases/examples into a folder VERSION beside this file, with the least, largest and last value of
each column of their results.
"""
import argparse
import csv
import pathlib
import shutil
import subprocess
import sys
import tempfile

# Of the largest magnitude in a column: rounding by another compiler, grown over some thousand increments. A change of results is larger.
TOLERANCE = 1e-8


def results_of(program, case):
    """The least, largest and last value of each column of a run, by name."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([program, "run", case, "-o", folder], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{case} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
        with open(pathlib.Path(folder) / f"{case.stem}.csv") as file:
            names, *rows = csv.reader(line for line in file if not line.startswith("#"))
    columns = [[float(value) for value in column] for column in zip(*rows)]
    return {name: (min(column), max(column), column[-1]) for name, column in zip(names, columns)}


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--slipbench", required=True, help="the program")
parser.add_argument("--keep", metavar="VERSION", help="keep today's examples as those of VERSION")
options = parser.parse_args()
here = pathlib.Path(__file__).resolve().parent
if options.keep:
    folder = here / options.keep
    shutil.copytree(here.parents[1] / "cases/examples", folder)
    with open(folder / "results.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["case", "column", "least", "largest", "last"])
        for case in sorted(folder.glob("*.yaml")):
            writer.writerows([case.stem, name, *values] for name, values in results_of(options.slipbench, case).items())
    sys.exit()

faults = []
versions = sorted(folder for folder in here.iterdir() if folder.is_dir())
if not versions:
    sys.exit(f"no version is kept in {here}")
for folder in versions:
    checked = subprocess.run([options.slipbench, "check", folder, "--quiet"], capture_output=True, text=True)
    if checked.returncode != 0:
        faults.append(f"{folder.name}: slipbench check ended with {checked.returncode}:\n{checked.stdout}{checked.stderr}")
    now = {case.stem: results_of(options.slipbench, case) for case in sorted(folder.glob("*.yaml"))}
    with open(folder / "results.csv", newline="") as file:
        kept = list(csv.DictReader(file))
    if {row["case"] for row in kept} != set(now):
        faults.append(f"{folder.name}: results.csv is not of the cases beside it")
    for row in kept:
        where = f"{folder.name}/{row['case']}: {row['column']}"
        found = now.get(row["case"], {}).get(row["column"])
        wanted = [float(row[key]) for key in ("least", "largest", "last")]
        size = max(map(abs, wanted))
        if found is None:
            faults.append(f"{where}: the column is gone")
        elif any(abs(a - b) > TOLERANCE * size for a, b in zip(found, wanted)):
            faults.append(f"{where}: least, largest and last are {found}, were {wanted}")
print(*faults, f"{len(versions)} versions, {len(faults)} faults", sep="\n")
sys.exit(1 if faults else 0)
