#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares what two builds of slipbench write and say, byte by byte, over all cases of a folder.

same_results.py OLD NEW [FOLDER]: runs every case below FOLDER (cases/), and calibrates every fit, by both programs. Files,
messages and exit codes must be the same, but for times of the clock and the version in JSON files.
Exit: 0 all the same, 1 something differs (both sides are kept, and told), 2 a wrong argument.
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# What a clock measured, what is said of a run that takes long, and the version of the program.
CHANGING = [(re.compile(rb"^.* increments take some .*\n", re.MULTILINE), b""),
            (re.compile(rb"\b[0-9.]+ (m?s|us)\b(?=[,;)]?( |\n|$))"), b"TIME"),
            (re.compile(rb'("version": ")[^"]*'), rb"\1VERSION"),
            (re.compile(rb'("(seconds|wall_time|time_per_run)": )[0-9.e+-]+'), rb"\1TIME")]


def constant(text):
    for pattern, name in CHANGING:
        text = pattern.sub(name, text)
    return text


def outputs(program, case, folder):
    """Returns all that `program` writes for `case`: a name of each output, and its bytes."""
    is_fit = re.search(r"^calibrate:", case.read_text(errors="replace"), re.MULTILINE)
    command = [program, *(["calibrate"] if is_fit else ["run", "--solver-report"]), str(case), "-o", str(folder)]
    ran = subprocess.run(command, capture_output=True, timeout=600, env={**os.environ, "LC_ALL": "C.UTF-8"})
    found = {"exit code": str(ran.returncode).encode()}
    for name, text in (("stdout", ran.stdout), ("stderr", ran.stderr)):
        found[name] = constant(text.replace(str(folder).encode(), b"OUT"))
    for path in sorted(folder.rglob("*")) if folder.exists() else []:
        if path.is_file():
            text = path.read_bytes()
            found[str(path.relative_to(folder))] = text if path.suffix == ".csv" else constant(text)
    return found


def difference(programs, case, folder):
    old, new = (outputs(program, case, folder / side) for program, side in zip(programs, ("old", "new")))
    names = [name for name in sorted({*old, *new}) if old.get(name) != new.get(name)]
    if names:
        for side, found in (("old", old), ("new", new)):
            (folder / side).mkdir(parents=True, exist_ok=True)
            for name in ("exit code", "stdout", "stderr"):
                (folder / side / name).write_bytes(found[name])
    else:
        shutil.rmtree(folder, ignore_errors=True)
    return names, len(new)


def main(arguments):
    if len(arguments) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    programs = [os.path.abspath(program) for program in arguments[:2]]
    for program in programs:
        if not os.access(program, os.X_OK):
            print(f"{program}: no program that can be run", file=sys.stderr)
            return 2
    source = pathlib.Path(__file__).resolve().parents[2]
    cases = sorted(pathlib.Path(arguments[2] if len(arguments) == 3 else source / "cases").rglob("*.yaml"))
    if not cases:
        print(f"{arguments[-1]}: no case in it", file=sys.stderr)
        return 2
    top = pathlib.Path(tempfile.mkdtemp(prefix="same_results."))
    compared = differing = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = [pool.submit(difference, programs, case, top / str(i)) for i, case in enumerate(cases)]
        for i, (case, job) in enumerate(zip(cases, jobs)):
            names, count = job.result()
            compared += count
            if names:
                differing += 1
                print(f"{case}: {', '.join(names)} differ: {top / str(i)}")
    print(f"{len(cases)} cases, {compared} outputs, {differing} cases differ")
    if not differing:
        shutil.rmtree(top)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
