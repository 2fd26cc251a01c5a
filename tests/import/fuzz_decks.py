# SPDX-License-Identifier: Apache-2.0
"""Damages decks and reads them: no crash, no hang, no case of a deck that was refused, and every case that is written
can be read.

usage: fuzz_decks.py SLIPBENCH DECKS_FOLDER [--dialect NAME] [--seconds N] [--seed N] [--keep FOLDER]
"""
import argparse
import collections
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

SLOWEST = 10.0  # seconds; a deck of this size takes milliseconds
MOST_RUNS_TO_READ = 2
NUMBERS = ["0", "-1", "1e400", "-1e-400", "nan", "inf", "1.", ".5", "1d3", "--1", "1e", "", " ", "99999999999999999999", "0x10",
           "2147483648", "1,5", "&x", "&mu", "<mu>", "$x", "[expr 1/0]", "1.5.5", "1e308", "-0"]
WORDS = ["NAME", "END", "STEP", "INCLUDE", "PARAMETER", "NSET", "TYPE", "DEPENDENCIES=3", "INPUT=deck", "GENERATE", "/FRICTION/1",
         "/INTER/TYPE7/3", "#include deck", "*INCLUDE", "*DEFINE_TABLE", "*CONNECTOR FRICTION", "frictionModel", "while {1} {", "}", "proc",
         "source deck", "*END", "/END", "/BEGIN", "//SUBMODEL/1", "*KEYWORD", "'", '"', "\\", ";", "\x00", "\xff", "\t", "#", "$", "**"]


def damaged(lines, donor, dice):
    """A few random changes of a deck; `donor` lends lines of another one."""
    lines = list(lines)
    for _ in range(dice.choice([1, 1, 1, 2, 3, 6])):
        if not lines:
            lines = ["*NODE"]
        at = dice.randrange(len(lines))
        line = lines[at]
        what = dice.randrange(14)
        if what == 0:
            del lines[at]
        elif what == 1:
            lines.insert(at, line)
        elif what == 2:
            other = dice.randrange(len(lines))
            lines[at], lines[other] = lines[other], line
        elif what == 3:
            lines[at] = line[: dice.randrange(len(line) + 1)]
        elif what == 4:
            lines = lines[:at]
        elif what == 5:
            lines.insert(at, dice.choice(donor))
        elif what == 6:
            place = dice.randrange(len(line) + 1)
            lines[at] = line[:place] + dice.choice(WORDS) + line[place:]
        elif what == 7:
            place = dice.randrange(len(line) + 1)
            lines[at] = line[:place] + chr(dice.randrange(256)) + line[place + dice.randrange(2):]
        elif what in (8, 9, 10):
            cut = "," if "," in line else None
            items = line.split(cut)
            if items:
                items[dice.randrange(len(items))] = dice.choice(NUMBERS)
                lines[at] = (cut or " ").join(items)
        elif what == 11:
            lines[at] = line * dice.choice([2, 40])
        elif what == 12:
            lines[at:at] = [line] * dice.choice([3, 200])
        else:
            lines[at] = line.swapcase()
    return lines


class Reader:
    def __init__(self, program, folder):
        self.program = program
        self.folder = folder
        self.counts = collections.Counter()

    def run(self, *words):
        return subprocess.run([self.program, *map(str, words)], capture_output=True, timeout=SLOWEST)

    def fault(self, deck):
        """A sentence, or nothing."""
        out = self.folder / "out"
        shutil.rmtree(out, ignore_errors=True)
        try:
            done = self.run("import", deck, "--all", "--json", "-o", out)
        except subprocess.TimeoutExpired:
            return "the reader hangs"
        self.counts[done.returncode] += 1
        if done.returncode not in (0, 2, 4):
            return f"exit code {done.returncode}: {done.stderr[-300:]!r}"
        written = sorted(out.glob("**/*")) if out.exists() else []
        if done.returncode != 0:
            return f"the deck is refused and {written[0].name} is there" if written else None
        told = json.loads(done.stdout)
        if len(told) != len(written):
            return f"{len(told)} cases are told and {len(written)} are there"
        for one in told[:MOST_RUNS_TO_READ]:
            given = [word for name in one["asked"] for word in ("--set", f"{name}=1")]
            try:
                ran = self.run("run", one["case"], "--no-output", *given)
            except subprocess.TimeoutExpired:
                self.counts["long runs"] += 1
                continue
            self.counts[f"run {ran.returncode}"] += 1
            if ran.returncode not in (0, 1, 2, 3):
                return f"its case ends with exit code {ran.returncode}: {ran.stderr[-300:]!r}"
            # Parts of a set that stands elsewhere have to be filled in; a history may contradict itself.
            if b"nothing was run" in ran.stderr and b"fill in their ids" not in ran.stderr:
                return f"its case is not read: {ran.stderr[:600].decode(errors='replace')}"
        return None


def main():
    options = argparse.ArgumentParser()
    options.add_argument("program", type=lambda name: pathlib.Path(name).resolve())
    options.add_argument("decks", type=pathlib.Path)
    options.add_argument("--dialect")
    options.add_argument("--seconds", type=float, default=5.0, help="of each dialect")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--keep", type=pathlib.Path, help="for decks that show a fault")
    given = options.parse_args()
    faults = 0
    for dialect in sorted(given.decks.iterdir()):
        if not dialect.is_dir() or given.dialect not in (None, dialect.name):
            continue
        seeds = [file for file in sorted(dialect.glob("**/*")) if file.is_file()]
        texts = [file.read_text(encoding="latin-1").split("\n") for file in seeds]
        donor = [line for text in texts for line in text]
        dice = random.Random(given.seed)
        ends = time.monotonic() + given.seconds
        with tempfile.TemporaryDirectory(prefix="fuzz-decks-") as name:
            folder = pathlib.Path(name)
            for file in seeds:
                shutil.copy(file, folder)
            reader = Reader(given.program, folder)
            tried = 0
            while time.monotonic() < ends:
                tried += 1
                which = dice.randrange(len(seeds))
                deck = folder / ("deck" + seeds[which].suffix)
                deck.write_text("\n".join(damaged(texts[which], donor, dice)), encoding="latin-1", errors="replace")
                fault = reader.fault(deck)
                if fault is None:
                    continue
                faults += 1
                print(f"FAULT {dialect.name} {tried} of {seeds[which].name}: {fault}")
                if given.keep:
                    given.keep.mkdir(parents=True, exist_ok=True)
                    shutil.copy(deck, given.keep / f"{dialect.name}_{tried}{deck.suffix}")
            print(f"{dialect.name}: {tried} damaged decks: " + ", ".join(f"{what} {n}" for what, n in sorted(reader.counts.items(), key=str)))
    return 1 if faults else 0


sys.exit(main())
