# SPDX-License-Identifier: Apache-2.0
"""The Python module: cases and their runs, held against the program's own results.

usage: case_test.py SLIPBENCH CASES_FOLDER [unittest words]   (PYTHONPATH has the module)
"""
import copy
import gc
import math
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings

import numpy

import slipbench

SLIPBENCH, CASES = pathlib.Path(sys.argv.pop(1)), pathlib.Path(sys.argv.pop(1))
SLOT = {
    "slipbench": 1,
    "title": "slot",
    "units": {"length": "mm", "force": "N", "time": "s"},
    "parameters": {"mu": 0.2},
    "connector": {"type": "SLOT"},
    "friction": [{"predefined": {}, "coefficient": "= mu", "stick": {"stiffness": 1000}}],
    "history": [{"step": "a", "increments": 100, "motion": {"CP1": {"sine": {"amplitude": 3, "period": 0.5}}}, "force": {"f2": 100}}],
    "checks": [{"name": "limit", "quantity": "FLIM", "against": {"expression": "= 100*mu"}, "tolerance": {"relative": 1e-12, "why": "rounding"}}],
}


folder = tempfile.TemporaryDirectory()


def slot(**changes):
    return slipbench.load({**SLOT, **changes})


# Geometry of predefined friction, the components that move, and the forces that press.
JOINTS = {
    "SLOT": ("", "CP1", "f2 f3"),
    "SLIDE-PLANE": ("", "CP2 CP3", "f1"),
    "CYLINDRICAL": ("R L", "CP1 CPR1", "f2 f3 m2 m3"),
    "TRANSLATOR": ("R_r L", "CP1", "f2 f3 m1 m2 m3"),
    "HINGE": ("R_p R_a L_s", "CPR1", "f1 f2 f3 m2 m3"),
    "PLANAR": ("R", "CP2 CP3 CPR1", "f1 m2 m3"),
    "UJOINT": ("R_p R_a L_s L_a", "CPR1 CPR3", "f1 f2 f3 m2"),
    "CONTACT": ("", "CP2 CP3", "f1"),
    "CARTESIAN": (None, "CP1 CP2 CP3", ""),
}


def any_table(dice, of, low, high, independents):
    """Draws a table over one or two independents: the first varies fastest."""
    names = list(dice.permutation(independents)[: dice.integers(1, 3)])
    grids = [numpy.sort(dice.uniform(0, 2, dice.integers(2, 5))) for _ in names]
    points = [[]]
    for grid in grids:
        points = [[*point, x] for x in grid for point in points]
    return {"columns": [of, *names], "rows": [[dice.uniform(low, high), *point] for point in points]}


def any_coefficient(dice):
    high, low = dice.uniform(0.2, 0.5), dice.uniform(0.05, 0.2)
    return [
        lambda: high,
        lambda: any_table(dice, "mu", 0.05, 0.5, ["slip_rate", "contact_force", "temperature", "field1"]),
        lambda: {"exponential_decay": {"static": high, "kinetic": low, "decay": dice.uniform(0, 2)}},
        lambda: {"stribeck": {"static": high, "kinetic": low, "stribeck_rate": dice.uniform(0.1, 2), "viscous": dice.uniform(0, 0.1)}},
    ][dice.integers(4)]()


def any_case(dice):
    """Draws a case of any joint, friction and history that a Law takes."""
    joint = list(JOINTS)[dice.integers(len(JOINTS))]
    geometry, moving, pressing = JOINTS[joint]
    friction = {"coefficient": any_coefficient(dice)}
    if geometry is not None:
        friction["predefined"] = {name: dice.uniform(0.2, 2) for name in geometry.split()}
    else:
        friction["internal_contact_force"] = any_table(dice, "force", 50, 100, ["temperature", "field1", "CP1", "CU2"])
        if dice.random() < 0.5:
            friction["component"] = dice.integers(1, 4)
        else:
            terms = [{"component": k, "scale": dice.uniform(0.5, 2)} for k in (1, 2, 3)]
            friction["potential"] = {"operator": ["sum", "max"][dice.integers(2)], "terms": terms}
    if joint == "CONTACT":
        stiff = {"penalty": "stiffness", "K_t": dice.uniform(10, 1000)}
        friction["formulation"] = [stiff, {"penalty": "viscous", "C": dice.uniform(1, 100)}][dice.integers(2)]
        if dice.random() < 0.5:
            friction["filter"] = [{"simple": dice.uniform(0.1, 1)}, {"frequency": dice.uniform(0.1, 2)}][dice.integers(2)]
    elif dice.random() < 0.9:
        friction["stick"] = [{"stiffness": 10 ** dice.uniform(1, 4)}, {"elastic_slip": 10 ** dice.uniform(-3, 0)}][dice.integers(2)]

    duration = dice.uniform(0.5, 5)

    def profile(low, high):
        times = [0, *numpy.sort(dice.uniform(0, duration, 3)), duration]
        return {"columns": ["value", "t"], "rows": [[dice.uniform(low, high), time] for time in times]}

    # One step: the time in it, of which increments are made, is that of the rows.
    step = {
        "step": "all",
        "duration": duration,
        "increments": 5,
        "motion": {one: profile(-1, 1) for one in moving.split()},
        "force": {one: profile(-200, 200) for one in pressing.split()},
        "temperature": profile(0, 2),
        "fields": {"field1": profile(0, 2)},
    }
    return {"slipbench": 1, "title": "any", "connector": {"type": joint}, "friction": [friction], "history": [step]}


class Runs(unittest.TestCase):
    def assert_rows_are(self, file, run):
        lines = [line for line in file.read_text().splitlines() if not line.startswith("#")]
        header = lines[0].split(",")
        self.assertEqual(list(run), header, file)
        wanted = numpy.array([[float(text) for text in line.split(",")] for line in lines[1:]])
        found = numpy.column_stack([run[column] for column in header])
        self.assertEqual(wanted.shape, found.shape, file)
        self.assertTrue(numpy.array_equal(wanted, found, equal_nan=True), file)

    def test_any_law_gives_the_numbers_of_its_run_and_these_those_of_the_program_bit_for_bit(self):
        rows = slipping = 0
        runs = {}
        for seed in range(200):
            case = any_case(numpy.random.default_rng(20261126 + seed))
            with self.subTest(seed=seed), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                loaded = slipbench.load(case)
                run = loaded.run()
                slipping += self.assert_law_gives(case, run)
                rows += len(run["t"]) - 1
                # The program takes as long as all else.
                if seed % 4 == 0:
                    runs[seed] = loaded.text, run
        # What has to be equal says something: friction that sticks and slips.
        self.assertGreater(rows, 3000)
        self.assertTrue(rows / 4 < slipping < rows * 9 / 10, f"{slipping} of {rows} rows slip")
        with tempfile.TemporaryDirectory() as name:
            files = {seed: pathlib.Path(name) / f"any{seed}.yaml" for seed in runs}
            for seed, (text, _) in runs.items():
                files[seed].write_text(text)
            done = subprocess.run([SLIPBENCH, "run", *files.values(), "-o", name, "-q"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            for seed, (_, run) in runs.items():
                with self.subTest(seed=seed):
                    self.assert_rows_are(files[seed].with_suffix(".csv"), run)

    def assert_law_gives(self, case, run):
        """Compares the law, increment by increment from its own state, with all rows of a run; returns how many slip."""
        law = slipbench.Law({key: case[key] for key in ("connector", "friction")})
        zero = numpy.zeros(len(run["t"]))

        def six(along, around):
            return numpy.column_stack([run[name + k] if name + k in run else zero for name in (along, around) for k in "123"])

        positions, forces = six("CP", "CPR"), six("CRF", "CRM")
        suffixes = [f".{one}" for one in law.names] if len(law.names) > 1 else [""]
        slips = [column for column in run if column.startswith("CASU")]
        wanted = {"force": six("CSF", "CSM"), "slip": numpy.column_stack([run[column] for column in slips])}
        for of_law, column in (("limit", "FLIM"), ("normal_force", "FN"), ("mu", "MU"), ("regime", "STATUS")):
            wanted[of_law] = numpy.column_stack([run[column + suffix] for suffix in suffixes])
        state, found = law.initial_state(), {name: values.copy() for name, values in wanted.items()}
        for row in range(1, len(zero)):
            step = law.update(state, numpy.zeros(6), forces[row], positions[row - 1], run["t"][row] - run["t"][row - 1],
                              *(run[name][row] for name in ("temperature", "field1") if name in run), end=positions[row])
            state = step.state
            for name, values in found.items():
                values[row] = state[12::15] if name == "slip" else getattr(step, name)
        for name, values in found.items():
            numpy.testing.assert_array_equal(values, wanted[name], name)
        return numpy.count_nonzero(numpy.any(found["regime"] == slipbench.SLIP, axis=1))

    def test_every_case_gives_the_numbers_of_the_program_bit_for_bit(self):
        compared = 0
        with tempfile.TemporaryDirectory() as name:
            for path in sorted(CASES.glob("*/*.yaml")):
                text = path.read_text()
                if path.parent.name == "bad" or "\ncalibrate:" in text or "\nsweep:" in text:
                    continue
                done = subprocess.run([SLIPBENCH, "run", path, "-o", name, "-q", "--force"], capture_output=True, text=True)
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    case = slipbench.load(path)
                if done.returncode not in (0, 1):
                    self.assertRaises(slipbench.RunError, case.run)
                    continue
                every = 1
                for line in text.splitlines():
                    if line.strip().startswith("every:"):
                        every = int(line.split(":")[1].split("#")[0])
                run = case.run(every=every)
                self.assert_rows_are(pathlib.Path(name) / f"{path.stem}.csv", run)
                self.assertEqual(run.passed, done.returncode == 0, path)
                compared += 1
        self.assertGreater(compared, 240)

    def test_a_column_keeps_its_run_alive_and_is_not_written_to(self):
        column = slot().run()["CSF1"]
        copy = column.copy()
        gc.collect()
        numpy.testing.assert_array_equal(column, copy)
        self.assertFalse(column.flags.owndata)
        with self.assertRaises(ValueError):
            column[0] = 1.0

    def test_units_events_summary_and_checks_are_those_of_the_run(self):
        run = slot().run()
        self.assertEqual(run.units["CSF1"], "N")
        self.assertEqual([event.goal for event in run.events[:3]], ["slip", "stick", "slip"])
        self.assertAlmostEqual(run.events[0].limit, 20.0)
        self.assertIn("CP1", run.events[0].positions)
        self.assertTrue(run.passed)
        self.assertEqual(run.checks[0].name, "limit")
        self.assertEqual(len(run["t"]), 101)
        self.assertEqual(run.summary["increments"], 100)

    def test_an_unknown_column_is_answered_by_the_nearest(self):
        with self.assertRaisesRegex(KeyError, "did you mean CSF1"):
            slot().run()["CSF11"]

    def test_every_keeps_the_last_row(self):
        run = slot().run(every=30)
        self.assertEqual(list(run["t"]), [0.0, 0.3, 0.6, 0.9, 1.0])
        with self.assertRaisesRegex(ValueError, "at least 1"):
            slot().run(every=0)
        for every in (1.5, math.nan, "2"):
            with self.assertRaisesRegex(TypeError, f"^every: wanted a whole number of at least 1, found {every!r}$"):
                slot().run(every=every)
        self.assertEqual(len(slot().run(every=numpy.int64(30))["t"]), 5)
        self.assertEqual(list(slot().run(every=10**12)["t"]), [0.0, 1.0])

    def test_columns_may_be_chosen(self):
        run, all_of_it = slot().run(columns=["CSF1", "FLIM"]), slot().run()
        self.assertEqual(list(run), ["t", "CSF1", "FLIM"])
        numpy.testing.assert_array_equal(run["CSF1"], all_of_it["CSF1"])
        self.assertTrue(run.passed)
        with self.assertRaisesRegex(KeyError, "did you mean CSF1"):
            slot().run(columns=["CSF11"])
        with self.assertRaisesRegex(TypeError, "list of names"):
            slot().run(columns="CSF1")
        with self.assertRaisesRegex(TypeError, "^columns: wanted a list of names, found 1 in it$"):
            slot().run(columns=[1])
        with self.assertRaisesRegex(TypeError, "^columns: wanted a list of names, found 1$"):
            slot().run(columns=1)
        with self.assertRaisesRegex(ValueError, "^columns: 'CSF1' is there twice$"):
            slot().run(columns=["CSF1", "FLIM", "CSF1"])
        self.assertEqual(list(slot().run(columns=iter(["CSF1"]))), ["t", "CSF1"])


class Parameters(unittest.TestCase):
    def test_a_value_that_the_case_lacks_is_given_with_it(self):
        lacking = {**SLOT, "parameters": {"zeta": 1, "mu": None, "N": 100}}
        with self.assertRaisesRegex(slipbench.CaseError, "mu"):
            slipbench.load(lacking)
        case = slipbench.load(lacking, mu=0.3)
        self.assertEqual(dict(case.parameters), {"zeta": 1.0, "mu": 0.3, "N": 100.0})
        self.assertEqual(list(case.parameters), ["zeta", "mu", "N"])

    def test_a_value_is_read_at_once_and_a_faulty_one_changes_nothing(self):
        case = slot()
        case.parameters["mu"] = 0.3
        self.assertEqual(case.run()["FLIM"][-1], 30.0)
        case.parameters["mu"] = "= 0.1 + 0.05"
        self.assertAlmostEqual(case.parameters["mu"], 0.15)
        with self.assertRaisesRegex(slipbench.CaseError, "nu"):
            case.parameters["nu"] = 1.0
        with self.assertRaises(slipbench.CaseError):
            case.parameters["mu"] = -1.0
        self.assertAlmostEqual(case.parameters["mu"], 0.15)
        self.assertAlmostEqual(case.run()["FLIM"][-1], 15.0)

    def test_copies_have_values_of_their_own(self):
        case = slot()
        other = case.with_parameters(mu=0.5)
        self.assertEqual(case.parameters["mu"], 0.2)
        self.assertEqual(other.parameters["mu"], 0.5)


class Faults(unittest.TestCase):
    def test_an_error_has_its_place_and_what_to_do(self):
        with self.assertRaises(slipbench.CaseError) as caught:
            slipbench.load("slipbench: 1\ntitle: x\nconector: {type: SLOT}\n")
        error = caught.exception
        self.assertEqual(error.file, "<text>")
        self.assertIn("conector", str(error))
        spelled = [one for one in error.messages if one.path == "conector"]
        self.assertEqual((spelled[0].line, spelled[0].column), (3, 1))
        self.assertIn("connector", spelled[0].hint)

    def test_a_missing_file_is_told(self):
        with self.assertRaisesRegex(slipbench.CaseError, "nowhere.yaml"):
            slipbench.load("nowhere.yaml")

    def test_warnings_are_warnings(self):
        path = CASES / "verification" / "friction_radius.yaml"
        text = path.read_text().replace(", friction_radius: = R_f", "")
        with self.assertWarns(slipbench.SlipbenchWarning) as told:
            slipbench.load(text)
        self.assertEqual(told.filename, __file__)
        # Wherever in the package it comes from, it points to the line that called the package.
        file = pathlib.Path(folder.name) / "doubtful.yaml"
        file.write_text(text)
        with self.assertWarns(slipbench.SlipbenchWarning) as told:
            slipbench.check(file)
        self.assertEqual(told.filename, __file__)
        with self.assertWarns(slipbench.SlipbenchWarning) as told:
            slipbench.load(file).parameters.update(R_f=0.5)
        self.assertEqual(told.filename, __file__)

    def test_ctrl_c_ends_a_run(self):
        case = slot(history=[{**SLOT["history"][0], "increments": 200_000_000}])
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            case.run(every=1_000_000)
        self.assertLess(time.monotonic() - begin, 5.0)

    def test_threads_run_side_by_side(self):
        runs = [None] * 4
        case = slot()

        def work(index):
            runs[index] = case.with_parameters(mu=0.1 * (index + 1)).run()

        threads = [threading.Thread(target=work, args=(index,)) for index in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([round(run["FLIM"][-1], 9) for run in runs], [10.0, 20.0, 30.0, 40.0])


class Pickles(unittest.TestCase):
    def test_a_case_comes_back_with_its_parameters(self):
        case = slot().with_parameters(mu=0.35)
        again = pickle.loads(pickle.dumps(case))
        self.assertEqual(dict(again.parameters), dict(case.parameters))
        numpy.testing.assert_array_equal(again.run()["CSF1"], case.run()["CSF1"])
        again.parameters["mu"] = 0.1
        self.assertEqual(case.parameters["mu"], 0.35)

    def test_a_case_finds_its_data_files_in_another_process(self):
        path = next(one for one in sorted((CASES / "verification").glob("*.yaml")) if "csv:" in one.read_text())
        case = slipbench.load(os.path.relpath(path), allow_outside=True)
        file = pathlib.Path(folder.name) / "case.pickle"
        file.write_bytes(pickle.dumps(case))
        script = "import pickle, sys; run = pickle.load(open(sys.argv[1], 'rb')).run(checks=False); print(float(run['t'][-1]))"
        done = subprocess.run([sys.executable, "-c", script, file], capture_output=True, text=True, cwd="/", check=True, env={**os.environ, "PYTHONPATH": os.path.abspath(os.environ["PYTHONPATH"])})
        self.assertEqual(float(done.stdout), case.run(checks=False)["t"][-1])

    def test_a_law_is_its_numbers_and_a_run_is_none(self):
        law = slipbench.Law({key: SLOT[key] for key in ("connector", "friction", "parameters")})
        for copied in (pickle.loads(pickle.dumps(law)), copy.deepcopy(law)):
            numpy.testing.assert_array_equal(copied.numbers, law.numbers)
            self.assertEqual(copied.names, law.names)
            self.assertTrue(all(copied.names))
        self.assertEqual(slipbench.Law.from_numbers(law.numbers).names, [""])
        with self.assertRaisesRegex(ValueError, "^names: wanted 1, one of each definition, found 2$"):
            slipbench.Law.from_numbers(law.numbers, ["a", "b"])
        with self.assertRaisesRegex(TypeError, "hand over the case"):
            pickle.dumps(slot().run())


class Laws(unittest.TestCase):
    def test_durations_that_no_increment_has_are_refused(self):
        law = slipbench.Law({key: SLOT[key] for key in ("connector", "friction", "parameters")})
        state = law.initial_state()
        for duration, found in ((-1, "-1.0"), (math.nan, "nan"), (math.inf, "inf"), ([1, -2], "-2.0")):
            with self.assertRaisesRegex(ValueError, f"^duration: wanted 0 or more, found {found}$"):
                law.update(state, numpy.zeros((2, 6)), duration=duration)
        law.update(state, numpy.zeros(6), duration=0)

    def test_rows_are_the_same_as_one_by_one(self):
        law = slipbench.Law({"connector": {"type": "CYLINDRICAL"}, "friction": [{"predefined": {"R": 0.3, "L": 2}, "coefficient": 0.2}]})
        dice = numpy.random.default_rng(1)
        motion, forces = dice.normal(size=(200, 6)) * 1e-3, dice.normal(size=(200, 6)) * 100
        states = law.initial_state(200)
        together = law.update(states, motion, forces, tangent=True)
        for row in range(200):
            one = law.update(states[row], motion[row], forces[row], tangent=True)
            for name in ("state", "force", "limit", "regime", "tangent", "force_tangent"):
                numpy.testing.assert_array_equal(getattr(one, name), getattr(together, name)[row], name)

    def test_the_tangent_is_the_slope_of_the_force(self):
        law = slipbench.Law({"connector": {"type": "SLIDE-PLANE"}, "friction": [{"predefined": {}, "coefficient": 0.2, "stick": {"stiffness": 1000}}]})
        forces = numpy.array([50.0, 0, 0, 0, 0, 0])
        motion = numpy.array([0, 0.05, 0.02, 0, 0, 0])
        step = law.update(law.initial_state(), motion, forces, tangent=True)
        for column in (1, 2):
            delta = numpy.zeros(6)
            delta[column] = 1e-7
            ahead, behind = (law.update(law.initial_state(), motion + sign * delta, forces).force for sign in (1, -1))
            # Central differences of 1e-7 lose 9 digits of forces of 10 N.
            numpy.testing.assert_allclose(step.tangent[:, column], (ahead - behind) / 2e-7, atol=1e-4)

    def test_wrong_shapes_are_told(self):
        law = slipbench.Law({"connector": {"type": "SLOT"}, "friction": [{"predefined": {}, "coefficient": 0.2}]})
        with self.assertRaisesRegex(ValueError, "motion: wanted 6"):
            law.update(law.initial_state(), numpy.zeros(5))
        one, rows = law.initial_state(), numpy.zeros((4, 6))
        with self.assertRaisesRegex(ValueError, r"forces: wanted an array of shape \(6,\) or \(1, 6\), found shape \(4,\)"):
            law.update(one, numpy.zeros(6), numpy.zeros(4))
        for name, value in (("forces", numpy.zeros(24)), ("forces", numpy.zeros((6, 4))), ("forces", numpy.zeros((3, 6))), ("begin", 0.0),
                            ("duration", [1, 2]), ("duration", [[1, 1, 1, 1]]), ("temperature", numpy.zeros(5)), ("fields", numpy.zeros((2, 3))),
                            ("fields", numpy.zeros(17)), ("fields", numpy.zeros((4, 1, 1)))):
            with self.assertRaisesRegex(ValueError, f"{name}: wanted"):
                law.update(one, rows, **{name: value})
        with self.assertRaisesRegex(ValueError, "state: wanted"):
            law.update(numpy.zeros(15 * 4), rows)

    def test_fields_are_of_all_or_of_each(self):
        law = slipbench.Law({"connector": {"type": "SLOT"}, "friction": [{"predefined": {}, "coefficient": {
            "columns": ["mu", "field1", "field2"], "rows": [[0.1, 0, 0], [0.2, 1, 0], [0.3, 0, 1], [0.4, 1, 1]]}}]})
        rows, forces = numpy.ones((3, 6)), [0, 100, 0, 0, 0, 0]

        def mu(fields, motion=rows):
            return numpy.round(law.update(law.initial_state(), motion, forces, fields=fields).mu, 12).tolist()

        self.assertEqual(mu([1, 0]), [0.2, 0.2, 0.2])
        self.assertEqual(mu([[1, 0]]), [0.2, 0.2, 0.2])
        self.assertEqual(mu([[0, 0], [1, 0], [1, 1]]), [0.1, 0.2, 0.4])
        self.assertEqual(mu([[0], [1], [0]]), [0.1, 0.2, 0.1])
        self.assertEqual(mu(1.0), [0.2, 0.2, 0.2])
        self.assertEqual(mu([0, 1], rows[0]), 0.3)
        self.assertEqual(mu([1], rows[0]), 0.2)
        for count in (2, 3):
            with self.assertRaisesRegex(ValueError, rf"fields: shape \({count},\) may be .* shape \({count}, 1\) or \(1, {count}\)"):
                mu([0] * count, rows[:count])
        with self.assertRaisesRegex(slipbench.CaseError, "coeficient"):
            slipbench.Law({"connector": {"type": "SLOT"}, "friction": [{"predefined": {}, "coeficient": 0.2}]})

    def test_a_law_comes_back_from_its_numbers(self):
        law = slipbench.Law({"connector": {"type": "PLANAR"}, "friction": [{"predefined": {"R": 0.3}, "coefficient": {"columns": ["mu", "slip_rate"], "rows": [[0.3, 0], [0.2, 10]]}}]})
        again = slipbench.Law.from_numbers(law.numbers)
        numpy.testing.assert_array_equal(again.numbers, law.numbers)
        motion, forces = [0, 0.1, 0.2, 0.3, 0, 0], [100, 0, 0, 0, 5, 5]
        for one in (law, again):
            self.assertEqual(one.state_size, 30)
        numpy.testing.assert_array_equal(again.update(again.initial_state(), motion, forces).state, law.update(law.initial_state(), motion, forces).state)
        with self.assertRaisesRegex(ValueError, "no packed friction"):
            slipbench.Law.from_numbers(law.numbers[:-1])

    def test_a_number_that_is_none_is_told_with_its_increment(self):
        law = slipbench.Law({key: SLOT[key] for key in ("connector", "friction", "parameters")})
        forces = numpy.zeros((100, 6))
        forces[73, 1] = numpy.nan
        with self.assertRaisesRegex(slipbench.RunError, "increment 73: .*not finite"):
            law.update(law.initial_state(100), numpy.ones((100, 6)), forces)


class Others(unittest.TestCase):
    def test_pandas_has_the_columns_over_time(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("no pandas")
        run = slot().run()
        frame = run.to_pandas()
        self.assertEqual(list(frame.columns), [name for name in run if name != "t"])
        self.assertEqual(frame.index.name, "t")
        self.assertEqual(frame.attrs["units"]["CSF1"], "N")

    def test_xarray_has_units_and_texts(self):
        try:
            import xarray  # noqa: F401
        except ImportError:
            self.skipTest("no xarray")
        data = slot().run().to_xarray()
        self.assertEqual(data["CSF1"].attrs["units"], "N")
        self.assertTrue(data["CSF1"].attrs["long_name"])

    def test_a_plot_has_force_limit_and_loop(self):
        try:
            import matplotlib
        except ImportError:
            self.skipTest("no matplotlib")
        matplotlib.use("Agg")
        run = slot().run()
        over_time, over_motion = run.plot()
        drawn = {line.get_label() for line in over_time.lines}
        self.assertLessEqual({"limit", "CSF1"}, drawn)
        self.assertEqual(over_motion.get_xlabel(), "CU1 [mm]")
        numpy.testing.assert_array_equal(over_motion.lines[0].get_ydata(), run["CSF1"])
        page = run._repr_html_()
        self.assertIn("data:image/png;base64,", page)
        self.assertIn("PASS limit", page)

    @unittest.skipIf("libasan" in os.environ.get("LD_PRELOAD", ""), "the address sanitizer keeps for a while what is freed")
    def test_many_runs_leave_nothing(self):
        case = slot()

        def memory():
            return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

        # As long as the first runs take, the allocator fills its pools.
        for _ in range(500):
            case.run()
        before = memory()
        for _ in range(10_000):
            case.run()
        self.assertLess(memory() - before, 1 << 20)


if __name__ == "__main__":
    unittest.main(verbosity=1)
