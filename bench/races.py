# SPDX-License-Identifier: Apache-2.0
"""The workloads W1 to W10 of bench/run: what is run, by whom, what is known of the end, and what is wanted of the
ratios. A contender's command runs in the folder that its workload has prepared."""
import dataclasses
import json
import math
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
CASES = HERE / "workloads" / "races"
PEERS = HERE / "peers"


class WrongEnd(Exception):
    """An end state that is not the one known."""


def expect(found, known, relative):
    for name, value in known.items():
        if name not in found:
            raise WrongEnd(f"tells nothing of {name}")
        if not math.isclose(found[name], value, rel_tol=relative):
            raise WrongEnd(f"{name} = {found[name]!r}, known is {value!r}")


def told(known, relative=1e-8):
    """Returns a check of the JSON in the last line that is printed, which returns the seconds told there, if any."""
    def check(folder, text):
        found = json.loads(text.strip().splitlines()[-1])
        expect(found, known, relative)
        return found.get("seconds")
    return check


def last_row(path):
    """Returns the last row of a result by the names of its header."""
    with path.open("rb") as file:
        line = file.readline()
        while line.startswith(b"#"):
            line = file.readline()
        header = line.decode().strip().split(",")
        file.seek(max(0, path.stat().st_size - 4096))
        numbers = file.read().decode().splitlines()[-1].split(",")
    return dict(zip(header, map(float, numbers)))


def written(name, known, relative=1e-8):
    """Returns a check of the last row of a result of the tool."""
    return lambda folder, text: expect(last_row(folder / "out" / name), known, relative)


def column_means(name, known, relative=1e-8):
    """Returns a check of the means of a table's columns."""
    def check(folder, text):
        with (folder / "out" / name).open() as file:
            lines = [line.rstrip("\n").split(",") for line in file if not line.startswith("#")]
        columns = dict(zip(lines[0], zip(*lines[1:])))
        expect({name: math.fsum(map(float, columns[name])) / (len(lines) - 1) for name in known if name in columns},
               known, relative)
    return check


@dataclasses.dataclass
class Contender:
    """Who runs a workload. `goal`: at least so many times the tool's time; `at_most`: the tool's time as a multiple
    of this one's; `reported`: the time is what the program says, not that of its process."""
    name: str
    command: list
    check: object
    goal: float = None
    at_most: float = None
    reported: bool = False
    cold: bool = False  # a peer that compiles: every run the first one


@dataclasses.dataclass
class Race:
    """A workload: its first contender is the tool, which all others are measured by."""
    title: str
    contenders: list
    missing: list = dataclasses.field(default_factory=list)
    memory_goal: float = None  # MiB, of the tool
    rounds: int = None  # where fewer are enough
    note: str = ""


def numbers(values):
    return "[" + ", ".join(map(repr, values)) + "]"


class Races:
    """The workloads, prepared in a folder of their own each. `tools` says what is installed, `small` makes them short."""

    def __init__(self, tools, small):
        self.tools = tools
        self.small = small
        self.slipbench = tools["slipbench"]

    LIST = {"W1": "10 increments, the whole process", "W2": "SLOT, 10^6 increments, next to no output",
            "W3": "SLOT, 10^6 increments, 5 columns of text", "W4": "SLIDE-PLANE with tables, 10^6 rows of CSV in, 12 columns out",
            "W4k": "the update alone, SLIDE-PLANE with two tables", "W5": "4096 parameter sets x 2000 increments",
            "W6": "calibration with 4 unknowns on 10^4 rows", "W6b": "calibration with 20 unknowns on 10^4 rows",
            "W7": "10^5 rows x 12 columns held against a reference",
            "W8": "farm of 10^4 samples, the longest 100 times the shortest", "W9": "a case with 10^5 rows inline", "W10": "memory at 10^5, 10^6 and 10^7 rows"}

    def race(self, key, folder):
        return {"W1": self.whole_process, "W2": self.slot, "W3": self.slot_text, "W4": self.plane,
                "W4k": self.update, "W5": self.sweep, "W6": lambda f: self.fit(f, 4), "W6b": lambda f: self.fit(f, 20),
                "W7": self.compare, "W8": self.farm, "W9": self.inline, "W10": self.memory}[key](folder)

    def python(self, script, *arguments):
        return [self.tools["python"], PEERS / script, *map(str, arguments)]

    def with_peers(self, race, wanted):
        """Adds those that are there, and notes those that are not."""
        for tool, contender in wanted:
            if self.tools.get(tool):
                race.contenders.append(contender())
            elif tool not in race.missing:
                race.missing.append(tool)
        return race

    def mtest(self, folder, steps, known, goal):
        """MTest's part is the user's: a command of his that runs SLOT with {steps} increments."""
        command = [word.format(steps=steps) for word in (self.tools.get("mtest") or "").split()]
        return "mtest", lambda: Contender("MTest (the command given)", command, told(known, 1e-6), goal)

    def numba(self, command, check, goal=None, reported=False):
        return [("numba", lambda: Contender("NumPy + numba, first use", command, check, goal, reported=reported, cold=True)),
                ("numba", lambda: Contender("NumPy + numba, compiled before", command, check, reported=reported))]

    def slot_case(self, folder, steps, *options, name="slot.yaml"):
        (folder / name).write_text((CASES / "slot.yaml").read_text())
        return [self.slipbench, "run", name, "-q", "-o", "out", "--set", f"increments={steps}", *options]

    SLOT_END = {"f": 12.0, "s": 399.5188}

    def whole_process(self, folder):
        end = 4 * math.sin(0.4 * math.pi) - 0.006  # four ways to and fro less five elastic slips
        known = {"f": 12.0, "s": end}
        race = Race(self.LIST["W1"], [Contender(
            "slipbench run", self.slot_case(folder, 10, "--set", "duration=1"),
            written("slot.csv", {"CSF1": 12.0, "CASU1": end}))])
        race.contenders.append(Contender("floor", [self.tools["floor"], "slot", "10", "floor.csv"], told(known)))
        script = self.python("slot.py", "python", 10, "python.csv")
        return self.with_peers(race, [
            ("numpy", lambda: Contender("NumPy", script, told(known), goal=15)),
            *self.numba(self.python("slot.py", "numba", 10), told(known)),
            ("octave", lambda: Contender("Octave", [self.tools["octave"], "-qf", PEERS / "slot.m", "10"], told(known))),
            ("ccx", lambda: self.calculix(folder)),
            self.mtest(folder, 10, known, 1)])

    def calculix(self, folder):
        """A problem of another kind, but ten increments with friction, whose forces end at mu."""
        (folder / "block.inp").write_text((PEERS / "block.inp").read_text())

        def check(folder, text):
            lines = (folder / "block.dat").read_text().split("\n")
            forces = [line.split() for line in lines if re.fullmatch(r"\s*[-+.\dE]+(\s+[-+.\dE]+){2}\s*", line)]
            drag, _, press = map(float, forces[-1])
            expect({"drag over press": abs(drag / press)}, {"drag over press": 0.2}, 1e-3)

        return Contender("CalculiX (a block dragged)", [self.tools["ccx"], "-i", "block"], check)

    def slot(self, folder):
        steps = 10_000 if self.small else 1_000_000
        race = Race(self.LIST["W2"], [Contender(
            "slipbench run", self.slot_case(folder, steps, "--every", str(steps)),
            written("slot.csv", {"CSF1": 12.0, "CASU1": 399.5188}))],
            note="the tool writes the first row and the last, which are checked, its events and its summary")
        check = told(self.SLOT_END)
        race.contenders.append(Contender("floor", [self.tools["floor"], "slot", str(steps)], check))
        return self.with_peers(race, [
            ("numpy", lambda: Contender("Python loop", self.python("slot.py", "python", steps), check, goal=10)),
            *self.numba(self.python("slot.py", "numba", steps), check, goal=8),
            ("octave", lambda: Contender("Octave", [self.tools["octave"], "-qf", PEERS / "slot.m", str(steps)], check)),
            self.mtest(folder, steps, self.SLOT_END, 50)])

    def slot_text(self, folder):
        steps = 10_000 if self.small else 1_000_000
        race = Race(self.LIST["W3"], [Contender(
            "slipbench run", self.slot_case(folder, steps), written("slot.csv", {"CSF1": 12.0, "CASU1": 399.5188}))])
        check = told(self.SLOT_END)
        race.contenders.append(Contender("floor", [self.tools["floor"], "slot", str(steps), "floor.csv"], check, at_most=1.5))
        return self.with_peers(race, [
            ("numpy", lambda: Contender("Python loop + savetxt", self.python("slot.py", "python", steps, "python.csv"),
                                        check, goal=6)),
            *self.numba(self.python("slot.py", "numba", steps, "numba.csv"), check),
            self.mtest(folder, steps, self.SLOT_END, 15)])

    # Ends of SLIDE-PLANE over 100 s, by the number of increments: all programs agree in these digits.
    PLANE_END = {1_000: {"f2": 83.7703908729, "f3": 57.6938316037, "s": 480.341076908},
                 10_000: {"f2": 83.8556030483, "f3": 56.3326115124, "s": 502.522888105},
                 100_000: {"f2": 84.1177303524, "f3": 55.9984338346, "s": 504.118416295},
                 1_000_000: {"f2": 84.1458587217, "f3": 55.9635928160, "s": 504.285350302}}

    def plane_end(self, steps):
        known = self.PLANE_END[steps]
        return known, {"CSF2": known["f2"], "CSF3": known["f3"], "CASUC": known["s"]}

    @staticmethod
    def drive(t):
        turn = 2 * math.pi
        return (t, math.sin(turn * t), 0.5 * math.sin(turn * 1.37 * t + 0.3), 500 + 200 * math.sin(turn * 0.31 * t),
                60 + 40 * math.sin(turn * 0.05 * t))

    @staticmethod
    def plane_case(history):
        """The case plane.yaml with another history."""
        text = (CASES / "plane.yaml").read_text()
        return text[:text.index("history:\n")] + "history:" + history

    def write_measured(self, folder, steps):
        with (folder / "history.csv").open("w") as file:
            file.write("t,u2,u3,f1,T\n")
            for i in range(steps + 1):
                file.write(",".join(map(repr, self.drive(100.0 * i / steps))) + "\n")
        (folder / "measured.yaml").write_text(self.plane_case(
            " {csv: history.csv, time: t, columns: {CP2: u2, CP3: u3, f1: f1, temperature: T}}\n"))

    def plane(self, folder):
        steps = 10_000 if self.small else 1_000_000
        known, columns = self.plane_end(steps)
        self.write_measured(folder, steps)
        race = Race(self.LIST["W4"], [
            Contender("slipbench run", [self.slipbench, "run", "measured.yaml", "-q", "-o", "out"],
                      written("measured.csv", columns)),
            Contender("floor", [self.tools["floor"], "plane", "history.csv", "floor.csv"], told(known), at_most=1.5)])
        return self.with_peers(race, [
            ("numpy", lambda: Contender("Python loop", self.python("plane.py", "python", "history.csv", "python.csv"),
                                        told(known), goal=12)),
            *self.numba(self.python("plane.py", "numba", "history.csv", "numba.csv"), told(known), goal=7)])

    def update(self, folder):
        known, _ = self.plane_end(100_000)
        race = Race(self.LIST["W4k"], [], note="timed within the processes, on a history in memory")
        row = "SLIDE-PLANE, two tables, rows of a run"

        def rows(folder, text):
            found = json.loads(text[text.index("{"):])["benchmarks"][0]
            if found.get("error_occurred"):
                raise WrongEnd(found["error_message"])
            return found["increment"] * 100_000

        if not self.tools.get("law bench"):
            race.missing.append("law bench")
            return race
        race.contenders = [
            Contender("slipbench's update", [self.tools["law bench"], f"--benchmark_filter=^{row}", "--benchmark_format=json",
                                             "--benchmark_min_time=0.05"], rows, reported=True),
            Contender("floor", [self.tools["floor"], "update", "100000"], told(known), reported=True)]
        return self.with_peers(race, [
            ("numpy", lambda: Contender("Python loop", self.python("plane.py", "python", 100_000), told(known), reported=True)),
            *self.numba(self.python("plane.py", "numba", 100_000), told(known), reported=True)[1:]])

    def sweep(self, folder):
        levels, steps = (4, 200) if self.small else (16, 2000)
        known = {4: {"f2": 129.977750961058, "s": 0.970516956793726}, 16: {"f2": 81.5203999276834, "s": 9.97866678528288}}[levels]

        def spread(low, high):
            return [low + (high - low) * k / (levels - 1) for k in range(levels)]

        (folder / "plane.yaml").write_text((CASES / "plane.yaml").read_text())
        (folder / "sweep.yaml").write_text(
            (CASES / "sweep.yaml").read_text().replace("STIFFNESSES", numbers(2000 * k for k in spread(0.9, 1.1)))
            .replace("FACTORS", numbers(spread(0.8, 1.2))).replace("GRIPS", numbers(spread(0.9, 1.1))))
        tool = [self.slipbench, "sweep", "sweep.yaml", "-o", "out", "--set", f"increments={steps}", "--set",
                f"duration={steps / 1000!r}", "-j"]
        check = column_means("sweep.csv", known)
        race = Race(self.LIST["W5"], [Contender("slipbench sweep -j 1", [*tool, "1"], check),
                                      Contender("slipbench sweep -j 2", [*tool, "2"], check),
                                      Contender("floor", [self.tools["floor"], "sweep", str(levels), str(steps)], told(known))],
                    note="the goal with two threads is 9 times NumPy")
        return self.with_peers(race, [("numpy", lambda: Contender("NumPy, vectorised over the cases",
                                                                  self.python("sweep.py", levels, steps), told(known), goal=5))])

    def fit(self, folder, unknowns):
        rows = 500 if self.small else 10_000
        race = Race(self.LIST["W6" if unknowns == 4 else "W6b"], [])
        if not self.tools.get("numpy"):
            race.missing.append("numpy")
            return race
        self.tools["run"](self.python("calibrate.py", "write", rows), folder)
        squares = {}  # of the first that ends; all others must find the same

        def check_squares(value):
            expect({"sum of squares": value}, {"sum of squares": squares.setdefault("first", value)}, 1e-6)

        tool = [self.slipbench, "calibrate", f"fit{unknowns}.yaml"]

        def tool_check(folder, text):
            # The peers write no page and draw nothing: that is done once more, and not timed.
            self.tools["run"]([*tool, "-o", "out", "--force"], folder)
            check_squares(2 * json.loads((folder / "out" / f"fit{unknowns}.json").read_text())["result"]["cost"])

        race.contenders = [Contender("slipbench calibrate", [*tool, "--no-output"], tool_check)]

        def peer_check(folder, text):
            check_squares(json.loads(text.strip().splitlines()[-1])["squares"])

        peer = [self.python("calibrate.py", kind, unknowns) for kind in ("python", "numba")]
        goal = 30 if unknowns == 4 else 20
        return self.with_peers(race, [
            ("scipy", lambda: Contender("SciPy, Python loop", peer[0], peer_check)),
            *[(f"{tool} + scipy", lambda of=make: dataclasses.replace(of(), name=of().name.replace("NumPy", "SciPy")))
              for tool, make in self.numba(peer[1], peer_check, goal)]])

    def compare(self, folder):
        steps = 1_000 if self.small else 100_000
        case = (CASES / "plane.yaml").read_text()
        (folder / "plane.yaml").write_text(case)
        settings = ["--set", f"increments={steps}", "--set", "duration=100"]
        self.tools["run"]([self.slipbench, "run", "plane.yaml", "-q", "-o", "out", *settings], folder)
        text = (folder / "out" / "plane.csv").read_text()
        names = next(line for line in text.splitlines() if not line.startswith("#")).split(",")
        (folder / "reference.csv").write_text(text)
        lines = text.splitlines()
        cells = lines[-2].split(",")
        cells[5] = repr(float(cells[5]) * 1.001)
        (folder / "other.csv").write_text("\n".join([*lines[:-2], ",".join(cells), lines[-1]]) + "\n")
        for name, reference in (("same", "reference.csv"), ("differs", "other.csv")):
            checks = "".join(f"  - {{name: {column}, quantity: {column}, against: {{curve: {reference}, column: {column}}}, "
                             "tolerance: {absolute: 1.0e-9, why: the same}}\n" for column in names[1:])
            (folder / f"{name}.yaml").write_text(case + "checks:\n" + checks)

        def sees(command, first, second):
            """Returns a contender's check: it must find the difference, too, which is not timed."""
            def check(folder, text):
                other = [second if word == first else word for word in command]
                if self.tools["run"](other, folder, codes=(0, 1)) == 0:
                    raise WrongEnd("a difference of 0.1 % in one number is not seen")
            return check

        def contender(name, command, first, second, **goals):
            return Contender(name, command, sees(command, first, second), **goals)

        tool = [self.slipbench, "check", "same.yaml", "-q", *settings]
        files = ["out/plane.csv", "reference.csv"]
        race = Race(self.LIST["W7"], [contender("slipbench check", tool, "same.yaml", "differs.yaml"),
                                      contender("floor", [self.tools["floor"], "compare", *files], "reference.csv", "other.csv")],
                    note="the tool runs the case as well; the others have two files to read")
        numdiff = [self.tools.get("numdiff"), "-q", "-s", ", \\t\\n", "-a", "1e-9", *files]
        return self.with_peers(race, [
            ("numpy", lambda: contender("NumPy", self.python("compare.py", *files), "reference.csv", "other.csv", goal=8)),
            ("numdiff", lambda: contender("numdiff", numdiff, "reference.csv", "other.csv", goal=25))])

    def farm(self, folder):
        levels, shortest = (10, 20) if self.small else (100, 300)
        lengths = [shortest + round(99 * shortest * k / (levels - 1)) for k in range(levels)]
        (folder / "slot.yaml").write_text((CASES / "slot.yaml").read_text())
        (folder / "farm.yaml").write_text((CASES / "farm.yaml").read_text().replace("LENGTHS", numbers(lengths)).replace(
            "DURATIONS", numbers(1 + k / levels for k in range(levels))))
        race = Race(self.LIST["W8"], [], rounds=3, note="the efficiency of two ranks is half of the ratio of one rank to them: 1.84 is "
                    "92 %; starting mpirun and joining the journals are in it")
        if not self.tools.get("farm"):
            race.missing.append("farm")
            return race
        self.tools["run"]([self.slipbench, "sweep", "farm.yaml", "-o", "known"], folder)
        known = (folder / "known" / "farm.csv").read_bytes()

        def same_bytes(folder, text):
            if (folder / "out" / "farm.csv").read_bytes() != known:
                raise WrongEnd("not the bytes of slipbench sweep")
            (folder / "out" / "farm.csv").unlink()

        def ranks(count):
            return [*self.tools["mpirun"], "-n", str(count), self.tools["farm"], "sweep", "farm.yaml", "-o", "out"]

        tool = f"'{self.slipbench}'"
        halves = " & ".join(f"{tool} sweep farm.yaml -o out -j 1 --part {i}/2" for i in (1, 2))
        race.contenders = [
            Contender("slipbench-mpi, 2 ranks", ranks(2), same_bytes),
            Contender("slipbench-mpi, 1 rank", ranks(1), same_bytes, goal=1.84),
            Contender("two halves, slipbench sweep --part", ["sh", "-c", f"{halves} & wait; {tool} merge farm.yaml -o out && "
                                                             "rm out/*of2.csv"], same_bytes),
            Contender("slipbench sweep -j 2", [self.slipbench, "sweep", "farm.yaml", "-o", "out", "-j", "2"], same_bytes)]
        return race

    def inline(self, folder):
        steps = 1_000 if self.small else 100_000
        _, columns = self.plane_end(steps)
        self.write_measured(folder, steps)
        drives = [self.drive(100.0 * i / steps) for i in range(steps + 1)]

        def table(k, indent):
            space = " " * indent
            return f"\n{space}columns: [value, t]\n{space}rows:\n" + "".join(
                f"{space}  - [{row[k]!r}, {row[0]!r}]\n" for row in drives)

        (folder / "inline.yaml").write_text(self.plane_case(
            "\n  - step: path\n    duration: 100\n    increments: = increments\n    motion:\n      CP2:" + table(1, 8) + "      CP3:"
            + table(2, 8) + "    force:\n      f1:" + table(3, 8) + "    temperature:" + table(4, 6)))
        sums = {"rows": 4 * (steps + 1), "sum": math.fsum(row[k] + row[0] for row in drives for k in range(1, 5))}
        race = Race(self.LIST["W9"], [
            Contender("slipbench run, inline", [self.slipbench, "run", "inline.yaml", "-q", "-o", "out", "--set",
                                                f"increments={steps}"], written("inline.csv", columns, 1e-6)),
            Contender("slipbench run, CSV beside the case", [self.slipbench, "run", "measured.yaml", "-q", "-o", "out"],
                      written("measured.csv", columns))],
            memory_goal=40, note="yaml-cpp only reads the file; the tool also runs it and writes 12 columns")
        return self.with_peers(race, [("yaml nodes", lambda: Contender(
            "yaml-cpp, tree of nodes", [self.tools["yaml nodes"], "inline.yaml"], told(sums), goal=3))])

    def memory(self, folder):
        many = (4_000, 40_000) if self.small else (100_000, 1_000_000, 10_000_000)
        race = Race(self.LIST["W10"], [], memory_goal=64, rounds=1,
                    note="times grow with the rows; the memory must not: at most 64 MiB, and 2 MiB from the first to the last")
        for steps in many:
            race.contenders.append(Contender(
                f"slipbench run, {steps} rows", self.slot_case(folder, steps),
                written("slot.csv", {"CSF1": 12.0, "CASU1": 399.5188}, 1e-6)))
        return race
