# SPDX-License-Identifier: Apache-2.0
"""Takes the friction of every case through the decks of programs that state it of contacts, and back.

usage: contact_round_trip_test.py SLIPBENCH CASES_FOLDER
"""
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

SLIPBENCH, CASES = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
# Cases of which fewer come back in all digits than today, or more are refused, are a loss.
SAME_AT_LEAST = {"radioss": 190, "lsdyna": 190, "opensees": 173, "table": 167}
REFUSED_AT_MOST = {"radioss": 49, "lsdyna": 33, "opensees": 59, "table": 46}
# A constant that is read from a table is another sum in the last digits, and exact integration sums
# up more of them.
ROUNDED = {"table": 1e-11}
# Points of tables are set to 1e-4 of the largest coefficient; rates that fall with slip double it.
TABLE = 1e-3
# What is not in a deck may change as much as it likes, if it is told.
TOLD = ("force_limit", "dependence on", "viscous penalty", "filter", "stick stiffness", "changes of friction")


def same(found, part):
    """Tells whether forces and dissipation of both cases are apart by no more than a part of them."""
    work = found["dissipation"]
    return (found["force_most"] <= part * found["force_largest"]
            and abs(work - found["other_dissipation"]) <= part * abs(work))


def main():
    faults = []
    with tempfile.TemporaryDirectory(prefix="contact-round-trip-") as name:
        deck = pathlib.Path(name) / "deck"
        for program, least in SAME_AT_LEAST.items():
            counts, reasons = collections.Counter(), collections.Counter()
            for case in sorted(CASES.glob("*/*.yaml")):
                text = case.read_text()
                if case.parent.name == "bad" or "\ncalibrate:" in text or "\nsweep:" in text:
                    continue
                done = subprocess.run([SLIPBENCH, "export", case, "--to", program, "--json", "--force", "-o", deck],
                                      capture_output=True, text=True, timeout=1200)
                if done.returncode != 0:
                    reason = done.stderr.strip().rpartition("is not exported: ")[2]
                    counts["refused"] += 1
                    reasons[reason] += 1
                    if done.returncode != 2 or not reason:
                        faults.append(f"{program} {case.stem}: refused without a reason: {done.stderr}")
                    continue
                told = json.loads(done.stdout)
                found = told["on_the_history"]
                if "force_most" not in found:
                    counts["not run"] += 1
                    faults.append(f"{program} {case.stem}: {found['text']}")
                elif same(found, ROUNDED.get(program, 0.0)):
                    counts["in all digits"] += 1
                else:
                    off = found["force_most"] > TABLE * found["force_largest"]
                    counts["with what is told" if off else "within 0.1 %"] += 1
                    if off and not any(part in one for one in told["losses"]["dropped"] for part in TOLD):
                        faults.append(f"{program} {case.stem}: {found['text']}, and nothing is told")
            print(f"{program}: " + ", ".join(f"{number} {what}" for what, number in sorted(counts.items())))
            for reason, number in reasons.most_common():
                print(f"  refused: {reason}: {number}")
            if counts["in all digits"] < least or counts["refused"] > REFUSED_AT_MOST[program]:
                faults.append(f"{program}: {dict(counts)}")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


sys.exit(main())
