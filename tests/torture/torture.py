# SPDX-License-Identifier: Apache-2.0
"""Ends commands at random moments, takes disk, memory and files from them, and looks at what they leave: no hidden file, and
under a final name nothing but what a run in peace writes.

usage: torture.py SLIPBENCH SOURCES [--kills N] [--seconds S] [--seed N] [--only NAME,..]
Exit: 0 as it should be, 1 something was not, which is told.
"""
import argparse
import collections
import contextlib
import json
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

LONGEST = 120.0  # seconds, of a command in peace on a busy machine
INTERRUPTED_WITHIN = 1.0  # seconds; the code allows no more work than to remove files
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143}
HELPFUL = {"LC_ALL": "C.UTF-8", "PATH": os.environ["PATH"]}


class Torture:
    def __init__(self, program, sources, folder, dice):
        self.program = program
        self.folder = folder
        self.dice = dice
        self.faults = []
        self.told = []
        self.number = 0
        cases = sources / "cases"
        self.inputs = folder / "in"
        self.inputs.mkdir()
        for name in ("calibration", "sweeps"):
            for file in (cases / name).iterdir():
                shutil.copy(file, self.inputs)
        long = (cases / "sweeps" / "slot.yaml").read_text().replace("increments: 2000", "increments: 20000")
        (self.inputs / "long.yaml").write_text(long)
        self.suite = folder / "suite"
        self.suite.mkdir()
        for file in sorted((cases / "examples").glob("*.yaml"))[:12]:
            shutil.copy(file, self.suite)
        for file in (cases / "examples").glob("*.csv"):
            shutil.copy(file, self.suite)
        self.commands = {
            "run": ["run", "long.yaml", "-o", "OUT"],
            "check": ["check", str(self.suite), "--junit", "OUT/a.xml", "--json", "OUT/a.json", "--report", "OUT/a.html"],
            "calibrate": ["calibrate", "slider_loop_fit.yaml", "-o", "OUT"],
            "sweep": ["sweep", "slot_sweep.yaml", "-o", "OUT", "-j", "2"],
            "report": ["report", str(self.suite), "-o", "OUT/page.html"],
        }
        self.peace = {}
        self.seconds = {}

    # what is asked of every command

    def words(self, command, out):
        return [str(self.program), *(word.replace("OUT", str(out)) for word in command)]

    def environment(self):
        return dict(HELPFUL, HOME=str(self.folder), XDG_CACHE_HOME=str(self.folder / "cache"))

    def start(self, command, out, before=None, prefix=()):
        return subprocess.Popen([*prefix, *self.words(command, out)], cwd=self.inputs, env=self.environment(), stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=before)

    def ended(self, command, out, before=None, prefix=()):
        """Runs a command to its end: its exit code, and what it said."""
        process = self.start(command, out, before, prefix)
        _, said = process.communicate(timeout=LONGEST)
        return process.returncode, said.decode(errors="replace")

    def fresh(self):
        self.number += 1
        return self.folder / f"out{self.number}"

    def fault(self, text):
        self.faults.append(text)
        print("FAULT", text, flush=True)

    def learn(self):
        """Runs every command twice in peace: its files, which of them have always the same bytes, and how long it takes."""
        for name, command in self.commands.items():
            files = []
            for _ in range(2):
                out = self.fresh()
                begin = time.monotonic()
                code, said = self.ended(command, out)
                self.seconds[name] = time.monotonic() - begin
                if code not in (0, 1, 3):
                    sys.exit(f"{name} in peace ends with {code}: {said}")
                files.append({file.name: file.read_bytes() for file in sorted(out.iterdir())})
                shutil.rmtree(out)
            self.peace[name] = {file: text if files[1].get(file) == text else None for file, text in files[0].items()}

    def look(self, name, out, what, journal=True, same=True):
        """Judges the files that a command left."""
        hidden = 0
        if not out.exists():
            return hidden
        for file in sorted(out.rglob("*")):
            if file.is_dir():
                continue
            if file.name.startswith("."):
                # Between two calls a file that replaces another has a hidden name, or that other one; both are complete.
                hidden += 1
                own = re.fullmatch(r"\.(.*)\.[A-Za-z0-9]{6}", file.name)
                if not own or own[1] not in self.peace[name] or not self.is_whole(file, self.peace[name][own[1]], pathlib.Path(own[1]).suffix):
                    self.fault(f"{what}: {file.name} is left")
            elif journal and file.suffix in (".journal", ".tally"):
                continue
            elif file.name not in self.peace[name]:
                self.fault(f"{what}: {file.name} is there, which a run in peace does not write")
            elif not self.is_whole(file, self.peace[name][file.name] if same else None):
                self.fault(f"{what}: {file.name} is not as in peace")
        return hidden

    @staticmethod
    def is_whole(file, wanted, suffix=None):
        """Compares with the bytes of a run in peace, or where these have times looks for the end."""
        text, suffix = file.read_bytes(), suffix or file.suffix
        if wanted is not None:
            return text == wanted
        try:
            if suffix == ".json":
                json.loads(text)
            elif suffix in (".xml", ".svg"):
                xml.etree.ElementTree.fromstring(text)
            else:
                return text.rstrip().endswith(b"</html>")
        except (ValueError, xml.etree.ElementTree.ParseError):
            return False
        return True

    # the trials

    def kills(self, count):
        hidden = killed = 0
        for i in range(count):
            name = self.dice.choice(list(self.commands))
            out = self.fresh()
            replaces = self.dice.random() < 0.3
            if replaces:
                self.ended(self.commands[name], out)
            process = self.start(self.commands[name], out)
            time.sleep(self.dice.uniform(0.0, 1.1 * self.seconds[name]))
            process.kill()
            process.communicate()
            killed += process.returncode == -signal.SIGKILL
            what = f"kill -9 of {name}, number {i}"
            left = self.look(name, out, what)
            if left and not replaces:
                self.fault(f"{what}: {left} hidden files are left of new results")
            hidden += left
            if i % 5 == 0 or name == "sweep":
                # The same command afterwards goes on, or begins anew, to the same end.
                code, said = self.ended(self.commands[name], out)
                if code not in (0, 1):
                    self.fault(f"{what}: afterwards it ends with {code}: {said}")
                # What the kill has left stays, as another program may own it.
                if self.look(name, out, what + ", and run again", journal=False) > left or not set(self.peace[name]) <= {f.name for f in out.iterdir()}:
                    self.fault(f"{what}: afterwards {sorted(f.name for f in out.iterdir())} are there")
            shutil.rmtree(out, ignore_errors=True)
        if hidden > 1 + count // 100:
            self.fault(f"{hidden} hidden files were left by {count} kills")
        return f"{killed} of {count} killed before their end, {hidden} complete files left under a hidden name"

    def parts(self, count):
        """Kills a part of a sweep and joins: what is joined is whole, or refused."""
        joined = 0
        sweep = self.commands["sweep"]
        for i in range(count):
            out = self.fresh()
            self.ended([*sweep, "--part", "1/2"], out)
            process = self.start([*sweep, "--part", "2/2"], out)
            time.sleep(self.dice.uniform(0.0, 0.6 * self.seconds["sweep"]))
            process.kill()
            process.communicate()
            code, said = self.ended(["merge", "slot_sweep.yaml", "-o", "OUT"], out)
            whole = {name: file for name, file in self.peace["sweep"].items() if (out / name).exists()}
            if code == 0:
                joined += 1
                for name in self.peace["sweep"]:
                    if name not in whole or not self.is_whole(out / name, whole[name]):
                        self.fault(f"merge after kill {i}: {name} is not as in peace")
            elif code != 2 or whole:
                self.fault(f"merge after kill {i} ends with {code} and {sorted(whole)}: {said}")
            shutil.rmtree(out, ignore_errors=True)
        return f"{count} parts killed, {joined} joined, the others refused"

    def signals(self, count):
        slowest = 0.0
        caught = 0
        for i in range(count):
            name = self.dice.choice(list(self.commands))
            number = self.dice.choice([signal.SIGINT, signal.SIGTERM])
            out = self.fresh()
            process = self.start(self.commands[name], out)
            time.sleep(self.dice.uniform(0.03, 0.9 * self.seconds[name]))
            begin = time.monotonic()
            process.send_signal(number)
            process.communicate()
            took = time.monotonic() - begin
            what = f"{number.name} to {name}, number {i}"
            self.look(name, out, what)
            left = [file.name for file in out.iterdir() if file.suffix not in (".journal", ".tally")] if out.exists() else []
            if process.returncode == CODES[number]:
                caught += 1
                slowest = max(slowest, took)
                if took > INTERRUPTED_WITHIN:
                    self.fault(f"{what}: it takes {took:.2f} s")
                # Files that belong together come together, if it came too late; the pictures of a fit after the rest.
                drawn = {file for file in self.peace[name] if name == "calibrate" and file.endswith(".svg")}
                if left and not set(self.peace[name]) - drawn <= set(left) <= set(self.peace[name]):
                    self.fault(f"{what}: {left} are there")
            elif process.returncode == -number and not left:
                pass  # before the program had begun to listen
            elif process.returncode not in (0, 1):
                self.fault(f"{what}: ends with {process.returncode}")
            shutil.rmtree(out, ignore_errors=True)
        return f"{caught} of {count} caught, the slowest in {slowest:.2f} s"

    def refused(self, what, name, out, before=None, prefix=(), codes=(4,), said_too=""):
        code, said = self.ended(self.commands[name], out, before, prefix)
        if code not in codes:
            self.fault(f"{what}: {name} ends with {code}: {said.strip()[-300:]}")
        elif code != 0 and said_too not in said:
            self.fault(f"{what}: {name} does not say '{said_too}': {said.strip()[-300:]}")
        self.look(name, out, f"{what}, {name}")

    @contextlib.contextmanager
    def mounted(self, options):
        """A small file system of its own in memory, or nothing where it may not be mounted."""
        place = self.folder / "mounted"
        place.mkdir(exist_ok=True)
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", str(place)], capture_output=True)
        if done.returncode != 0:
            yield None
            return
        try:
            yield place
        finally:
            subprocess.run(["umount", "-l", str(place)], check=True)

    def full_disk(self, sizes):
        for size in [32, *self.dice.sample(range(48, 512, 8), sizes)]:
            with self.mounted(f"size={size}k") as place:
                if place is None:
                    return "no small file system may be mounted here; the limit of a file's size stands for it"
                for name in self.commands:
                    self.refused(f"a disk of {size} KB", name, place, codes=(4,) if size == 32 else (0, 1, 4))
                    for file in place.iterdir():
                        file.unlink()
                self.pictures(size, place)
        return f"a tmpfs of 32 KB, and {sizes} of up to 512 KB"

    def pictures(self, size, place):
        """Draws a result that lies elsewhere: a picture is whole, or is not there."""
        if shutil.which("gnuplot") is None:
            return
        drawn = self.folder / "drawn"
        if not drawn.exists():
            self.ended(["run", str(self.suite / "shock_absorber.yaml"), "-o", str(drawn)], None)
        for ending in ("svg", "png", "pdf"):
            plot = ["plot", str(drawn / "shock_absorber.csv"), "-o", "OUT"]
            whole, picture = drawn / f"whole.{ending}", place / f"a.{ending}"
            if not whole.exists():
                self.ended(plot, whole)
            code, said = self.ended(plot, picture)
            if code not in (0, 4) or picture.exists() != (code == 0) or (code == 0 and picture.stat().st_size != whole.stat().st_size):
                self.fault(f"a disk of {size} KB: plot {ending} ends with {code}: {said.strip()[-300:]}")
            for file in place.iterdir():
                file.unlink()

    def read_only(self):
        with self.mounted("ro") as place:
            if place is None and os.geteuid() == 0:
                return "not tried: root may write anywhere, and nothing may be mounted"
            out = place or self.fresh()
            if place is None:
                out.mkdir()
                out.chmod(0o555)
            for name in self.commands:
                self.refused("a folder that is read only", name, out)
        return "a tmpfs that is read only" if place else "a folder without the right to write"

    def limits(self, sizes):
        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))

        for name in self.commands:
            # A page of a calibration, and a journal, are larger as well.
            self.refused("files of 8 KB at most", name, self.fresh(), before=small_files, said_too="File too large")
        # A program with a sanitizer asks for more than there is, and uses little of it.
        enough = lambda: resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))
        if subprocess.run([str(self.program), "--version"], capture_output=True, preexec_fn=enough).returncode != 0:
            return "files of 8 KB; not of memory, of which a program with sanitizers wants terabytes"
        ends = collections.Counter()
        for megabytes in self.dice.sample(range(16, 160), sizes):
            def little_memory(size=megabytes << 20):
                resource.setrlimit(resource.RLIMIT_AS, (size, size))
                resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

            for name in self.commands:
                out = self.fresh()
                code, said = self.ended(self.commands[name], out, before=little_memory)
                # 127: the loader itself has too little. The scanner of UDUNITS ends the program by itself.
                if (code not in (0, 4, 127) and "out of dynamic memory in ut_scan" not in said) or (code == 4 and "memory" not in said):
                    self.fault(f"{megabytes} MB of memory: {name} ends with {code}: {said.strip()[-300:]}")
                ends[code] += 1
                # A page may say that a case had too little; a result is what it would be.
                self.look(name, out, f"{megabytes} MB of memory, {name}", same=name in ("run", "sweep", "calibrate"))
                shutil.rmtree(out, ignore_errors=True)
        told = ", ".join(f"{n} end with {code}" for code, n in sorted(ends.items()))
        return f"files of 8 KB; of runs with 16 to 160 MB of memory {told}"

    def inputs_gone(self):
        for name, file in (("run", "long.yaml"), ("calibrate", "slider_loop_rig.csv"), ("sweep", "slot.yaml")):
            for share in (0.0, 0.1, 0.3, 0.6):
                out = self.fresh()
                text = (self.inputs / file).read_bytes()
                process = self.start(self.commands[name], out)
                time.sleep(share * self.seconds[name])
                (self.inputs / file).unlink()
                _, said = process.communicate(timeout=LONGEST)
                (self.inputs / file).write_bytes(text)
                if process.returncode not in (0, 2, 4):
                    self.fault(f"{file} vanishes under {name}: it ends with {process.returncode}: {said[-300:]!r}")
                self.look(name, out, f"{file} vanishes under {name}")
        return "inputs of run, calibrate and sweep"

    def two_at_once(self, count):
        refused = 0
        for i in range(count):
            for name in self.commands:
                out = self.fresh()
                both = [self.start(self.commands[name], out) for _ in range(2)]
                for process in both:
                    _, said = process.communicate(timeout=LONGEST)
                    told = said.decode(errors="replace")
                    if name == "sweep" and process.returncode == 4 and "another run of this sweep" in told:
                        refused += 1
                    elif process.returncode not in (0, 1):
                        self.fault(f"two of {name} in one folder: one ends with {process.returncode}: {told.strip()[-300:]}")
                if self.look(name, out, f"two of {name} in one folder", journal=False):
                    self.fault(f"two of {name} in one folder leave a hidden file")
                if not set(self.peace[name]) <= {file.name for file in out.iterdir()}:
                    self.fault(f"two of {name} in one folder: not all files are there")
                shutil.rmtree(out, ignore_errors=True)
        return f"{count} times each, {refused} second sweeps refused"

    def clock_back(self):
        """All inputs, and the results that are replaced, come from the future: as after the clock went back; the program itself looks at no clock
        on the wall (a test of its sources)."""
        future = time.time() + 10 * 365 * 86400
        for file in [*self.inputs.iterdir(), *self.suite.iterdir()]:
            os.utime(file, (future, future))
        for name in self.commands:
            out = self.fresh()
            self.ended(self.commands[name], out)
            for file in out.iterdir():
                os.utime(file, (future, future))
            code, said = self.ended(self.commands[name], out)
            if code not in (0, 1):
                self.fault(f"files of the future: {name} ends with {code}: {said.strip()[-300:]}")
            self.look(name, out, f"files of the future, {name}", journal=False)
        return "inputs and results of ten years from now"

    def without_proc(self):
        """Where /proc is not there, files are written under a hidden name."""
        prefix = ["unshare", "--mount", "sh", "-c", 'mount -t tmpfs tmpfs /proc && exec "$@"', "sh"]
        if subprocess.run([*prefix, "true"], capture_output=True).returncode != 0:
            return "not tried: nothing may be mounted here"
        for name in self.commands:
            self.refused("without /proc", name, self.fresh(), prefix=prefix, codes=(0, 1))
        return "the same bytes"


    def names(self):
        """A name that is too long for one of the files, and a result that nothing can take the place of: none is there."""
        for length in (244, 246, 247, 249, 250, 251):
            case = self.inputs / ("n" * length + ".yaml")
            try:
                shutil.copy(self.inputs / "slot.yaml", case)
            except OSError:
                continue
            out = self.fresh()
            code, said = self.ended(["run", case.name, "-o", "OUT"], out)
            case.unlink()
            there = list(out.iterdir()) if out.exists() else []
            if code != (0 if length + len(".events.csv") <= 255 else 4) or (code != 0 and (there or "File name too long" not in said)):
                self.fault(f"a name of {length}: run ends with {code}, {len(there)} files are there: {said.strip()[-300:]}")
        out = self.fresh()
        self.ended(self.commands["run"], out)
        before = {file.name: file.read_bytes() for file in out.iterdir()}
        bound = out / "long.json"
        if subprocess.run(["mount", "--bind", str(bound), str(bound)], capture_output=True).returncode != 0:
            return "long names; nothing may be mounted here"
        try:
            code, said = self.ended([*self.commands["run"], "--set", "mu=0.37"], out)
        finally:
            subprocess.run(["umount", "-l", str(bound)], check=True)
        if code != 4 or before != {file.name: file.read_bytes() for file in out.iterdir()}:
            self.fault(f"a result that is mounted: run ends with {code}: {said.strip()[-300:]}")
        return "long names, and a result that is mounted"


def main():
    options = argparse.ArgumentParser()
    options.add_argument("program", type=lambda name: pathlib.Path(name).resolve())
    options.add_argument("sources", type=pathlib.Path)
    options.add_argument("--kills", type=int, default=300)
    options.add_argument("--seed", type=int, default=None)
    options.add_argument("--only", default="")
    given = options.parse_args()
    seed = given.seed if given.seed is not None else random.SystemRandom().randrange(1 << 31)
    begin = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="slipbench-torture-") as name:
        torture = Torture(given.program, given.sources, pathlib.Path(name), random.Random(seed))
        torture.learn()
        print("in peace: " + ", ".join(f"{name} {seconds:.2f} s" for name, seconds in torture.seconds.items()), flush=True)
        trials = {
            "kills": lambda: torture.kills(given.kills),
            "parts": lambda: torture.parts(max(1, given.kills // 15)),
            "signals": lambda: torture.signals(max(4, given.kills // 5)),
            "full_disk": lambda: torture.full_disk(min(20, given.kills // 8)),
            "read_only": torture.read_only,
            "limits": lambda: torture.limits(min(40, 3 + given.kills // 8)),
            "inputs_gone": torture.inputs_gone,
            "two_at_once": lambda: torture.two_at_once(max(1, given.kills // 60)),
            "clock_back": torture.clock_back,
            "without_proc": torture.without_proc,
            "names": torture.names,
        }
        chosen = [one for one in re.split("[, ]+", given.only) if one] or list(trials)
        for one in chosen:
            started = time.monotonic()
            print(f"{one}: {trials[one]()} ({time.monotonic() - started:.0f} s)", flush=True)
        print(f"{len(torture.faults)} faults in {time.monotonic() - begin:.0f} s, seed {seed}")
        return 1 if torture.faults else 0


sys.exit(main())
