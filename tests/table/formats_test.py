# SPDX-License-Identifier: Apache-2.0
"""Holds results as npy and HDF5 against those as CSV, read by NumPy and h5py.

usage: formats_test.py BUILD_FOLDER SOURCE_FOLDER
"""
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

try:
    import h5py
    import numpy
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.dont_write_bytecode = True
BUILD, SOURCE = map(pathlib.Path, sys.argv[1:3])
del sys.argv[1:3]
SLIPBENCH = BUILD / "slipbench"
if not (BUILD / "slipbench-hdf5.so").exists():
    print("skipped: the plug-in is not built, for want of libhdf5")
    sys.exit(77)


class Formats(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="formats-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for path in (SOURCE / "cases/sweeps").glob("press_fit*.yaml"):
            shutil.copy(path, self.folder)

    def run_tool(self, *words, code=0, program=SLIPBENCH):
        done = subprocess.run([program, *map(str, words)], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def read_csv(self, name):
        """Returns the lines of the head, and the columns by name."""
        lines = (self.folder / name).read_text().splitlines(keepends=True)
        head = [line for line in lines if line.startswith("#")]
        names = lines[len(head)].strip().split(",")
        rows = [list(map(float, line.split(","))) for line in lines[len(head) + 1:]]
        return "".join(head), dict(zip(names, numpy.array(rows).T))

    def check(self, stem):
        """The same numbers, to the bit, in all three formats."""
        head, columns = self.read_csv(f"{stem}.csv")
        array = numpy.load(self.folder / f"{stem}.npy", allow_pickle=False)
        self.assertEqual(list(array.dtype.names), list(columns))
        with h5py.File(self.folder / f"{stem}.h5") as file:
            self.assertEqual(set(file), set(columns))
            self.assertEqual(file.attrs["provenance"].decode(), head)
            for name, values in columns.items():
                self.assertEqual(array[name].tobytes(), values.tobytes())
                self.assertEqual(file[name][:].tobytes(), values.tobytes())
                self.assertIsNone(file[name].chunks)
            return {name: file[name].attrs["unit"].decode() for name in file if "unit" in file[name].attrs}

    def test_a_run(self):
        for form in ("csv", "npy", "h5"):
            said = self.run_tool("run", "press_fit.yaml", "--format", form)
            self.assertIn(f"press_fit.{form}", said)
        units = self.check("press_fit")
        self.assertEqual((units["CP1"], units["CSF1"], units["DISS"]), ("mm", "N", "N mm"))
        # A result of the same case may be replaced, anything else may not.
        for form in ("npy", "h5"):
            self.run_tool("run", "press_fit.yaml", "--format", form)
            (self.folder / f"press_fit.{form}").write_bytes(b"something else")
            self.assertIn("press_fit", self.run_tool("run", "press_fit.yaml", "--format", form, code=4))
            self.assertEqual((self.folder / f"press_fit.{form}").read_bytes(), b"something else")

    def test_a_sweep_by_threads_and_parts(self):
        for form in ("csv", "npy", "h5"):
            self.run_tool("sweep", "press_fit_sweep.yaml", "--format", form)
        self.check("press_fit_sweep")
        whole = {form: (self.folder / f"press_fit_sweep.{form}").read_bytes() for form in ("npy", "h5")}
        for part in (1, 2):
            self.run_tool("sweep", "press_fit_sweep.yaml", "-o", "parts", "--part", f"{part}/2", "-j", 1)
        for form, known in whole.items():
            self.run_tool("merge", "press_fit_sweep.yaml", "-o", "parts", "--format", form)
            self.assertEqual((self.folder / f"parts/press_fit_sweep.{form}").read_bytes(), known)
        self.assertIn("parts are csv", self.run_tool("sweep", "press_fit_sweep.yaml", "--part", "1/2", "--format", "npy", code=2))

    def test_converting_there_and_back_gives_the_same_bytes(self):
        self.run_tool("run", "press_fit.yaml")
        csv = (self.folder / "press_fit.csv").read_bytes()
        self.run_tool("convert", "press_fit.csv", "-o", "a.h5")
        self.run_tool("convert", "a.h5", "-o", "b.csv")
        self.assertEqual((self.folder / "b.csv").read_bytes(), csv)
        self.assertIn("no place", self.run_tool("convert", "a.h5", "-o", "c.npy"))
        self.run_tool("convert", "c.npy", "-o", "d.csv")
        self.assertEqual((self.folder / "d.csv").read_bytes(), b"".join(
            line for line in csv.splitlines(keepends=True) if not line.startswith(b"#")))
        self.run_tool("convert", "c.npy", "-o", "e.h5")
        with h5py.File(self.folder / "e.h5") as file:
            self.assertEqual(len(file["CSF1"]), 1001)

    def test_numbers_of_any_kind_keep_their_bits(self):
        odd = [0.0, -0.0, 5e-324, 1.7976931348623157e308, float("nan"), float("inf"), 0.1, 1e23, -123456789.0]
        array = numpy.zeros(len(odd), dtype=[("id", "<f8"), ("it's", "<f8")])
        array["id"], array["it's"] = range(len(odd)), odd
        numpy.save(self.folder / "odd.npy", array)
        self.run_tool("convert", "odd.npy", "-o", "odd.h5")
        self.run_tool("convert", "odd.h5", "-o", "odd.csv")
        self.run_tool("convert", "odd.csv", "-o", "back.npy")
        back = numpy.load(self.folder / "back.npy")
        self.assertEqual([struct.pack("d", x) for x in back["it's"]], [struct.pack("d", x) for x in odd])
        numpy.save(self.folder / "plain.npy", numpy.arange(6.0).reshape(2, 3))
        self.run_tool("convert", "plain.npy", "-o", "plain.csv")
        self.assertEqual((self.folder / "plain.csv").read_text(), "c1,c2,c3\n0,1,2\n3,4,5\n")

    def convert(self, content, name, target):
        (self.folder / name).write_bytes(content)
        self.run_tool("convert", name, "-o", target)
        return self.folder / target

    def test_what_others_write_is_kept(self):
        # An id need not be a whole number, nor a name be without commas and in ASCII.
        array = numpy.zeros(3, dtype=[("id", "<f8"), ("a, b", "<f8"), ("\u00b5", "<f8"), ("#n", "<f8")])
        array["id"] = [0.5, 100000, float("nan")]
        numpy.save(self.folder / "others.npy", array)
        self.run_tool("convert", "others.npy", "-o", "others.csv")
        self.assertEqual((self.folder / "others.csv").read_text(),
                         'id,"a, b",\u00b5,#n\n0.5,0,0,0\n100000,0,0,0\nnan,0,0,0\n'.replace("#n", '"#n"'))
        self.run_tool("convert", "others.csv", "-o", "back.npy")
        back = numpy.load(self.folder / "back.npy")
        self.assertEqual(back.dtype, array.dtype)
        self.assertEqual(back.tobytes(), array.tobytes())
        beyond = numpy.zeros(1, dtype=[("\u03bc", "<f8")])
        numpy.save(self.folder / "beyond.npy", beyond)
        self.run_tool("convert", "beyond.npy", "-o", "beyond.h5")
        with h5py.File(self.folder / "beyond.h5") as file:
            self.assertEqual(list(file), ["\u03bc"])
        # A long name, and an Excel file's first bytes.
        numpy.save(self.folder / "long.npy", numpy.zeros(1, dtype=[("n" * 60000, "<f8")]))
        self.run_tool("convert", "long.npy", "-o", "long.csv")
        self.assertEqual((self.folder / "long.csv").read_text(), "n" * 60000 + "\n0\n")
        self.assertEqual(numpy.load(self.convert(b"\xef\xbb\xbfa,b\r\n1,2\r\n", "bom.csv", "bom.npy")).dtype.names, ("a", "b"))

    def test_whole_numbers_of_hdf5_are_doubles_or_refused(self):
        with h5py.File(self.folder / "whole.h5", "w") as file:
            file["n"] = numpy.array([3, 2**53 - 1])
        self.run_tool("convert", "whole.h5", "-o", "whole.csv")
        self.assertEqual((self.folder / "whole.csv").read_text(), "n\n3\n9007199254740991\n")
        with h5py.File(self.folder / "large.h5", "w") as file:
            file["n"] = numpy.array([3, 2**53 + 1])
        self.assertIn("'n' has whole numbers from 2^53 on", self.run_tool("convert", "large.h5", "-o", "y.csv", code=2))
        with h5py.File(self.folder / "text.h5", "w") as file:
            file["n"] = [b"x"]
        self.assertIn("'n' is not of numbers", self.run_tool("convert", "text.h5", "-o", "y.csv", code=4))

    def test_what_is_no_table_is_refused(self):
        def refused(content, code=4, name="x.csv", target="y.npy"):
            (self.folder / name).write_bytes(content)
            said = self.run_tool("convert", name, "-o", target, code=code)
            self.assertFalse((self.folder / target).exists())
            return said
        self.assertIn("x.csv:3: wanted 2 numbers", refused(b"a,b\n1,2\n3,x\n", code=2))
        self.assertIn("x.csv:2: wanted 2 numbers", refused(b"a,b\n1\n", code=2))
        self.assertIn("two columns are called a", refused(b"a,a\n1,2\n"))
        self.assertIn("has no header", refused(b"# only\n"))
        self.assertIn("wants a name in .csv, .npy or .h5", refused(b"a\n1\n", code=2, target="y.xlsx"))
        self.assertIn("is no .npy file", refused(b"no", name="x.npy", target="y.csv"))
        numpy.save(self.folder / "i.npy", numpy.arange(4))
        self.assertIn("not of doubles", self.run_tool("convert", "i.npy", "-o", "y.csv", code=4))
        whole = b"\x93NUMPY\x01\x00" + struct.pack("<H", 118) + b"{'descr': [('a', '<f8')], 'fortran_order': False, 'shape': (3,), }".ljust(117) + b"\n"
        self.assertIn("has 144 bytes where its head says 152", refused(whole + bytes(16), name="x.npy", target="y.csv"))
        self.assertIn("is no HDF5 file", refused(b"no", name="x.h5", target="y.csv"))
        with h5py.File(self.folder / "u.h5", "w") as file:
            file["a"], file["b"] = numpy.zeros(2), numpy.zeros(3)
        with h5py.File(self.folder / "units.h5", "w") as file:
            file["u"], file["f"] = numpy.zeros(2), numpy.ones(2)
            file["f"].attrs.create("unit", numpy.bytes_("kN"))
        self.run_tool("convert", "units.h5", "-o", "units.csv")
        self.assertEqual((self.folder / "units.csv").read_text(), "# columns: f [kN]\nf,u\n1,0\n1,0\n")
        self.run_tool("convert", "units.csv", "-o", "again.h5")
        with h5py.File(self.folder / "again.h5") as file:
            self.assertEqual(file["f"].attrs["unit"].decode(), "kN")
        self.assertIn("has 3 rows", self.run_tool("convert", "u.h5", "-o", "y.csv", code=4))
        self.assertIn("cannot be", self.run_tool("convert", "nothing.csv", "-o", "y.npy", code=4))

    def test_hdf5_reads_no_other_file_and_no_hostile_name_is_written(self):
        (self.folder / "secret").write_bytes(struct.pack("<2d", 1, 2))
        with h5py.File(self.folder / "external.h5", "w") as file:
            file.create_dataset("x", (2,), "<f8", external=[(str(self.folder / "secret"), 0, 16)])
        with h5py.File(self.folder / "virtual.h5", "w") as file:
            layout = h5py.VirtualLayout((2,), "<f8")
            layout[:] = h5py.VirtualSource("other.h5", "x", (2,))
            file.create_virtual_dataset("x", layout)
        for name in ("external", "virtual"):
            said = self.run_tool("convert", f"{name}.h5", "-o", "y.csv", code=4)
            self.assertIn("the numbers of 'x' are in another file", said)
        # A link is not followed, not even to be looked at: a pipe would be waited for.
        os.mkfifo(self.folder / "pipe.h5")
        with h5py.File(self.folder / "link.h5", "w") as file:
            file["x"] = h5py.ExternalLink("pipe.h5", "/x")
        self.assertIn("'x' is a link", self.run_tool("convert", "link.h5", "-o", "y.csv", code=4))
        with h5py.File(self.folder / "escape.h5", "w") as file:
            file["a\x1b[31m"] = numpy.zeros(2)
        self.assertIn("a control character", self.run_tool("convert", "escape.h5", "-o", "y.csv", code=4))
        self.assertFalse((self.folder / "y.csv").exists())

    def test_hdf5_on_a_full_disk_is_an_error_and_no_file(self):
        before = sorted(self.folder.iterdir())
        for blocks in (8, 40, 100):
            done = subprocess.run(["bash", "-c", 'ulimit -f $1; trap "" XFSZ; exec "$0" run press_fit.yaml --format h5', SLIPBENCH, str(blocks)],
                                  cwd=self.folder, capture_output=True, text=True)
            self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
            self.assertIn("cannot be written", done.stderr)
            self.assertEqual(sorted(self.folder.iterdir()), before)

    def test_starting_the_program_does_not_load_hdf5(self):
        libraries = subprocess.run(["ldd", SLIPBENCH], capture_output=True, text=True, check=True).stdout
        self.assertIn("libyaml-cpp", libraries)
        self.assertNotIn("hdf5", libraries)
        alone = self.folder / "bin" / "slipbench"
        alone.parent.mkdir()
        shutil.copy(SLIPBENCH, alone)
        said = self.run_tool("run", "press_fit.yaml", "--format", "h5", code=4, program=alone)
        self.assertIn("there is no", said)
        self.assertIn("libhdf5-dev", said)
        self.run_tool("run", "press_fit.yaml", "--format", "npy", program=alone)


if __name__ == "__main__":
    unittest.main()
