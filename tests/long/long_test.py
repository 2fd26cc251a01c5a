#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs what is long or large: time grows with the size, memory does not, and the numbers stay exact.

usage: long_test.py --slipbench EXE [--size N] [NAME..]

Each try is made with a tenth of its size and with all of it. The full sizes (--size 1, the default) take some ten minutes, 3 GB of disk:
  increments   10^8 increments of a slider, to and fro: its dissipated energy against the closed form
  csv          a motion from a CSV file of 2 GB
  suite        100,000 cases in one folder
  definitions  1,000 definitions, of pairs of parts, of which the last is meant
  table        10^6 rows of the internal contact force over the accumulated slip
--size 0.001 makes a thousandth of each, for a quick look at whether they work at all: of so little no time is judged.
"""
import argparse
import json
import math
import os
import pathlib
import re
import sys
import tempfile
import time

HEAD = "slipbench: 1\nunits: {length: mm, force: N, time: s}\nconnector: {type: SLOT}\n"
PRESS = "  - {step: press, increments: 1, force: {f2: {to: 100}}}\n"
AMPLITUDE = 0.7  # mm
MEGABYTES = 200  # most that any size may take
faults = []


def expect(condition, message):
    if not condition:
        faults.append(message)


def run(folder, *arguments):
    """Runs the program; returns seconds, megabytes and what it said."""
    with open(folder / "said", "w+b") as said:
        began = time.monotonic()
        pid = os.posix_spawn(program, [program, *map(str, arguments)], os.environ,
                             file_actions=[(os.POSIX_SPAWN_DUP2, said.fileno(), 1), (os.POSIX_SPAWN_DUP2, said.fileno(), 2)])
        _, status, used = os.wait4(pid, 0)
        seconds = time.monotonic() - began
        said.seek(0)
        text = said.read().decode()
    if os.waitstatus_to_exitcode(status) != 0:
        sys.exit(f"{arguments} ended with {os.waitstatus_to_exitcode(status)}:\n{text[-2000:]}")
    return seconds, used.ru_maxrss / 1024, text


def summary_of(folder, name):
    return json.loads((folder / f"out/{name}.json").read_text())["summary"]


def slider(count, cycles, extra=""):
    return (HEAD + "friction:\n  - {predefined: {}, coefficient: 0.2, stick: {stiffness: 1.0e+4}}\n" + extra + "history:\n" + PRESS +
            f"  - {{step: rub, increments: {count}, motion: {{CP1: {{triangle: {{amplitude: {AMPLITUDE}, period: = 1/{cycles}}}}}}}}}\n"
            "output: {columns: [CSF1, DISS], every: 1000000}\n")


def increments(folder, size):
    # Of powers of two the times are exact, and with them the places of reversal: what is left is the law's and the sums'.
    count = 2 ** max(10, round(math.log2(1e8 * size)))
    cycles = count // 128
    (folder / "slider.yaml").write_text(slider(count, cycles))
    cost = run(folder, "run", folder / "slider.yaml", "-o", folder / "out")
    # The way of a cycle is 4 amplitudes; of it 2 F/k at each of the two reversals, and F/k at the first start, are elastic.
    force, stiffness = 20.0, 1e4
    exact = 4 * force * (AMPLITUDE - force / stiffness) * cycles - force * force / stiffness
    one = summary_of(folder, "slider")["definitions"][0]
    slip, gap = one["accumulated_slip"] / (exact / force) - 1, one["energy_balance_residual"]
    print(f"  {count} increments: dissipation off by {one['dissipation'] / exact - 1:.1e}, accumulated slip by {slip:.1e}, energy balance {gap:.1e}")
    # Rounding of as many additions: at the worst half of 2^-52 each, 1e-8; the parts differ, so they mostly cancel.
    expect(abs(one["dissipation"] / exact - 1) < 1e-10, f"{count} increments: dissipated {one['dissipation']!r}, wanted {exact!r}")
    expect(abs(slip) < 1e-10, f"{count} increments: slip {one['accumulated_slip']!r}, wanted {exact / force!r}")
    expect(abs(gap) < 1e-10, f"{count} increments: the energy balance is off by {gap!r}")
    return cost


def csv(folder, size):
    rows = max(1000, int(5e7 * size))
    with open(folder / "motion.csv", "w") as file:
        file.write("time,way\n")
        cycle = [(0.0, 1.0, 0.0, -1.0)[i % 4] for i in range(1000)]
        for begin in range(0, rows, 1000):
            file.write("".join(f"{begin + i}.000000000000,{cycle[i]:.17f}\n" for i in range(1000)))
    (folder / "csv.yaml").write_text(HEAD + "friction:\n  - {predefined: {}, coefficient: 0.2, stick: {stiffness: 1.0e+4}}\nhistory:\n" + PRESS +
                                     f"  - {{step: rub, duration: {rows - 1}, increments: 1000, motion: {{CP1: {{csv: motion.csv, time: time, value: way}}}}}}\n"
                                     "output: {every: 1000000}\n")
    cost = run(folder, "run", folder / "csv.yaml", "-o", folder / "out")
    # 0, 1, 0, -1, ..: the first row of a cycle and its third are 0, so all that is read shows in the way.
    one = summary_of(folder, "csv")
    slip, elastic = one["definitions"][0]["accumulated_slip"], 20.0 / 1e4
    turns = (rows - 2) // 2  # at the second row, then at every other one
    expect(one["end_time"] == rows and abs(slip / (rows - 1 - elastic - 2 * elastic * turns) - 1) < 1e-8, f"{rows} rows: {one}")
    return cost


def suite(folder, size):
    count = max(100, int(1e5 * size))
    (folder / "cases").mkdir()
    text = slider(10, 1).split("output")[0] + ("checks:\n  - {name: limit, quantity: FLIM, against: {expression: = 20}, over: {from: 1}, "
                                                "tolerance: {relative: 1.0e-12, why: rounding}}\n")
    for i in range(count):
        (folder / f"cases/case_{i}.yaml").write_text(text)
    cost = run(folder, "check", folder / "cases", "--quiet", "--json", folder / "check.json")
    expect(re.search(rf"\b{count} cases passed, 0 failed", cost[2].replace(",", "", 1)) or f"{count} cases passed" in cost[2], f"{count} cases: {cost[2][-300:]}")
    return cost


def definitions(folder, size):
    count = max(10, int(1000 * size))
    pairs = "".join(f"    - {{parts: [{i}, {i + 1}], coefficient: {0.1 + 0.0001 * i:.4f}}}\n" for i in range(1, count + 1))
    (folder / "many.yaml").write_text(HEAD.replace("SLOT", f"SLOT, parts: [{count}, {count + 1}]") + "friction_pairs:\n  pairs:\n" + pairs +
                                      "friction: [{predefined: {}, stick: {stiffness: 1.0e+4}}]\nhistory:\n" + PRESS +
                                      "  - {step: rub, increments: 1000, motion: {CP1: {triangle: {amplitude: 1, period: 1}}}}\n")
    cost = run(folder, "run", folder / "many.yaml", "-o", folder / "out")
    force, wanted = summary_of(folder, "many")["definitions"][0]["highest_force"], 100 * (0.1 + 0.0001 * count)
    expect(abs(force / wanted - 1) < 1e-12, f"{count} definitions: the force is {force!r}, wanted {wanted!r}")
    return cost


def table(folder, size):
    rows = max(1000, int(1e6 * size))
    lines = ",\n      ".join(f"[{100 - 50 * i / rows!r}, {i * 4.0 / rows!r}]" for i in range(rows))
    (folder / "table.yaml").write_text(HEAD + "friction:\n  - component: 1\n    coefficient: 0.2\n    internal_contact_force:\n      columns: [force, accumulated_slip]\n"
                                       f"      rows: [{lines}]\n    stick: {{stiffness: 1.0e+6}}\nhistory:\n"
                                       "  - {step: rub, increments: 1000, motion: {CP1: {to: 2}}}\n")
    cost = run(folder, "run", folder / "table.yaml", "-o", folder / "out")
    one = summary_of(folder, "table")["definitions"][0]
    # The rows are those of a straight line, 100 N less 12.5 N/mm.
    wanted = 0.2 * (100 - 12.5 * one["accumulated_slip"])
    expect(one["accumulated_slip"] > 1.99 and abs(one["stored_energy"] / (wanted**2 / 2e6) - 1) < 1e-9, f"{rows} rows: {one}, wanted the force {wanted}")
    return cost


tries = {f.__name__: f for f in (increments, csv, suite, definitions, table)}
parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(tries))
parser.add_argument("--slipbench", required=True, help="the program")
parser.add_argument("--size", type=float, default=1.0, help="part of the full sizes")
options = parser.parse_args()
program = str(pathlib.Path(options.slipbench).resolve())
for name in options.names or tries:
    costs = []
    for size in (0.1 * options.size, options.size):
        with tempfile.TemporaryDirectory() as folder:
            costs.append(tries[name](pathlib.Path(folder), size))
    (small, _, _), (seconds, megabytes, _) = costs
    print(f"{name:12} {seconds:8.2f} s, {seconds / small:5.1f} times a tenth of it, {megabytes:6.0f} MB", flush=True)
    expect(megabytes < MEGABYTES, f"{name}: takes {megabytes:.0f} MB")
    if small > 1:
        expect(seconds < 20 * small, f"{name}: ten times the size takes {seconds / small:.1f} times the time")
print(*faults, f"{len(faults)} faults", sep="\n")
sys.exit(1 if faults else 0)
