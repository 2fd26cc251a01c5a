# SPDX-License-Identifier: Apache-2.0
"""The Python module: fits, sweeps, checks and closed forms, held against the program.

usage: tools_test.py SLIPBENCH CASES_FOLDER [unittest words]   (PYTHONPATH has the module)
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy

import slipbench

SLIPBENCH, CASES = pathlib.Path(sys.argv.pop(1)), pathlib.Path(sys.argv.pop(1))
SLOT = {
    "slipbench": 1,
    "title": "slot",
    "parameters": {"mu": 0.2, "N": 100},
    "connector": {"type": "SLOT"},
    "friction": [{"predefined": {}, "coefficient": "= mu", "stick": {"stiffness": 1000}}],
    "history": [{"step": "a", "increments": 100, "motion": {"CP1": {"sine": {"amplitude": 3, "period": 0.5}}}, "force": {"f2": "= N"}}],
}


class Fits(unittest.TestCase):
    def test_a_fit_finds_what_the_program_finds_in_all_bits(self):
        fit = CASES / "calibration" / "exponential_decay_fit.yaml"
        found = slipbench.calibrate(fit, threads=1)
        with tempfile.TemporaryDirectory() as name:
            subprocess.run([SLIPBENCH, "calibrate", fit, "-o", name], check=True, capture_output=True)
            wanted = json.loads((pathlib.Path(name) / f"{fit.stem}.json").read_text())
        self.assertTrue(found.converged)
        self.assertEqual([one.value for one in found.estimates.values()], [one["value"] for one in wanted["unknowns"]])
        self.assertEqual(found["mu_s"], wanted["unknowns"][0]["value"])
        numpy.testing.assert_array_equal(found.covariance, numpy.array(wanted["covariance"], dtype=float))
        self.assertAlmostEqual(found.covariance[0, 0] ** 0.5, found.estimates["mu_s"].standard_error)
        self.assertIn("converged", str(found))

    def test_the_case_with_the_values_found_runs(self):
        folder = CASES / "calibration"
        case = slipbench.calibrate(folder / "exponential_decay_fit.yaml").case(folder)
        self.assertAlmostEqual(case.parameters["mu_s"], 0.42044, places=4)
        # The load of 200 N at the start of slip.
        self.assertAlmostEqual(abs(case.run()["CSF1"]).max(), 200.0 * case.parameters["mu_s"], delta=0.5)

    def test_a_fit_that_is_not_there_is_told(self):
        with self.assertRaisesRegex(slipbench.CaseError, "nowhere.yaml"):
            slipbench.calibrate("nowhere.yaml")


class Sweeps(unittest.TestCase):
    def test_parameters_are_broadcast_and_figures_collected(self):
        case = slipbench.load(SLOT)
        mu = numpy.linspace(0.1, 0.3, 5)
        result = slipbench.sweep(case, mu=mu[:, None], N=numpy.array([50.0, 200.0]))
        self.assertEqual(len(result["mu"]), 10)
        numpy.testing.assert_allclose(result["force"], result["mu"] * result["N"], rtol=1e-12)
        one = case.with_parameters(mu=0.1, N=200.0).run()
        row = numpy.flatnonzero((result["mu"] == 0.1) & (result["N"] == 200.0))[0]
        self.assertEqual(result["dissipation"][row], one["DISS"][-1])
        self.assertEqual(case.parameters["mu"], 0.2)

    def test_functions_collect_what_one_wants(self):
        result = slipbench.sweep(slipbench.load(SLOT), {"peak": lambda run: run["CSF1"].max()}, mu=[0.1, 0.2], threads=2)
        numpy.testing.assert_allclose(result["peak"], [10.0, 20.0])
        self.assertEqual(result.failures, {})

    def test_a_faulty_sample_fails_by_itself(self):
        for collect in (None, {"peak": lambda run: run["CSF1"].max()}):
            result = slipbench.sweep(slipbench.load(SLOT), collect, mu=[0.1, -1.0])
            self.assertEqual(list(result.failures), [1])
            self.assertIn("coefficient", result.failures[1])
            name = list(result)[-1]
            self.assertTrue(numpy.isfinite(result[name][0]) and numpy.isnan(result[name][1]))
        with self.assertRaisesRegex(slipbench.CaseError, "nu"):
            slipbench.sweep(slipbench.load(SLOT), nu=[0.1, 0.2])

    def test_numbers_of_a_sweep_file_are_those_of_runs(self):
        case = slipbench.load(SLOT, N=80)
        dice = numpy.random.default_rng(1)
        mu = dice.uniform(0.1, 0.3, 300)
        result = slipbench.sweep(case, {"peak": {"max": "CSF1"}, "lost": {"last": "DISS"}, "loose": {"count": "stick_to_slip"}}, mu=mu)
        for index in (0, 99, 299):
            run = case.with_parameters(mu=mu[index]).run()
            self.assertEqual((result["peak"][index], result["lost"][index]), (run["CSF1"].max(), run["DISS"][-1]))
            self.assertEqual(result["loose"][index], sum((one.origin, one.goal) == ("stick", "slip") for one in run.events))
        with self.assertRaisesRegex(slipbench.CaseError, "CSF11"):
            slipbench.sweep(case, {"peak": {"max": "CSF11"}}, mu=mu)

    def test_ctrl_c_ends_a_sweep(self):
        case = slipbench.load({**SLOT, "history": [{**SLOT["history"][0], "increments": 1_000_000, "duration": 1000}]})
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            slipbench.sweep(case, {"loose": {"count": "stick_to_slip"}}, mu=numpy.linspace(0.1, 0.2, 400))
        self.assertLess(time.monotonic() - begin, 5.0)


class Checks(unittest.TestCase):
    def test_cases_are_judged_as_by_the_program(self):
        results = slipbench.check(CASES / "examples")
        self.assertGreater(len(results), 20)
        self.assertTrue(all(results), [one.file for one in results if not one])

    def test_a_case_that_is_none_does_not_pass(self):
        with tempfile.TemporaryDirectory() as name:
            file = pathlib.Path(name) / "a.yaml"
            file.write_text("slipbench: 1\n")
            (one,) = slipbench.check(file)
        self.assertFalse(one)
        self.assertIn("missing key", one.error)
        (missing,) = slipbench.check("nowhere.yaml")
        self.assertFalse(missing)

    def test_pipes_and_links_out_of_a_folder_are_not_read(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name) / "suite"
            folder.mkdir()
            os.mkfifo(folder / "a_pipe.yaml")
            (folder / "b_link.yaml").symlink_to(CASES / "examples/hinge.yaml")
            errors = {pathlib.Path(one.file).name: one.error for one in slipbench.check(folder)}
            (outside,) = [one for one in slipbench.check(folder, allow_outside=True) if one]
        self.assertIn("is a pipe", errors["a_pipe.yaml"])
        self.assertIn("is a link out of the folder", errors["b_link.yaml"])
        self.assertEqual(pathlib.Path(outside.file).name, "b_link.yaml")


class Amounts(unittest.TestCase):
    def test_amounts_that_the_program_refuses_are_value_errors(self):
        case = slipbench.load(CASES / "sweeps/slot.yaml")
        fit = CASES / "calibration/wear_table_fit.yaml"
        for threads in (-1, 2000):
            with self.assertRaisesRegex(ValueError, f"threads: wanted 0 to 1024, found {threads}"):
                slipbench.sweep(case, {"peak": {"max": "CSF1"}}, threads=threads, mu=[0.1, 0.2])
            with self.assertRaisesRegex(ValueError, f"threads: wanted 0 to 1024, found {threads}"):
                slipbench.calibrate(fit, threads=threads)
        for bootstrap in (-1, 100001):
            with self.assertRaisesRegex(ValueError, f"bootstrap: wanted 0 to 100000, found {bootstrap}"):
                slipbench.calibrate(fit, bootstrap=bootstrap)


class ClosedForms(unittest.TestCase):
    def test_the_capstan_is_eulers(self):
        form = slipbench.closed_forms.capstan
        self.assertIn("e^(mu alpha)", form.formula)
        self.assertIn("Parameters:", form.__doc__)

    def test_all_forms_are_functions_with_a_source(self):
        names = slipbench.closed_forms.__all__
        self.assertGreater(len(names), 60)
        for name in names:
            self.assertTrue(getattr(slipbench.closed_forms, name).source, name)

    def test_numbers_are_those_of_the_formula(self):
        rate = numpy.linspace(0.0, 50.0, 7)
        mu = slipbench.closed_forms.exponential_decay(static_coefficient=0.3, kinetic_coefficient=0.2, decay_coefficient=0.1, slip_rate=rate)
        mu = mu["coefficient"] if isinstance(mu, dict) else mu
        numpy.testing.assert_allclose(mu, 0.2 + 0.1 * numpy.exp(-0.1 * rate), rtol=1e-14)

    def test_what_is_missing_or_wrong_is_told(self):
        form = slipbench.closed_forms.exponential_decay
        with self.assertRaisesRegex(TypeError, "missing"):
            form(static_coefficient=0.3)
        with self.assertRaisesRegex(TypeError, "unknown static"):
            form(static=0.3)
        with self.assertRaises(ValueError):
            form(static_coefficient=-0.3, kinetic_coefficient=0.2, decay_coefficient=0.1, slip_rate=0.0)


if __name__ == "__main__":
    unittest.main(verbosity=1)
