# SPDX-License-Identifier: Apache-2.0
"""Takes every case through an Abaqus deck and back, and compares the rows of both runs.

usage: round_trip_test.py SLIPBENCH CASES_FOLDER
"""
import math
import pathlib
import re
import subprocess
import sys
import tempfile

SLIPBENCH, CASES = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
# Of the deck's 20 characters a number, through differences of positions: rates are their quotients.
ROUNDING = 1e-7
# Cases of which fewer come back with the same bytes than today are a loss.
SAME_AT_LEAST = 120
REFUSED_AT_MOST = 40


def run(*words):
    return subprocess.run([SLIPBENCH, *map(str, words)], capture_output=True, text=True, timeout=1200)


def rows(file):
    """The header and the rows, without the comments that name the case."""
    return [line.strip().split(",") for line in file.read_text().splitlines() if not line.startswith("#")]


def difference(one, other):
    """The largest difference of a number, as a part of the largest of its column; or why there is none."""
    if len(one) != len(other) or one[0] != other[0]:
        return "other rows or columns"
    worst = 0.0
    # What is 0 but for rounding has no scale of its own.
    least = 1e-9 * max(abs(float(text)) for row in one[1:] for text in row if text != "nan")
    for header, column in zip(one[0], zip(*one[1:], *other[1:])):
        # Stick becomes slip where rounding decides.
        if header.startswith("STATUS"):
            continue
        numbers = [float(text) for text in column]
        half = len(numbers) // 2
        scale = max(least, *map(abs, numbers[:half])) or 1.0
        pairs = [(a, b) for a, b in zip(numbers[:half], numbers[half:]) if not (math.isnan(a) and math.isnan(b))]
        worst = max([worst, *(abs(a - b) / scale for a, b in pairs)])
    return worst


# What changes a result, other than the rounding of numbers.
LOSS = r"^ *(approximated: (?!numbers:)|dropped: (filter|convention|viscous penalty)\b)"


def main():
    same, close, approximated, refused, faults = [], [], [], {}, []
    with tempfile.TemporaryDirectory(prefix="round-trip-") as name:
        folder = pathlib.Path(name)
        for case in sorted(CASES.glob("*/*.yaml")):
            text = case.read_text()
            if case.parent.name == "bad" or "\ncalibrate:" in text or "\nsweep:" in text:
                continue
            own = folder / f"{case.parent.name}_{case.stem}"
            deck, back = own / "deck.inp", own / "back" / case.name
            exported = run("export", case, "--to", "abaqus", "-o", deck)
            if exported.returncode != 0:
                reason = exported.stderr.strip().rpartition("is not exported: ")[2]
                refused[case.stem] = reason
                if exported.returncode != 2 or not reason or deck.exists():
                    faults.append(f"{case.stem}: refused without a reason: {exported.stderr}")
                continue
            imported = run("import", deck, "-o", back)
            first, second = run("run", case, "-o", own / "a", "-q"), run("run", back, "-o", own / "b", "-q")
            losses = [line for line in exported.stderr.splitlines() if re.search(LOSS, line)]
            if losses:
                approximated.append(case.stem)
                continue
            if imported.returncode != 0 or second.returncode not in (0, 1):
                faults.append(f"{case.stem}: does not come back: {imported.stderr}{second.stderr}"[:400])
                continue
            one, other = (rows(own / which / f"{case.stem}.csv") for which in ("a", "b"))
            if one == other:
                same.append(case.stem)
                continue
            found = difference(one, other)
            close.append(case.stem)
            if isinstance(found, str) or found > ROUNDING:
                faults.append(f"{case.stem}: comes back with {found}")
    print(f"{len(same)} cases come back with the same bytes, {len(close)} but for rounding, "
          f"{len(approximated)} with what is approximated, {len(refused)} are refused")
    for reason in sorted(set(refused.values())):
        print(f"  refused: {reason}: {sum(own == reason for own in refused.values())}")
    for fault in faults:
        print("FAULT", fault)
    ok = not faults and len(same) >= SAME_AT_LEAST and len(refused) <= REFUSED_AT_MOST
    return 0 if ok else 1


sys.exit(main())
