#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the measurements of cases/calibration: generate.py --slipbench EXE [--check]

Each is a run of the case beside it with other numbers, the truth, plus noise from a seeded generator of this file, so
that every machine makes the same bytes. --check writes nothing and fails if a file is not what it would be.
"""

import argparse
import csv
import math
import pathlib
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
NEWTON_PER_LBF = 4.4482216152605
MM_PER_INCH = 25.4

# What the data were made with. TABLE: coefficients over temperature and slip rate; WEAR: force over accumulated slip.
TABLE = {20: [0.32, 0.31, 0.28, 0.25, 0.24], 60: [0.30, 0.285, 0.26, 0.235, 0.225],
         100: [0.26, 0.25, 0.235, 0.215, 0.21], 140: [0.22, 0.21, 0.20, 0.19, 0.185]}
WEAR = {0: 2400, 250: 1900, 500: 1560, 1000: 1190, 2000: 940, 4000: 850}
# The unknowns of each fit; None where no data tell.
TRUTHS = {
    "slider_loop_fit": {"mu": 0.231, "k": 4210.0},
    "exponential_decay_fit": {"mu_s": 0.42, "mu_k": 0.27, "decay": 0.031},
    # The rig reaches 100 degC, and there only 50 mm/s.
    "rate_temperature_table_fit": {
        f"lining.coefficient[{5 * row + column}].mu": None if T == 140 or (T, column) == (100, 4) else mu
        for row, (T, values) in enumerate(TABLE.items()) for column, mu in enumerate(values)},
    "wear_table_fit": {f"fit.internal_contact_force[{row}].F": force for row, force in enumerate(WEAR.values())},
    "backlash_brake_fit": {"forward": 0.352, "backward": 0.276, "k": 5860.0, "g": 4.27},
}


class Noise:
    """Normal deviates from the SplitMix64 generator: the same everywhere, whatever the version of Python."""

    def __init__(self, seed):
        self.state = seed

    def uniform(self):
        mask = (1 << 64) - 1
        self.state = (self.state + 0x9E3779B97F4A7C15) & mask
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        return ((z ^ (z >> 31)) + 0.5) / 2.0**64

    def normal(self):
        return math.sqrt(-2.0 * math.log(self.uniform())) * math.cos(2.0 * math.pi * self.uniform())


def run(program, case, replacements, settings):
    """The result of a case with some of its text and parameters replaced, {column: [numbers]}."""
    text = (FOLDER / case).read_text()
    for old, new in replacements:
        if text.count(old) != 1:
            sys.exit(f"generate.py: {case} has '{old}' {text.count(old)} times, wanted once")
        text = text.replace(old, new)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / case
        path.write_text(text)
        flags = [flag for name, value in settings.items() for flag in ("--set", f"{name}={value!r}")]
        done = subprocess.run([program, "run", str(path), "-o", folder, *flags], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"generate.py: {case}: run ended with {done.returncode}:\n{done.stdout}{done.stderr}")
        lines = path.with_suffix(".csv").read_text().splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def measurement(program, case, truth, columns, seed, every=1, replacements=()):
    """The text of a measurement. `columns`: (name, result column, factor, noise in the unit of the data, digits)."""
    noise = Noise(seed)
    result = run(program, case, replacements, truth)
    lines = ["# Synthetic: made by generate.py beside it.", ",".join(column[0] for column in columns)]
    for i in range(0, len(result["t"]), every):
        numbers = []
        for _, source, factor, sigma, digits in columns:
            value = result[source][i] * factor + (sigma * noise.normal() if sigma > 0.0 else 0.0)
            numbers.append(f"{value:.{digits}f}")
        lines.append(",".join(numbers))
    return "\n".join(lines) + "\n"


def measurements(program):
    """(file name, text) of each."""
    rig = [("time", "t", 1.0, 0.0, 4), ("disp", "CP1", 1.0 / MM_PER_INCH, 0.0, 5),
           ("load", "CSF1", 1.0 / NEWTON_PER_LBF, 16.0, 1)]
    truth = TRUTHS["slider_loop_fit"]
    yield "slider_loop_rig.csv", measurement(program, "slider_loop.yaml", truth, rig, 1, 2)
    yield "slider_loop_rig_long_stroke.csv", measurement(program, "slider_loop.yaml", {**truth, "stroke": 9.0}, rig, 2,
                                                         2)

    plain = [("t", "t", 1.0, 0.0, 4), ("x", "CP1", 1.0, 0.0, 5), ("F", "CSF1", 1.0, 0.5, 3)]
    yield "exponential_decay_rig.csv", measurement(program, "exponential_decay.yaml", TRUTHS["exponential_decay_fit"],
                                                   plain, 3)

    rates = [0, 5, 20, 60, 120]
    rows = ", ".join(f"[{mu}, {v}, {T}]" for T, values in TABLE.items() for v, mu in zip(rates, values))
    start = ", ".join(f"[0.25, {v}, {T}]" for T in TABLE for v in rates)
    loops = [("t", "t", 1.0, 0.0, 4), ("x", "CP1", 1.0, 0.0, 4), ("T", "temperature", 1.0, 0.0, 1),
             ("F", "CSF1", 1.0, 2.5, 2)]
    yield "rate_temperature_table_rig.csv", measurement(program, "rate_temperature_table.yaml", {}, loops, 4, 1,
                                                        [(start, rows)])

    start = ", ".join(f"[2000, {slip}]" for slip in WEAR)
    rows = ", ".join(f"[{force}, {slip}]" for slip, force in WEAR.items())
    wear = [("t", "t", 1.0, 0.0, 3), ("F", "CSF1", 1.0, 4.0, 2)]
    yield "wear_table_rig.csv", measurement(program, "wear_table.yaml", {}, wear, 5, 1, [(start, rows)])

    brake = [("t", "t", 1.0, 0.0, 4), ("x", "CP1", 1.0, 0.0, 4), ("F", "CSF1", 1e-3, 0.12, 4)]
    truth = TRUTHS["backlash_brake_fit"]
    yield "backlash_brake_rig.csv", measurement(program, "backlash_brake.yaml", truth, brake, 6)
    yield "backlash_brake_rig_short_stroke.csv", measurement(program, "backlash_brake.yaml", {**truth, "stroke": 8.0},
                                                             brake, 7)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--slipbench", required=True)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    stale = []
    for name, text in measurements(options.slipbench):
        path = FOLDER / name
        if not options.check:
            path.write_text(text)
        elif not path.is_file() or path.read_text() != text:
            stale.append(name)
    if stale:
        sys.exit("generate.py: not as generated: " + ", ".join(stale))


if __name__ == "__main__":
    main()
