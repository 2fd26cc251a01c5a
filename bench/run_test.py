#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tries bench/run at a hundredth of the sizes: it tells of all workloads, and who ends elsewhere is out.

usage: run_test.py SLIPBENCH
"""
import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest

RUN = pathlib.Path(__file__).resolve().parent / "run"
SLIPBENCH = pathlib.Path(sys.argv.pop(1)).resolve()


def race(*options, slipbench=SLIPBENCH):
    """Runs it without Python's peers, which take their time to start."""
    return subprocess.run([sys.executable, RUN, "--slipbench", slipbench, "--python", "false", "--rounds", "1", "--scale",
                           "small", *options], capture_output=True, text=True)


class Tries(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def script(self, text):
        file = pathlib.Path(self.folder.name) / f"script{len(list(pathlib.Path(self.folder.name).iterdir()))}"
        file.write_text("#!/bin/sh\n" + text + "\n")
        file.chmod(file.stat().st_mode | stat.S_IXUSR)
        return file

    def test_all_workloads_end_where_is_known_and_who_is_missing_is_told(self):
        target = pathlib.Path(self.folder.name) / "results.md"
        done = race("--output", target)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        table = target.read_text()
        for key in ("W1:", "W2:", "W3:", "W4:", "W4k:", "W5:", "W6:", "W6b:", "W7:", "W8:", "W9:", "W10:"):
            self.assertIn(f"### {key}", table)
        self.assertIn("Not installed: NumPy (python3-numpy).", table)
        self.assertRegex(table, r"\| floor \| [0-9.e-]+ \([0-9.e-]+ \.\. [0-9.e-]+\) \|")
        self.assertNotIn("out: wrong end", table)

    def test_a_fast_wrong_answer_is_out(self):
        hasty = self.script(f'for word; do shift; set -- "$@" "$(echo "$word" | sed s/^increments=10000$/increments=9999/)"; done\n'
                            f'exec {SLIPBENCH} "$@"')
        done = race("--only", "W2", "--output", "-", slipbench=hasty)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("WRONG: W2, slipbench run: CASU1 = 399.", done.stdout)
        self.assertIn("| slipbench run | **out: wrong end** |", done.stdout)

    def test_a_peer_is_held_to_the_same_end(self):
        right = self.script('test "$1" = 10000 && echo \'{"f": 12, "s": 399.5188}\'')
        wrong = self.script('echo \'{"f": 12, "s": 399.5}\'')
        done = race("--only", "W2", "--output", "-", "--mtest", f"{right} {{steps}}")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("| at least 50: ", done.stdout)
        done = race("--only", "W2", "--output", "-", "--mtest", str(wrong))
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("WRONG: W2, MTest (the command given): s = 399.5, known is 399.5188", done.stdout)

    def test_an_unknown_workload_is_refused(self):
        done = race("--only", "W2,W11")
        self.assertEqual(done.returncode, 2)
        self.assertIn("no workload W11; there are W1, W2", done.stderr)


if __name__ == "__main__":
    unittest.main()
