# SPDX-License-Identifier: Apache-2.0
"""The law through Fortran, Python and units on random definitions: the same bits as in C++. And the worked examples of c/examples,
compiled and driven by a harness that plays the solver, against runs of cases.

    doors_test.py SLIPBENCH FIXTURE UNIT_LIBRARY MODULE_FOLDER [DOORS]

FIXTURE writes random definitions, DOORS is the harness; without it, where there is no Fortran, its tests are left out."""
import csv
import ctypes
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, FIXTURE, UNIT_LIBRARY, MODULE = sys.argv[1:5]
DOORS = sys.argv[5] if len(sys.argv) > 5 else None
sys.path[:0] = [MODULE, str(pathlib.Path(__file__).parent.parent / "fmu")]
import numpy  # noqa: E402

import host  # noqa: E402
import slipbench  # noqa: E402

DEFINITIONS = 2000
INPUTS, TOLD = 28, 6 + 15 + 9
fixture = subprocess.run([FIXTURE, str(DEFINITIONS)], check=True, capture_output=True, text=True).stdout


def definitions():
    """(numbers of the law, rows of inputs, rows of results) of each."""
    values = numpy.array(fixture.split(), dtype=float)
    at = 1
    for _ in range(int(values[0])):
        count = int(values[at])
        numbers = values[at + 1 : at + 1 + count]
        at += 1 + count
        rows = int(values[at])
        table = values[at + 1 : at + 1 + rows * (INPUTS + TOLD)].reshape(rows, INPUTS + TOLD)
        at += 1 + table.size
        yield numbers, table[:, :INPUTS], table[:, INPUTS:]
    assert at == len(values)


def compensated(total, left_out, part):
    """Returns a sum and what rounding leaves out of it, with one part more."""
    added = part + left_out
    after = total + added
    taken = after - total
    return after, (total - (after - taken)) + (added - taken)


class Doors(unittest.TestCase):
    def test_python(self):
        for numbers, inputs, told in definitions():
            law = slipbench.Law.from_numbers(numbers)
            numpy.testing.assert_array_equal(law.numbers, numbers)
            state = law.initial_state()
            for row, wanted in zip(inputs, told):
                one = law.update(state, row[7:13] - row[1:7], forces=row[19:25], begin=row[1:7], end=row[7:13], duration=row[0],
                                 temperature=row[25], fields=row[26:28], reference=row[13:19])
                state = one.state
                figures = [one.limit, one.normal_force, one.mu, one.slip_increment, one.slip_rate, one.dissipation, one.stored_energy, one.work, one.regime]
                numpy.testing.assert_array_equal(numpy.concatenate([one.force, state, figures]), wanted)

    @unittest.skipUnless(DOORS, "there is no Fortran compiler")
    def test_fortran(self):
        done = subprocess.run([DOORS, "law"], input=fixture, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout.split()), (0, [str(DEFINITIONS)]), done.stderr)

    def test_unit(self):
        """All definitions through one library, an instance each, all variables by their references."""
        inputs_of = [f"position {c}" for c in range(6)] + [f"force {c}" for c in range(6)] + ["temperature 0", "field 0", "field 1"]
        outputs_of = [f"friction_force {c}" for c in range(6)] + [f"{role} 0" for role in (
            "limit", "normal_force", "mu", "accumulated_slip", "dissipation", "stored_energy", "work", "regime")]
        library = ctypes.CDLL(UNIT_LIBRARY)
        library.fmi2Instantiate.restype = ctypes.c_void_p
        places = (ctypes.c_uint * 15)(*range(15))
        outputs, regime_at = (ctypes.c_uint * 13)(*range(15, 28)), (ctypes.c_uint * 1)(28)
        found, regime = (ctypes.c_double * 13)(), ctypes.c_int()
        with tempfile.TemporaryDirectory() as folder:
            law = pathlib.Path(folder) / "law.txt"
            for numbers, inputs, told in definitions():
                first = inputs[0]
                starts = [*first[1:7], *first[19:28]]
                lines = ["guid g", "slipbench_fmu 1", "time_unit 1", "initial " + " ".join(map(repr, first[1:7].tolist())),
                         "reference " + " ".join(map(repr, first[13:19].tolist())), f"variables {len(inputs_of) + len(outputs_of)}"]
                lines += [f"{role} {float(start)!r}" for role, start in zip(inputs_of, starts)] + [f"{role} 0" for role in outputs_of]
                lines += ["parameters 0", f"numbers {len(numbers)}", *map(repr, numbers.tolist())]
                law.write_text("\n".join(lines) + "\n")
                one = library.fmi2Instantiate(b"one", 1, b"g", b"file://" + folder.encode(), None, 0, 0)
                self.assertTrue(one)
                component = ctypes.c_void_p(one)
                zero = ctypes.c_double(0)
                self.assertEqual(library.fmi2SetupExperiment(component, 0, zero, zero, 0, zero), 0)
                self.assertEqual(library.fmi2EnterInitializationMode(component), 0)
                self.assertEqual(library.fmi2ExitInitializationMode(component), 0)
                dissipation = work = (0.0, 0.0)
                time = 0.0
                for i, (row, wanted) in enumerate(zip(inputs, told)):
                    values = (ctypes.c_double * 15)(*row[7:13], *row[19:28])
                    self.assertEqual(library.fmi2SetReal(component, places, ctypes.c_size_t(15), values), 0)
                    if i > 0:
                        self.assertEqual(library.fmi2DoStep(component, ctypes.c_double(time), ctypes.c_double(row[0]), 1), 0)
                        time += row[0]
                    self.assertEqual(library.fmi2GetReal(component, outputs, ctypes.c_size_t(13), found), 0)
                    self.assertEqual(library.fmi2GetInteger(component, regime_at, ctypes.c_size_t(1), ctypes.byref(regime)), 0)
                    dissipation = compensated(*dissipation, wanted[26])
                    work = compensated(*work, wanted[28])
                    expected = [*wanted[:6], *wanted[21:24], wanted[18], dissipation[0], wanted[27], work[0], wanted[29]]
                    self.assertEqual([*found, regime.value], expected)
                library.fmi2FreeInstance(component)


# The normal force grows, the rate changes, the slot turns round: stick, slip and a coefficient that falls. All numbers are sums of
# few powers of two, so that a solver that adds up its increments stands where the case does.
CASE = """slipbench: 1
title: a slot
parameters: {mu_s: 0.3, mu_k: 0.2, decay: 0.5}
connector: {type: SLOT}
friction:
  - predefined: {internal_contact_force: 0}
    coefficient: {exponential_decay: {static: = mu_s, kinetic: = mu_k, decay: = decay}}
    stick: {elastic_slip: 0.0625}
history:
  - step: slide
    duration: 4.0
    increments: 1024
    motion: {CP1: {triangle: {amplitude: 2.0, period: 2.0}}}
    force: {f2: {to: 64}, f3: 16}
"""


@unittest.skipUnless(DOORS, "there is no Fortran compiler")
class Examples(unittest.TestCase):
    def solved(self, kind, lines):
        done = subprocess.run([DOORS, kind], input="\n".join(lines) + "\n", capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return numpy.array([line.split() for line in done.stdout.splitlines()], dtype=float)

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.case = pathlib.Path(self.folder.name) / "slot.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def run_case(self, text):
        self.case.write_text(text)
        subprocess.run([PROGRAM, "run", self.case, "-o", self.folder.name], check=True, capture_output=True)
        with open(self.case.with_suffix(".csv")) as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        return {name: numpy.array([float(row[name]) for row in rows]) for name in rows[0]}

    def numbers(self):
        return subprocess.run([PROGRAM, "export", self.case, "--to", "numbers"], check=True, capture_output=True, text=True).stdout.split()

    def test_connector_of_an_explicit_solver(self):
        run = self.run_case(CASE)
        rows = [f"{dt!r} {cp1!r} {f2!r} {f3!r}" for dt, cp1, f2, f3 in zip(
            numpy.diff(run["t"]).tolist(), run["CP1"].tolist()[1:], run["CTF2"].tolist()[1:], run["CTF3"].tolist()[1:])]
        solved = self.solved("connector", ["1048576 0.001 0.3 0.2 0.5 0.0625", *rows])
        numpy.testing.assert_array_equal(solved[:, 0], run["CSF1"][1:])
        # The solver adds up its energies itself, which rounds by some 1e-16 of them in each of 1024 increments.
        numpy.testing.assert_allclose(solved[:, 1], run["DISS"][1:], rtol=1e-13)
        self.assertAlmostEqual(solved[0, 2], math.sqrt(2 * 0.001 / 1048576))
        self.assertEqual(set(run["STATUS"][1:]), {1.0, 2.0})

    def test_coefficient_of_a_contact(self):
        run = self.run_case(CASE)
        slips = run["STATUS"] == 2
        rates = numpy.diff(run["CASU1"], prepend=0.0) / (4.0 / 1024)
        rows = [f"{rate!r} {force!r}" for rate, force in zip(rates[slips].tolist(), run["FN"][slips].tolist())]
        solved = self.solved("coefficient", [*self.numbers(), *rows])
        # The rate is a difference of sums here: rounded by some 1e-16 of the slip so far.
        numpy.testing.assert_allclose(solved[:, 0], run["MU"][slips], rtol=1e-13)
        numpy.testing.assert_allclose(solved[:, 1], -0.05 * numpy.exp(-0.5 * rates[slips]), rtol=1e-13)
        self.assertTrue((solved[:, 2] == 0).all())

    def test_friction_spring(self):
        text = (CASE.replace("type: SLOT", "type: AXIAL").replace("- predefined: {internal_contact_force: 0}", "- component: 1\n    internal_contact_force: 64")
                .replace("    force: {f2: {to: 64}, f3: 16}\n", ""))
        run = self.run_case(text)
        rates = numpy.diff(run["CP1"]) / numpy.diff(run["t"])
        rows = [f"{dt!r} {rate!r}" for dt, rate in zip(numpy.diff(run["t"]).tolist(), rates.tolist())]
        solved = self.solved("spring", [*self.numbers(), *rows])
        numpy.testing.assert_array_equal(solved[:, 0], run["CSF1"][1:])
        numpy.testing.assert_allclose(solved[:, 1], run["WORK"][1:], rtol=1e-13)  # likewise
        self.assertAlmostEqual(solved[:, 2].max(), 0.3 * 64 / 0.0625)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
