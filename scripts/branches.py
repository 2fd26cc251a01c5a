#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""branches.py BUILD OUTPUT LEAST FOLDER..: how many branches of the sources in FOLDER.. the tests took, by gcov's counts in BUILD.

A branch of a template is one branch, taken if any of its instances took it; gcovr counts each instance. Branches that only an
exception takes do not count, nor those of lines on which no condition, loop or comparison stands: a list in braces is taken down
in a loop of the compiler's own. OUTPUT lists by file the lines with a branch never taken.
Exit: 0, or 1 if less than LEAST percent were taken.
"""
import collections
import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys

CONDITION = re.compile(r"\b(if|for|while|switch|case|do)\b|\?|&&|\|\||[=!]=|[<>]")


def counts(arguments):
    """Branch counts of one object: (file, line, [count..]) of each function that has branches there."""
    build, object_file, folders = arguments
    done = subprocess.run(["gcov", "--json-format", "--branch-probabilities", "--stdout", object_file], cwd=build, capture_output=True, text=True)
    found = []
    for text in done.stdout.splitlines():
        for file in json.loads(text)["files"]:
            path = pathlib.Path(build, file["file"]).resolve()
            if not path.is_relative_to(pathlib.Path.cwd()) or path.relative_to(pathlib.Path.cwd()).parts[0] not in folders:
                continue
            name = str(path.relative_to(pathlib.Path.cwd()))
            for line in file["lines"]:
                taken = [b["count"] != 0 for b in line["branches"] if not b["throw"]]
                if taken:
                    found.append((name, line["line_number"], taken))
    return found


def main(build, output, least, *folders):
    objects = [str(path.resolve()) for path in pathlib.Path(build).glob("**/*.gcda")]
    merged = collections.defaultdict(dict)  # file: (line, number of branches): taken
    with concurrent.futures.ProcessPoolExecutor() as pool:
        for found in pool.map(counts, ((build, one, folders) for one in objects), chunksize=4):
            for name, line, taken in found:
                before = merged[name].setdefault((line, len(taken)), [False] * len(taken))
                merged[name][line, len(taken)] = [a or b for a, b in zip(before, taken)]
    all_taken = all_branches = 0
    rows = []
    for name, lines in sorted(merged.items()):
        text = pathlib.Path(name).read_text().splitlines()
        lines = {key: taken for key, taken in lines.items() if CONDITION.search(text[key[0] - 1].split("//")[0])}
        branches = sum(map(len, lines.values()))
        taken = sum(sum(one) for one in lines.values())
        missed = sorted({line for (line, _), one in lines.items() if not all(one)})
        rows.append(f"{name} {taken} of {branches}: {','.join(map(str, missed))}\n")
        all_branches += branches
        all_taken += taken
    pathlib.Path(output).write_text("".join(rows))
    if not all_branches:
        sys.exit("branches.py: error: gcov has counted nothing there")
    percent = 100.0 * all_taken / all_branches
    print(f"branches: {percent:.1f} % ({all_taken} of {all_branches})")
    sys.exit(percent < float(least))


if __name__ == "__main__":
    main(*sys.argv[1:])
