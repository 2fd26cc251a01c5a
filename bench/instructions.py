#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts the instructions that one more increment takes, and holds them against what is stored.

usage: instructions.py SLIPBENCH [--store] [--only NAME]

Each case of bench/workloads runs twice under callgrind, with N and with 3 N increments; the
difference over 2 N increments has no start-up in it. Counts hardly depend on the machine, but on
the compiler and its options: bench/instructions.csv holds those of the release preset with g++ 12
on x86-64. A workload that takes 3 % more fails (exit code 1); so does one that takes 10 % less,
because then its stored number guards nothing: --store writes what is counted now. Without valgrind
the exit code is 77.
"""
import argparse
import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
STORED = HERE / "instructions.csv"
MOST = 1.03
LEAST = 0.90
INCREMENTS = 1000
# The C library chooses its functions by the machine; without these, all machines take the same.
SAME_LIBRARY = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-AVX512F,-AVX512VL"}


def count(program, case, increments):
    """Returns the instructions of a whole run."""
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", program, "run", case,
               "--no-output", "--quiet", "--set", f"increments={increments}"]
    run = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **SAME_LIBRARY})
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not found:
        sys.exit(f"{' '.join(map(str, command))}\nexit code {run.returncode}\n{run.stdout}{run.stderr}")
    return int(found[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", help="slipbench, built by the release preset")
    parser.add_argument("--store", action="store_true", help="write bench/instructions.csv anew")
    parser.add_argument("--only", metavar="NAME", help="of one workload")
    options = parser.parse_args()
    if not shutil.which("valgrind"):
        print("skipped: valgrind is not installed")
        sys.exit(77)
    with STORED.open(newline="") as file:
        stored = {row["workload"]: float(row["instructions"]) for row in csv.DictReader(file)}
    cases = {path.stem: path for path in sorted((HERE / "workloads").glob("*.yaml"))}
    if options.only:
        cases = {options.only: cases[options.only]}
    counted = {}
    verdicts = []
    print(f"{'workload':20}{'instructions an increment':>27}{'stored':>10}{'ratio':>8}")
    for name, path in cases.items():
        less, more = (count(options.program, path, factor * INCREMENTS) for factor in (1, 3))
        counted[name] = (more - less) / (2 * INCREMENTS)
        before = stored.get(name)
        ratio = counted[name] / before if before else float("nan")
        word = ("  not stored" if not before else "  TOO MANY" if ratio > MOST
                else "  fewer: store it" if ratio < LEAST else "")
        print(f"{name:20}{counted[name]:27.0f}{before or float('nan'):10.0f}{ratio:8.3f}{word}", flush=True)
        if word:
            verdicts.append(name)
    if options.store:
        stored.update(counted)
        with STORED.open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["workload", "instructions"])
            writer.writerows((name, round(value)) for name, value in sorted(stored.items()))
        return
    if not options.only and set(stored) != set(cases):
        verdicts.append(f"{STORED.name} has {', '.join(sorted(set(stored) ^ set(cases)))} alone")
    if verdicts:
        sys.exit(f"{'; '.join(verdicts)}: find the reason, then run {pathlib.Path(sys.argv[0]).name} --store")


if __name__ == "__main__":
    main()
