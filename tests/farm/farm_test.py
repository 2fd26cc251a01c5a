# SPDX-License-Identifier: Apache-2.0
"""Runs a sweep by the ranks of MPI, by a Slurm of one node, by GNU parallel and by Dask; all must leave the bytes that
one program leaves.

usage: farm_test.py BUILD_FOLDER SOURCE_FOLDER ENGINE, of mpi, calibrate, slurm, parallel, dask
Exit code 77 where the engine is not installed.
"""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import slurm_node  # noqa: E402

BUILD, SOURCE = map(pathlib.Path, sys.argv[1:3])
SLIPBENCH = BUILD / "slipbench"
FARM = BUILD / "slipbench-mpi"
# The ranks of a test may be more than the cores, and a container's user is root.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_NUM_THREADS": "1"}
MPIRUN = ["mpirun", "--oversubscribe", "--mca", "btl_vader_single_copy_mechanism", "none"]
PATIENCE = int(os.environ.get("SLIPBENCH_PATIENCE", 1))  # builds that take as many times as long get fewer samples, and more time
SYSTEM_PYTHON = "/usr/bin/python3"  # the one that Debian's packages are of


def run(*command, code=0, timeout=240):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=ENVIRONMENT, timeout=PATIENCE * timeout)
    if done.returncode != code:
        raise AssertionError(f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


class Sweep(unittest.TestCase):
    """A sweep of samples that take long and short, and what one program makes of it."""
    SAMPLES = 4000 // PATIENCE

    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory(prefix="farm-")
        cls.addClassCleanup(made.cleanup)
        cls.made = pathlib.Path(made.name)
        shutil.copy(SOURCE / "cases/sweeps/press_fit.yaml", cls.made)
        text = (SOURCE / "cases/sweeps/press_fit_sweep.yaml").read_text()
        (cls.made / "fit.yaml").write_text(re.sub(r"samples: \d+", f"samples: {cls.SAMPLES}", text))
        run(SLIPBENCH, "sweep", cls.made / "fit.yaml", "-o", cls.made / "one")
        cls.expected = (cls.made / "one/fit.csv").read_bytes()
        assert len(cls.expected.splitlines()) > cls.SAMPLES

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="farm-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        shutil.copytree(self.made, self.folder, dirs_exist_ok=True)
        self.sweep = self.folder / "fit.yaml"

    def check(self, folder):
        """The result is there, and nothing else but what is named."""
        self.assertEqual((folder / "fit.csv").read_bytes(), self.expected)
        self.assertEqual([path.name for path in folder.glob("*.journal")], [])


class Mpi(Sweep):
    SAMPLES = 20000 // PATIENCE

    def farm(self, ranks, out, **options):
        return run(*MPIRUN, "-n", ranks, FARM, "sweep", self.sweep, "-o", self.folder / out, **options)

    def test_one_two_and_four_ranks_leave_the_same_bytes(self):
        for ranks in (1, 2, 4):
            said = self.farm(ranks, f"of{ranks}")
            self.assertIn(f"fit: {self.SAMPLES} samples of press_fit.yaml, by {ranks} rank", said)
            self.check(self.folder / f"of{ranks}")

    def kill_a_rank(self, out, *words, kept="journal", enough=30000):
        """Starts three ranks, and kills one when each has kept something."""
        begun = subprocess.Popen([*MPIRUN, "-n", "3", FARM, "sweep", self.sweep, "-o", out, *words], env=ENVIRONMENT,
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + 60 * PATIENCE
        while time.monotonic() < end:
            files = list(out.glob(f"fit.rank*.{kept}")) if out.exists() else []
            if len(files) == 3 and all(path.stat().st_size > enough // PATIENCE for path in files):
                break
            time.sleep(0.002)
        victims = [process for process in pathlib.Path("/proc").glob("[0-9]*") if self.is_rank(process, out)]
        self.assertEqual(len(victims), 3)
        os.kill(int(victims[1].name), signal.SIGKILL)
        self.assertNotEqual(begun.wait(60 * PATIENCE), 0)

    @staticmethod
    def is_rank(process, out):
        try:
            words = (process / "cmdline").read_bytes().split(b"\0")
        except OSError:
            return False
        return words[0] == bytes(FARM) and bytes(out) in words

    def test_a_killed_rank_costs_no_more_than_its_chunks(self):
        out = self.folder / "killed"
        self.kill_a_rank(out)
        self.assertFalse((out / "fit.csv").exists())
        journals = [path.read_bytes() for path in out.glob("fit.rank*.journal")]
        # A chunk of 128 samples with four numbers each; of every journal at most the last is not whole.
        record = 24 + 128 * 4 * 8 + 8
        whole = sum((len(journal) - 1000) // record for journal in journals)
        self.assertGreater(whole, 10 // PATIENCE)
        said = self.farm(4, "killed")
        recalled = int(re.search(r"by 4 ranks, (\d+) of the chunks from a run before", said)[1])
        self.assertGreaterEqual(recalled, whole)
        self.check(out)

    def test_merge_says_what_is_missing_and_one_rank_goes_on(self):
        out = self.folder / "killed"
        self.kill_a_rank(out)
        said = run(SLIPBENCH, "merge", self.sweep, "-o", out, code=2)
        self.assertRegex(said, r"the parts are not all: missing are samples \d+ ")
        self.assertEqual(len(list(out.glob("fit.rank*.journal"))), 3)
        self.farm(1, "killed")
        self.check(out)

    def test_tallies_of_a_killed_farm_and_of_parts_leave_the_same_bytes(self):
        out = self.folder / "tallied"
        self.kill_a_rank(out, "--no-rows", kept="tally", enough=4000 * PATIENCE)  # its head and a chunk, however many samples there are
        said = run(SLIPBENCH, "merge", self.sweep, "-o", out, code=2)
        self.assertIn("missing are samples ", said)
        said = run(*MPIRUN, "-n", 2, FARM, "sweep", self.sweep, "-o", out, "--no-rows")
        self.assertRegex(said, r"by 2 ranks, \d+ of the chunks from a run before")
        self.assertEqual([path.name for path in out.iterdir()], ["fit.json"])
        parts = self.folder / "parts"
        for part in ("3/3", "1/3"):
            run(SLIPBENCH, "sweep", self.sweep, "-o", parts, "--no-rows", "--part", part)
        self.assertIn(": part 2/3", run(SLIPBENCH, "merge", self.sweep, "-o", parts, code=2))
        run(SLIPBENCH, "sweep", self.sweep, "-o", parts, "--no-rows", "--part", "2/3")
        run(SLIPBENCH, "merge", self.sweep, "-o", parts)
        for folder in (out, parts):
            self.assertEqual((folder / "fit.json").read_bytes(), (self.folder / "one/fit.json").read_bytes())

    @unittest.skipIf(PATIENCE > 1, "sanitizers have an allocator of their own")
    def test_a_rank_with_an_internal_error_ends_all(self):
        library, out = self.folder / "no_memory.so", self.folder / "out"
        run("c++", "-shared", "-fPIC", pathlib.Path(__file__).with_name("no_memory.cpp"), "-o", library)
        said = run(*MPIRUN, "-x", f"LD_PRELOAD={library}", "-x", f"NO_MEMORY_AFTER={out}/fit.rank1.journal", "-n", 3, FARM,
                   "sweep", self.sweep, "-o", out, code=70, timeout=60)
        self.assertEqual(said.count("slipbench-mpi: internal error: std::bad_alloc"), 1, said)
        self.farm(2, "out")
        self.check(out)

    def test_a_fault_of_the_input_is_told_once_and_a_damaged_journal_is_refused(self):
        self.sweep.write_text(self.sweep.read_text().replace("sampler: sobol", "sampler: sobel"))
        said = self.farm(3, "wrong", code=2)
        self.assertEqual(said.count("found 'sobel'"), 1, said)
        self.sweep.write_text(self.sweep.read_text().replace("sampler: sobel", "sampler: sobol"))
        out = self.folder / "damaged"
        self.kill_a_rank(out)
        journal = out / "fit.rank1.journal"
        data = bytearray(journal.read_bytes())
        data[3000] ^= 1
        journal.write_bytes(data)
        self.assertRegex(self.farm(2, "damaged", code=4), r"rank1\.journal: .*--force begins anew")
        self.assertIn("by 2 ranks\n", run(*MPIRUN, "-n", 2, FARM, "sweep", self.sweep, "-o", out, "--force"))
        self.check(out)


class Calibrate(unittest.TestCase):
    def test_ranks_share_starts_resamplings_and_profiles_to_the_same_bytes(self):
        with tempfile.TemporaryDirectory(prefix="farm-") as name:
            folder = pathlib.Path(name)
            shutil.copytree(SOURCE / "cases/calibration", folder, dirs_exist_ok=True)
            for fit in ("slider_loop_fit", "wear_table_fit", "backlash_brake_fit"):
                file = folder / f"{fit}.yaml"
                file.write_text(file.read_text().replace("\ncalibrate:", "\ncalibrate:\n  multistart: 7"))
                words = ["calibrate", file, "--bootstrap", 9, "--profile", "-o"]
                run(SLIPBENCH, *words, folder / "one")
                expected = (folder / f"one/{fit}.json").read_bytes()
                for ranks in (1, 3):
                    run(*MPIRUN, "-n", ranks, FARM, *words, folder / f"of{ranks}")
                    self.assertEqual((folder / f"of{ranks}/{fit}.json").read_bytes(), expected)
            said = run(*MPIRUN, "-n", 3, FARM, "calibrate", folder / "no_fit.yaml", code=4)
            self.assertEqual(said.count("cannot be read"), 1)


class Slurm(Sweep):
    def test_the_job_array_and_srun_leave_the_same_bytes(self):
        array, farm = self.folder / "array", self.folder / "srun"
        # So slow that there are four tasks.
        run(SLIPBENCH, "sweep", self.sweep, "-o", array, "--emit", "slurm", "--rate", self.SAMPLES / 500)
        with slurm_node.SlurmNode() as node:
            node.run("sbatch", "--wait", array / "fit.slurm", cwd=self.folder)
            node.run("srun", "--mpi=pmix", "-n", "4", FARM, "sweep", self.sweep, "-o", farm)
        self.assertEqual(len(list(array.glob("fit.*of4.csv"))), 4)
        run(SLIPBENCH, "merge", self.sweep, "-o", array)
        self.check(array)
        self.check(farm)


class Example(Sweep):
    """The examples of docs/guide/scaling.md, word by word."""

    def example(self, language, program):
        text = (SOURCE / "docs/guide/scaling.md").read_text()
        blocks = [block for block in re.findall(rf"```{language}\n(.*?)```", text, re.S) if program in block]
        self.assertEqual(len(blocks), 1)
        out = self.folder / "out"
        out.mkdir()
        script = self.folder / "example"
        script.write_text(blocks[0])
        environment = {**ENVIRONMENT, "PATH": f"{BUILD}:{ENVIRONMENT['PATH']}"}
        shell = ["sh", "-e"] if language == "sh" else [SYSTEM_PYTHON]
        done = subprocess.run([*shell, script], cwd=self.folder, env=environment, capture_output=True, text=True,
                              timeout=240 * PATIENCE)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(len(list(out.glob("fit.*of8.csv"))), 8)
        self.check(out)


class Parallel(Example):
    def test_gnu_parallel(self):
        self.example("sh", "parallel")


class Dask(Example):
    def test_dask(self):
        self.example("python", "dask")


def imports(module):
    return subprocess.run([SYSTEM_PYTHON, "-c", f"import {module}"], capture_output=True).returncode == 0


# For each engine its tests, and what is missing.
ENGINES = {"mpi": (Mpi, lambda: [word for word in ("mpirun",) if not shutil.which(word)] + ([] if FARM.exists() else [FARM.name])),
           "calibrate": (Calibrate, lambda: [word for word in ("mpirun",) if not shutil.which(word)] + ([] if FARM.exists() else [FARM.name])),
           "slurm": (Slurm, lambda: slurm_node.missing() + ([] if FARM.exists() else [FARM.name])),
           "parallel": (Parallel, lambda: [] if shutil.which("parallel") else ["parallel"]),
           "dask": (Dask, lambda: [] if imports("distributed") else ["python3-distributed"])}

if __name__ == "__main__":
    tests, missing = ENGINES[sys.argv[3]]
    if missing():
        print(f"skipped: not here: {', '.join(missing())}; scripts/setup.sh farm installs the packages")
        sys.exit(77)
    result = unittest.TextTestRunner(verbosity=2).run(unittest.defaultTestLoader.loadTestsFromTestCase(tests))
    sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)
