# SPDX-License-Identifier: Apache-2.0
"""Runs of the program in a folder of their own, for tests that are called with PROGRAM SOURCE_FOLDER."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SECONDS = 20 * int(os.environ.get("SLIPBENCH_PATIENCE", 1))  # a command that takes longer hangs
del sys.argv[1:]


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="slipbench-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_text(text)

    def run_tool(self, *words, code=0, stdin=subprocess.DEVNULL, env=None):
        """What a command says, on both streams; it has to end with that code."""
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, capture_output=True, text=True, stdin=stdin, timeout=10*SECONDS,
                              env={**os.environ, **(env or {})})
        self.assertEqual(done.returncode, code, f"{words}: {done.stdout}{done.stderr}")
        return done.stdout + done.stderr
