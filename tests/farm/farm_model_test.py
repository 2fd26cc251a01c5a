# SPDX-License-Identifier: Apache-2.0
"""Holds the model of the farm against what is known without it.

usage: farm_model_test.py SOURCE_FOLDER
"""
import pathlib
import re
import sys
import unittest

sys.dont_write_bytecode = True
SOURCE = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(SOURCE / "bench"))
import farm_model  # noqa: E402


def simulated(**values):
    free = {"start": 0.0, "point": 0.0, "question": 0.0, "answer": 0.0}
    return farm_model.simulate(farm_model.Farm(**{**free, **values}))


class Model(unittest.TestCase):
    def test_one_rank_without_costs_takes_the_time_of_its_samples(self):
        for longest in (1.0, 100.0):
            found = simulated(ranks=1, samples=1000, sample=0.1, longest=longest)
            self.assertAlmostEqual(found["run [s]"], 100.0, places=9)
            self.assertAlmostEqual(found["efficiency of the run"], 1.0, places=9)

    def test_a_slow_counter_bounds_the_run_from_below(self):
        found = simulated(ranks=100, samples=128_000, sample=1e-7, answer=1e-2)
        self.assertGreater(found["run [s]"], found["questions"] * 0.999e-2)
        self.assertAlmostEqual(found["counter busy"], 1.0, places=2)

    def test_a_question_costs_each_rank_its_time(self):
        few, many = (simulated(ranks=4, samples=4096, sample=1e-3, question=q)["run [s]"] for q in (0.0, 0.5))
        asked = simulated(ranks=4, samples=4096, sample=1e-3)["questions"]
        self.assertAlmostEqual(many - few, 0.5 * asked / 4, delta=2.0)

    def test_the_last_batch_bounds_what_ranks_wait(self):
        found = simulated(ranks=8, samples=8000, sample=0.02, longest=100.0)
        self.assertLess(found["run [s]"], 8000 * 0.02 / 8 + 2 * 0.04)

    def test_the_batches_are_those_of_the_program(self):
        source = (SOURCE / "driver/farm/run_farm.cpp").read_text()
        self.assertEqual(int(re.search(r"kBatchesARank = (\d+);", source)[1]), farm_model.BATCHES_A_RANK)


if __name__ == "__main__":
    unittest.main()
