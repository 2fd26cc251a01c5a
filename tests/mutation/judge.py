#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""judge.py BUILD TREE [--all | --count N --seed N] [--most SECONDS] [FILE..]: runs the tests that reach a
mutant of TREE/mutants.json against it, the quickest first, until one fails.

A first pass with --most finds what is caught easily; a second one, with --again, takes the rest whole.

A mutant is caught when a test fails, crashes, or takes more than five times as long as it does else. Unreached are those
that no test runs. What equivalent.txt explains is not run. Exit: 0, or 1 if another one survives or is unreached.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).parent
PROGRAMS = ("law_tests", "property_tests")
RC_PARAMS = "seed=20240611 max_success=1500 max_discard_ratio=100 noshrink=1"  # as the tests have it, and a failure is told at once
LEAST_PER_FILE = 4


def run(command, seconds, **environment):
    """Runs a command with a limit to its CPU time; returns None if all is well, else what is not."""
    seconds = int(5 * seconds) + 2
    try:
        done = subprocess.run(command, env={**os.environ, "RC_PARAMS": RC_PARAMS, **environment}, capture_output=True,
                              errors="replace", timeout=20 * seconds + 60,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1)))
    except subprocess.TimeoutExpired:
        return "time"
    if done.returncode < 0:
        return "time" if done.returncode in (-9, -24) else f"signal {-done.returncode}"
    return None if done.returncode == 0 else f"exit code {done.returncode}"


class Judge:
    def __init__(self, build, tree, with_cases, most):
        self.build, self.tree, self.most = build, tree, most
        self.mutants = json.loads((tree / "mutants.json").read_text())["mutants"]
        self.programs = [p for p in PROGRAMS if (build / "tests" / p).exists()]
        self.slipbench = next((p for p in build.glob("**/slipbench") if p.is_file() and os.access(p, os.X_OK)), None)
        self.tests = []  # (seconds, program, name), the quickest first
        self.reaching = collections.defaultdict(list)  # site: numbers of tests
        for program in self.programs:
            self.measure(program)
        if with_cases and self.slipbench:
            self.measure_cases()
        self.tests.sort(key=lambda t: t[0])
        for number, (_, _, _, sites) in enumerate(self.tests):
            for site in sites:
                self.reaching[site].append(number)

    def measure(self, program):
        """Runs all tests of a program once: how long each takes, and which sites it reaches."""
        with tempfile.NamedTemporaryFile() as file:
            wrong = run([self.build / "tests" / program], 1800, SLIPBENCH_REACHED=file.name)
            if wrong:
                sys.exit(f"error: {program} fails without a mutant: {wrong}")
            for line in open(file.name):
                name, seconds, sites = line.rstrip("\n").split("\t")
                self.tests.append((float(seconds), program, name, frozenset(map(int, sites.split()))))

    def measure_cases(self, longest=0.5):
        """Runs every quick case once; those that are slow or fail without a mutant are left out."""
        for case in sorted((self.tree / "cases").glob("*/*.yaml")):
            if "bad" in case.parts:
                continue
            with tempfile.NamedTemporaryFile() as file:
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                wrong = run([self.slipbench, "check", case], longest, SLIPBENCH_REACHED_AT_EXIT=file.name)
                seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                if not wrong and seconds < longest:
                    self.tests.append((seconds, "slipbench", str(case), frozenset(map(int, open(file.name).read().split()))))

    def batches(self, mutant):
        """Groups the tests that reach a mutant, each group at most four times as long as those before."""
        batch, length, limit, total = [], 0.0, 0.2, 0.0
        for number in self.reaching[mutant["site"]]:
            seconds = self.tests[number][0]
            total += seconds
            if total > self.most:
                break
            if batch and length + seconds > limit:
                yield batch
                batch, length, limit = [], 0.0, 4 * limit
            batch.append(number)
            length += seconds
        if batch:
            yield batch

    def judge(self, mutant):
        """Returns what caught a mutant, 'survived' or 'unreached'."""
        if not self.reaching[mutant["site"]]:
            return "unreached"
        for batch in self.batches(mutant):
            for program in (*self.programs, "slipbench"):
                tests = [self.tests[n] for n in batch if self.tests[n][1] == program]
                if not tests:
                    continue
                seconds, names = sum(t[0] for t in tests), [t[2] for t in tests]
                if program == "slipbench":
                    wrong = run([self.slipbench, "check", *names], seconds, SLIPBENCH_MUTANT=str(mutant["id"]))
                else:
                    with tempfile.NamedTemporaryFile("w") as file:
                        # Catch2 takes a comma for the end of a name, and leaves out a name that it does not know.
                        file.write("".join(name.replace(",", "\\,") + "\n" for name in names))
                        file.flush()
                        wrong = run([self.build / "tests" / program, "--abort", "--input-file", file.name], seconds,
                                    SLIPBENCH_MUTANT=str(mutant["id"]))
                if wrong:
                    return f"{program}: {wrong}"
        return "survived"


def choose(mutants, count, seed):
    """Chooses mutants at random, some of every file. Each has a lot of its own: what is written elsewhere changes no other's."""
    def lot(mutant):
        return hashlib.sha256(f"{seed} {mutant['file']} {mutant['text']} {shown(mutant)}".encode()).digest()
    by_file = collections.defaultdict(list)
    for mutant in sorted(mutants, key=lambda m: (lot(m), m["line"])):
        by_file[mutant["file"]].append(mutant)
    first = [m for name in sorted(by_file) for m in by_file[name][:LEAST_PER_FILE]]
    rest = sorted((m for name in by_file for m in by_file[name][LEAST_PER_FILE:]), key=lambda m: (lot(m), m["line"]))
    return first + rest[:max(0, count - len(first))]


def explained(path):
    """Reads the mutants that no test can catch: file and line of text, mutant or *, reason; then an empty line."""
    known = {}
    for block in path.read_text().split("\n\n"):
        lines = [line.strip() for line in block.splitlines() if line and not line.startswith("#")]
        if lines:
            known.setdefault(lines[0], {})[lines[1]] = " ".join(lines[2:])
    return known


def shown(mutant):
    return " ".join(f"{mutant['from']} -> {mutant['to']}".split())


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("tree", type=pathlib.Path)
    parser.add_argument("files", nargs="*", help="only mutants of these files")
    parser.add_argument("--all", action="store_true", help="all mutants rather than a sample")
    parser.add_argument("--count", type=int, default=600)
    parser.add_argument("--seed", type=int, default=20261125)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--no-cases", action="store_true", help="without `slipbench check`")
    parser.add_argument("--most", type=float, default=float("inf"), help="seconds of tests for one mutant")
    parser.add_argument("--results", type=pathlib.Path, help="where the verdicts go, a line each")
    parser.add_argument("--again", type=pathlib.Path, help="only what survived or was unreached in these verdicts")
    options = parser.parse_intermixed_args()
    start = time.time()

    judge = Judge(options.build, options.tree, not options.no_cases, options.most)
    mutants = [m for m in judge.mutants if not options.files or m["file"] in options.files]
    if options.again:
        left = {(v["file"], v["text"], shown(v)) for v in map(json.loads, options.again.open())
                if v["verdict"] in ("survived", "unreached")}
        mutants = [m for m in mutants if (m["file"], m["text"], shown(m)) in left]
    elif not options.all:
        mutants = choose(mutants, options.count, options.seed)
    print(f"{len(judge.tests)} tests and cases reach {len(judge.reaching)} sites ({time.time() - start:.0f} s); "
          f"{len(mutants)} of {len(judge.mutants)} mutants" + ("" if options.all else f", seed {options.seed}"), flush=True)

    known = explained(HERE / "equivalent.txt")

    def reason(mutant):
        reasons = known.get(f"{mutant['file']}: {mutant['text']}", {})
        return reasons.get(shown(mutant), reasons.get("*"))

    # No test can catch what is explained, and all of them would have to be run.
    verdicts = {m["id"]: "explained" for m in mutants if reason(m)}
    results = options.results.open("w") if options.results else None
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        running = {pool.submit(judge.judge, m): m for m in mutants if m["id"] not in verdicts}
        for done in concurrent.futures.as_completed(running):
            mutant = running[done]
            verdicts[mutant["id"]] = done.result()
            if results:
                print(json.dumps({**mutant, "verdict": done.result()}), file=results, flush=True)
            if len(verdicts) % 100 == 0:
                print(f"  {len(verdicts)} judged, {time.time() - start:.0f} s", flush=True)

    counts = collections.Counter()
    for mutant in sorted(mutants, key=lambda m: m["id"]):
        verdict = verdicts[mutant["id"]]
        counts[verdict if verdict in ("survived", "unreached", "explained") else "caught"] += 1
        if verdict in ("survived", "unreached"):
            print(f"{verdict}: {mutant['file']}:{mutant['line']}: {shown(mutant)}\n    {mutant['text']}")
    print(f"{len(mutants)} mutants: " + ", ".join(f"{counts[k]} {k}" for k in ("caught", "survived", "unreached", "explained")) +
          f"; {time.time() - start:.0f} s")
    return 1 if counts["survived"] + counts["unreached"] else 0


if __name__ == "__main__":
    sys.exit(main())
