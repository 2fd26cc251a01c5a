# SPDX-License-Identifier: Apache-2.0
"""Functional mock-up units of cases: their XML against a schema, and what they compute against runs of the case.

    fmu_test.py SLIPBENCH CASES MODULE_FOLDER"""
import collections
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import warnings
import xml.etree.ElementTree
import zipfile

PROGRAM, CASES, MODULE = str(pathlib.Path(sys.argv[1]).absolute()), pathlib.Path(sys.argv[2]).absolute(), sys.argv[3]
sys.path.insert(0, MODULE)
import host  # noqa: E402

import slipbench  # noqa: E402

folder = tempfile.TemporaryDirectory()
FOLDER = pathlib.Path(folder.name)
SCHEMA = pathlib.Path(__file__).parent / "modelDescription.xsd"


def export(case, name, *options):
    return subprocess.run([PROGRAM, "export", case, "--to", "fmu", "-o", FOLDER / f"{name}.fmu", "--allow-outside", *options], capture_output=True, text=True)


def unit_of(case, name, *options):
    done = export(case, name, *options)
    assert done.returncode == 0, done.stderr
    return host.Unit(FOLDER / f"{name}.fmu", FOLDER / name), done.stderr


def inputs_of(unit, run):
    """The columns of a run that stand for a unit's inputs: constraint forces f2, m3 are CTF2, CTM3 there."""
    columns = {}
    for name, variable in unit.variables.items():
        if variable.get("causality") != "input":
            continue
        column = re.sub("^([fm])([123])$", lambda found: f"CT{found[1].upper()}{found[2]}", name)
        if column in run:
            columns[name] = run[column].tolist()
    return columns


def differences(unit, run):
    """The largest difference of each output over the run, as a part of its largest size."""
    one = unit.instance()
    columns, times = inputs_of(unit, run), run["t"].tolist()
    outputs = [name for name, variable in unit.variables.items() if variable.get("causality") == "output" and name in run]
    assert outputs
    worst = dict.fromkeys(outputs, 0.0)
    for i in range(len(times)):
        if i:
            one.set(**{name: column[i] for name, column in columns.items()})
            one.step((times[i] - times[i - 1]) * seconds_of(unit))
        for name in outputs:
            worst[name] = max(worst[name], abs(one.get(name) - run[name][i]))
    one.free()
    return {name: off / max(abs(run[name]).max(), 1e-300) for name, off in worst.items()}


def seconds_of(unit):
    text = (unit.folder / "resources/law.txt").read_text()
    return 1.0 / float(re.search(r"time_unit (\S+)", text)[1])


# What the case does and its unit does not, by the words of the command: the host does it, or it is one increment after the other.
OWN = ("springs, dampers and stops", "the mass and its belt", "the equilibrium", "changes of friction", "exact integration")


class Cases(unittest.TestCase):
    def setUp(self):
        warnings.simplefilter("ignore", slipbench.SlipbenchWarning)

    def test_all_cases(self):
        """Each case is a unit that computes what the case does, or is refused with the reason."""
        count = collections.Counter()
        for case in sorted(CASES.rglob("*.yaml")):
            if "bad" in case.relative_to(CASES).parts or re.search(r"^(calibrate|sweep|experiments):", case.read_text(), re.M):
                continue
            name = f"{case.parent.name}_{case.stem}"
            done = export(case, name)
            if done.returncode:
                self.assertRegex(done.stderr, "is not exported: .*(belt|dead zone|coefficient for each direction|names a free component)", case)
                count["refused"] += 1
                continue
            unit = host.Unit(FOLDER / f"{name}.fmu", FOLDER / name)
            # Of a library each its own: where the file is replaced, its pages are.
            (FOLDER / f"{name}.fmu").unlink()
            if any(words in done.stderr for words in OWN[1:]):
                count["history of the case's own"] += 1
                continue
            worst = differences(unit, slipbench.load(case, allow_outside=True).run())
            # Of a duration that is a difference of total times only rounding is left, as a part of the time so far; a stick's stiffness
            # and a decay carry it on.
            self.assertLess(max(worst.values()), 1e-9, f"{case}: {worst}")
            count["the same bits" if max(worst.values()) == 0.0 else "rounding of the time"] += 1
        print(dict(count))
        self.assertGreater(count["the same bits"], 130)
        self.assertLess(count["rounding of the time"], 45)


class Units(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.case = CASES / "examples/hinge.yaml"
        cls.unit, cls.said = unit_of(cls.case, "hinge")
        cls.run_ = slipbench.load(cls.case).run()

    def go(self, one, first, last):
        """Steps an instance through rows of the run; returns the moments."""
        columns, times = inputs_of(self.unit, self.run_), self.run_["t"].tolist()
        moments = []
        for i in range(first, last):
            one.set(**{name: column[i] for name, column in columns.items()})
            one.step(times[i] - times[i - 1])
            moments.append([one.get(name) for name in ("CSM1", "DISS", "STATUS")])
        return moments

    def test_the_description_keeps_the_schema(self):
        for name in ("examples/hinge", "examples/puck", "examples/contact_point", "verification/temperature_table", "examples/renard"):
            case = CASES / f"{name}.yaml"
            if not case.exists():
                case = CASES / "examples/press_fit.yaml"
            unit, _ = unit_of(case, "schema_" + case.stem, "--force")
            done = subprocess.run(["xmllint", "--noout", "--schema", SCHEMA, unit.folder / "modelDescription.xml"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            names = {one.get("index") for one in unit.description.find("ModelStructure/Outputs")}
            listed = list(unit.variables.values())
            self.assertEqual(names, {str(i + 1) for i, one in enumerate(listed) if one.get("causality") == "output"})
            self.assertEqual([one.get("valueReference") for one in listed], [str(i) for i in range(len(listed))])

    def test_the_schema_can_fail(self):
        tree = xml.etree.ElementTree.parse(self.unit.folder / "modelDescription.xml")
        tree.getroot().find("ModelVariables")[0].set("valueReference", "1")
        tree.write(FOLDER / "twice.xml")
        self.assertNotEqual(subprocess.run(["xmllint", "--noout", "--schema", SCHEMA, FOLDER / "twice.xml"], capture_output=True).returncode, 0)

    def test_the_library_needs_libc_only(self):
        done = subprocess.run(["readelf", "-d", self.unit.folder / "binaries/linux64/hinge.so"], capture_output=True, text=True, check=True)
        needed = set(re.findall(r"NEEDED.*\[(.*?)\]", done.stdout))
        self.assertLessEqual(needed, {"libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"})
        self.assertEqual((self.unit.library.fmi2GetVersion(), self.unit.library.fmi2GetTypesPlatform()), (b"2.0", b"default"))

    def test_the_same_case_gives_the_same_bytes(self):
        unit_of(self.case, "again")
        with zipfile.ZipFile(FOLDER / "hinge.fmu") as one, zipfile.ZipFile(FOLDER / "again.fmu") as other:
            self.assertEqual([(a.filename, a.CRC) for a in one.infolist()], [(a.filename, a.CRC) for a in other.infolist()])

    def test_going_back_in_time(self):
        one = self.unit.instance()
        self.go(one, 1, 80)
        saved = one.state()
        written = one.to_bytes(saved)
        first = self.go(one, 80, 120)
        one.go_back(saved)
        self.assertEqual(self.go(one, 80, 120), first)
        other = self.unit.instance("two")
        restored = other.from_bytes(written, saved.time)
        other.go_back(restored)
        self.assertEqual(self.go(other, 80, 120), first)
        with self.assertRaisesRegex(RuntimeError, "no state of this unit"):
            other.from_bytes(written[:-8])
        for each, state in ((one, saved), (other, restored)):
            each.free_state(state)
            each.free()

    def test_two_instances_do_not_see_each_other(self):
        alone = self.unit.instance()
        wanted = self.go(alone, 1, 100)
        one, two = self.unit.instance("one"), self.unit.instance("two", mu=0.3)
        found = []
        for i in range(1, 100):
            found += self.go(one, i, i + 1)
            self.go(two, i, i + 1)
        self.assertEqual(found, wanted)
        self.assertEqual(two.get("MU"), 0.3)
        for each in (alone, one, two):
            each.free()

    def test_parameters_are_those_of_the_case(self):
        self.assertIn("parameter R_p: the host can set it", self.said)
        self.assertIn("dropped: parameter L_s: the friction follows it by a curve", self.said)
        case = slipbench.load(self.case).with_parameters(mu=0.21, R_p=0.1, M_int=50)
        run = case.run()
        one = self.unit.instance(mu=0.21, R_p=0.1, M_int=50)
        columns, times = inputs_of(self.unit, run), run["t"].tolist()
        for i in range(1, len(times)):
            one.set(**{name: column[i] for name, column in columns.items()})
            one.step(times[i] - times[i - 1])
            # 2 R_p/L_s is a product here and a quotient there.
            self.assertAlmostEqual(one.get("CSM1") / 30.0, run["CSM1"][i] / 30.0, places=13)
        one.free()

    def test_rates_move_it_as_positions_do(self):
        one, two = self.unit.instance(), self.unit.instance("two", by_rate=1)
        for each in (one, two):
            each.set(f1=200.0, f2=300.0)
        position = 0.0
        for i in range(64):
            rate = 0.5 if i < 40 else -0.25
            position += rate / 64
            one.set(CPR1=position)
            two.set(CVR1=rate)
            for each in (one, two):
                each.step(1 / 64)
            self.assertEqual(one.get("CSM1"), two.get("CSM1"))
            self.assertEqual(two.get("CPR1"), position)
        one.free()
        two.free()

    def test_a_step_may_be_many_increments(self):
        one, two = self.unit.instance(increments=8), self.unit.instance("two")
        one.set(f1=100.0, CPR1=0.5)
        one.step(1.0)
        for i in range(1, 9):
            two.set(f1=100.0 * i / 8, CPR1=0.5 * i / 8)
            two.step(1 / 8)
        self.assertEqual([one.get(name) for name in ("CSM1", "DISS", "CASUR1")], [two.get(name) for name in ("CSM1", "DISS", "CASUR1")])
        one.free()
        two.free()

    def test_wrong_use_is_told_and_changes_nothing(self):
        one = self.unit.instance()
        before = self.go(one, 1, 20)[-1]
        for call, message in ((lambda: one.step(0.0), "longer than 0"), (lambda: one.set(CSM1=1.0), "an output cannot be set"),
                              (lambda: (one.set(f1=float("nan")), one.step(0.1)), "not finite")):
            with self.assertRaisesRegex(RuntimeError, message):
                call()
        self.assertEqual([one.get(name) for name in ("CSM1", "DISS", "STATUS")], before)
        one.free()
        other = self.unit.instance(guid="{0}")
        self.assertFalse(other.component)
        self.assertIn("their guid differs", other.said[0])
        other = self.unit.instance(resources="file:///nowhere")
        self.assertIn("cannot read /nowhere/law.txt", other.said[0])
        with self.assertRaisesRegex(RuntimeError, "make no friction"):
            self.unit.instance(mu=-1.0)
        for cut in (10, 200, 700):
            damaged = FOLDER / "damaged"
            damaged.mkdir(exist_ok=True)
            text = (self.unit.folder / "resources/law.txt").read_text()
            (damaged / "law.txt").write_text(text[:cut])
            self.assertFalse(self.unit.instance(resources=f"file://{damaged}").component)

    def refused(self, one, message, function, *arguments):
        """A call that must be an error with that message."""
        with self.assertRaisesRegex(RuntimeError, f"^{function}: status 3: .*{message}"):
            one.call(function, *arguments)

    def test_calls_out_of_order_are_errors(self):
        one = self.unit.made()
        step = (host.REAL(0), host.REAL(0.1), 1)
        self.refused(one, "before the end of initialization", "fmi2DoStep", *step)
        self.refused(one, "not entered", "fmi2ExitInitializationMode")
        self.refused(one, "no simulation", "fmi2Terminate")
        self.refused(one, "not set up", "fmi2EnterInitializationMode")
        one.set_up()
        self.refused(one, "set up already", "fmi2SetupExperiment", 0, host.REAL(0), host.REAL(0), 0, host.REAL(0))
        one.call("fmi2EnterInitializationMode")
        self.refused(one, "entered already", "fmi2EnterInitializationMode")
        self.refused(one, "set up after", "fmi2SetupExperiment", 0, host.REAL(0), host.REAL(0), 0, host.REAL(0))
        one.call("fmi2ExitInitializationMode")
        self.refused(one, "not entered", "fmi2ExitInitializationMode")
        one.call("fmi2DoStep", *step)
        for size in (-0.1, 0.0, float("inf"), float("nan"), 1e308 * 10):
            self.refused(one, "longer than 0, and finite", "fmi2DoStep", host.REAL(0), host.REAL(size), 1)
        one.call("fmi2Terminate")
        self.refused(one, "after the end", "fmi2DoStep", *step)
        force = one.place("f1")[0]
        self.refused(one, "after the end", "fmi2SetReal", force, host.ctypes.c_size_t(1), host.ctypes.byref(host.REAL(1.0)))
        self.assertEqual((one.get("f1"), one.get("DISS")), (0.0, 0.0))
        one.call("fmi2Reset")
        one.initialize()
        one.call("fmi2DoStep", *step)
        one.free()

    def test_steps_follow_each_other_until_the_stop_time(self):
        one = self.unit.made()
        for start, stop in ((float("nan"), None), (1.0, 0.5), (0.0, float("inf"))):
            with self.assertRaisesRegex(RuntimeError, "start time" if stop != float("inf") else "stop time"):
                one.set_up(start, stop)
        one.initialize(2.0, 3.0)
        for begin in (0.0, 1.9, 2.1, float("nan")):
            self.refused(one, "where the last one ended", "fmi2DoStep", host.REAL(begin), host.REAL(0.1), 1)
        for i in range(10):  # products and sums of steps differ by rounding
            one.call("fmi2DoStep", host.REAL(2.0 + i * 0.1), host.REAL(0.1), 1)
        self.refused(one, "beyond the stop time", "fmi2DoStep", host.REAL(3.0), host.REAL(0.1), 1)
        one.call("fmi2Reset")
        one.initialize(0.0)
        one.step(1000.0)
        one.free()

    def test_outputs_are_not_there_before_initialization(self):
        one = self.unit.made()
        with self.assertRaisesRegex(RuntimeError, "before initialization"):
            one.get("FLIM")
        self.assertEqual(one.get("mu"), self.run_["MU"][0])
        one.free()

    def test_parameters_are_fixed_after_initialization(self):
        one = self.unit.instance()
        saved = one.state()
        for name, value in (("mu", 0.3), ("by_rate", 1), ("increments", 2)):
            before = one.get(name)
            with self.assertRaisesRegex(RuntimeError, "fixed"):
                one.set(**{name: value})
            self.assertEqual(one.get(name), before)
        # A state brings back its parameters, and its place in the order of calls.
        one.call("fmi2Reset")
        early = one.state()
        one.set(mu=0.3)
        one.go_back(saved)
        self.assertEqual(one.get("mu"), self.run_["MU"][0])
        one.set(f1=100.0, CPR1=0.5)
        one.step(0.1)
        self.assertEqual(one.get("MU"), self.run_["MU"][0])
        with self.assertRaisesRegex(RuntimeError, "fixed"):
            one.set(mu=0.3)
        one.go_back(early)
        one.set(mu=0.3)
        one.initialize()
        self.assertEqual(one.get("MU"), 0.3)
        one.free()

    def test_types_are_kept(self):
        one = self.unit.instance()
        real, whole, flag = (one.place(name)[0] for name in ("f1", "STATUS", "by_rate"))
        one_of = host.ctypes.c_size_t(1)
        number, integer = host.REAL(1.0), host.INTEGER(1)
        for function, reference, value in (("fmi2SetReal", whole, number), ("fmi2GetReal", whole, number), ("fmi2GetInteger", real, integer),
                                           ("fmi2SetInteger", real, integer), ("fmi2GetBoolean", whole, integer), ("fmi2GetInteger", flag, integer)):
            self.refused(one, "another type", function, reference, one_of, host.ctypes.byref(value))
        self.refused(one, "no variable", "fmi2GetReal", (host.ctypes.c_uint * 1)(99999), one_of, host.ctypes.byref(number))
        self.refused(one, "must be there", "fmi2GetReal", real, one_of, None)
        one.free()
        other = self.unit.made()
        for count in (0, -1, 100001, 2**31 - 1):
            with self.assertRaisesRegex(RuntimeError, "from 1 to 100000"):
                other.set(increments=count)
        other.set(increments=100000)
        self.assertEqual((self.unit.variables["increments"][0].get("min"), self.unit.variables["increments"][0].get("max")), ("1", "100000"))
        other.free()

    def test_states_that_are_none_change_nothing(self):
        one = self.unit.instance()
        wanted = self.go(one, 1, 20)[-1]
        saved = one.state()
        written = one.to_bytes(saved)
        size = host.ctypes.c_size_t()
        self.refused(one, "no state", "fmi2SerializedFMUstateSize", None, host.ctypes.byref(size))
        self.refused(one, "no state", "fmi2SetFMUstate", None)
        self.refused(one, "no place", "fmi2GetFMUstate", None)
        numbers = list(struct.unpack(f"{len(written) // 8}d", written))
        refused = 0
        for i in range(len(numbers)):
            for x in (float("nan"), -1e300, 0.5, 1e300):
                bad = struct.pack(f"{len(numbers)}d", *numbers[:i], x, *numbers[i + 1:])
                state = host.State()
                try:
                    state = one.from_bytes(bad)
                    one.go_back(state)
                    one.go_back(saved)
                except RuntimeError:
                    refused += 1
                if state:
                    one.free_state(state)
                self.assertEqual([one.get(name) for name in ("CSM1", "DISS", "STATUS")], wanted)
        self.assertGreater(refused, 20)
        other, _ = unit_of(CASES / "examples/puck.yaml", "other")
        two = other.instance()
        with self.assertRaisesRegex(RuntimeError, "no state of this unit|none of this unit"):
            one.go_back(one.from_bytes(two.to_bytes(two.state())))
        with self.assertRaisesRegex(RuntimeError, "none of this unit"):
            one.go_back(two.state())
        self.assertEqual(self.go(one, 20, 60), self.go(self.resumed(written, saved.time), 20, 60))
        one.free()
        two.free()

    def resumed(self, written, time):
        one = self.unit.instance("resumed")
        one.go_back(one.from_bytes(written, time))
        return one

    def test_outputs_are_there_in_initialization(self):
        one = self.unit.made()
        one.set_up()
        one.call("fmi2EnterInitializationMode")
        one.set(f1=100.0, f2=200.0)
        limit = one.get("FLIM")
        self.assertGreater(limit, 0.0)
        self.assertEqual(one.get("MU"), self.run_["MU"][0])
        one.set(mu=2.0 * one.get("mu"))
        self.assertAlmostEqual(one.get("FLIM") / limit, 2.0, places=13)
        one.set(mu=-1.0)
        with self.assertRaisesRegex(RuntimeError, "make no friction"):
            one.get("FLIM")
        one.set(mu=0.5)
        one.call("fmi2ExitInitializationMode")
        self.assertEqual(one.get("MU"), 0.5)
        one.free()

    def test_messages_come_where_they_are_wanted(self):
        one = self.unit.made(logging=0)
        number, count = host.REAL(0), host.ctypes.c_size_t(1)
        wrong = (one.place("STATUS")[0], count, host.ctypes.byref(number))

        def wrong_use():
            before = len(one.said)
            one.library.fmi2GetReal(host.ctypes.c_void_p(one.component), *wrong)
            return len(one.said) - before

        self.assertEqual(wrong_use(), 0)
        one.call("fmi2SetDebugLogging", 1, host.ctypes.c_size_t(0), None)
        self.assertEqual(wrong_use(), 1)
        categories = (host.ctypes.c_char_p * 1)(b"logStatusError")
        one.call("fmi2SetDebugLogging", 0, count, categories)
        self.assertEqual(wrong_use(), 0)
        listed = [category.get("name") for category in self.unit.description.find("LogCategories")]
        self.assertEqual(listed, ["logStatusError"])
        one.free()
        folder = FOLDER / "a_folder"
        (folder / "law.txt").mkdir(parents=True)
        self.assertFalse(self.unit.made(resources=f"file://{folder}", logging=0).component)

    def test_the_library_shows_the_functions_of_the_standard_only(self):
        done = subprocess.run(["readelf", "--dyn-syms", "--wide", self.unit.folder / "binaries/linux64/hinge.so"], capture_output=True, text=True, check=True)
        shown = [line.split()[-1] for line in done.stdout.splitlines() if re.search(r" (GLOBAL|WEAK|UNIQUE) ", line) and " UND " not in line]
        self.assertEqual([name for name in shown if not name.startswith("fmi2")], [])
        self.assertIn("fmi2DoStep", shown)

    def said_of(self, name, parameters, *, coefficient="= mu", connector="{type: SLOT}", extra="", history="history: [{step: a, increments: 1}]"):
        """What the command says of a case, by parameter; and its unit."""
        case = FOLDER / f"{name}.yaml"
        case.write_text(f"slipbench: 1\ntitle: {name}\nparameters: {parameters}\nconnector: {connector}\nfriction:\n"
                        f"  - {{predefined: {{}}, coefficient: \"{coefficient}\", stick: {{stiffness: 1000}}}}\n{extra}{history}\n")
        unit, said = unit_of(case, name)
        return {name: f"{kind}: {text}" for kind, name, text in re.findall(r"(kept|dropped): parameter (\w+): (.*)", said)}, unit

    def test_a_parameter_that_bends_is_fixed(self):
        for name, parameters, coefficient in (
                ("cubic", "{tilt: 0}", "= 0.2 + tilt^3"), ("capped", "{tilt: 0.2}", "= 0.1*max(tilt, 1)"), ("far", "{tilt: 0.2}", "= min(tilt, 1e12)"),
                ("chosen", "{tilt: 0.2}", "= tilt < 7 ? 0.1 : 0.2"), ("root", "{tilt: 0.2}", "= sqrt((tilt - 5)^2)/20"),
                ("by_another", "{tilt: 0.2, other: '= max(tilt, 1)'}", "= 0.1*other"), ("wave", "{tilt: 0}", "= 0.3 + 0.1*sin(2*pi*tilt)")):
            said, unit = self.said_of(name, parameters, coefficient=coefficient)
            self.assertRegex(said["tilt"], "^dropped: the friction follows it by a curve", name)
            self.assertNotIn("tilt", unit.variables)
        for name, parameters, coefficient in (("line", "{tilt: 0.2}", "= 0.1 + 3*tilt/7"), ("beside", "{tilt: 0.2, most: 3}", "= tilt*max(2, 1) + 0*2"),
                                              ("zero", "{tilt: 0}", "= 0.2 + tilt"), ("defined", "{tilt: 0.2, other: '= tilt/2'}", "= other")):
            said, unit = self.said_of(name, parameters, coefficient=coefficient)
            self.assertRegex(said["tilt"], "^kept", name)
            self.assertIn("tilt", unit.variables)
            self.assertNotIn("other", said)

    def test_a_parameter_that_moves_the_begin_is_fixed(self):
        said, unit = self.said_of("place", "{mu: 0.2}", connector="{type: SLOT, initial: {CP1: = 10*mu}}")
        self.assertRegex(said["mu"], "^dropped: the connector begins at another place with it")
        self.assertNotIn("mu", unit.variables)
        said, unit = self.said_of("only_place", "{begin: 0.2, idle: 1}", coefficient="= 0.3", connector="{type: SLOT, initial: {CP1: = 10*begin}}")
        self.assertRegex(said["begin"], "^dropped: the connector begins at another place with it")
        self.assertNotIn("begin", unit.variables)
        self.assertNotIn("idle", said)

    def test_parameters_claim_no_unit(self):
        for name, variable in self.unit.variables.items():
            if variable.get("causality") == "parameter":
                self.assertIsNone(variable[0].get("unit"), name)
        self.assertEqual(self.unit.variables["f1"][0].get("unit"), "N")

    def test_names_that_a_unit_has_itself_are_told_apart(self):
        for name in ("increments", "by_rate", "MU", "FN", "DISS", "f2", "temperature"):
            said, unit = self.said_of(f"name_{name}", f"{{{name}: 0.5}}", coefficient=f"= {name}")
            self.assertIn(said[name], (f"kept: the host can set it, by the name parameter_{name}", "kept: the host can set it"))
            self.assertEqual(len(unit.variables), len(unit.description.find("ModelVariables")))
            one = unit.instance(**{f"parameter_{name}" if "by the name" in said[name] else name: 0.7})
            self.assertEqual(one.get("MU"), 0.7)
            one.free()

    def test_wrong_commands_are_told(self):
        def said(*arguments):
            done = subprocess.run([PROGRAM, "export", *arguments], capture_output=True, text=True, cwd=FOLDER)
            self.assertEqual(done.returncode, 2, arguments)
            return done.stderr

        self.assertIn("-o NAME.fmu", said(self.case, "--to", "fmu"))
        self.assertIn("are for decks", said(self.case, "--to", "fmu", "-o", "a.fmu", "--digits", "4"))
        self.assertIn("belt", said(CASES / "examples/belt.yaml", "--to", "fmu", "-o", "a.fmu"))
        self.assertFalse((FOLDER / "a.fmu").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
