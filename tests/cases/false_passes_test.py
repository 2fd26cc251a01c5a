# SPDX-License-Identifier: Apache-2.0
"""Suites, references and results of which a part is missing: none of them passes in silence.

usage: false_passes_test.py PROGRAM SOURCE_FOLDER
"""
import json
import os
import re
import unittest
import xml.etree.ElementTree

from in_folder import InFolder, SOURCE

CASE = """slipbench: 1
connector: {type: SLOT}
friction: [{predefined: {}, coefficient: 0.2, stick: {stiffness: 1000}}]
history:
  - {step: pull, duration: 1, increments: 50, motion: {CP1: {to: 0.1}}, force: {f2: 100}}
"""
CHECK = 'checks: [{name: force, quantity: CSF1, %s, tolerance: {absolute: 1.0e-9, why: rounding}}]\n'
RIGHT = CASE + CHECK % 'against: {expression: "= min(1000*CU1, 20)"}'
WRONG = CASE + CHECK % 'against: {expression: "= 7"}'
GOLDEN = CASE + CHECK % "against: {curve: golden.csv}"


class FalsePasses(InFolder):
    def test_a_case_with_a_line_of_a_sweep_is_told(self):
        self.write("suite/right.yaml", RIGHT)
        for tail in ("sweep: {}\n", "sweep: {case: right.yaml}\n", "calibrate : {}\n", "...\nsweep: {}\n", 'title: "\nsweep: {}\n'):
            self.write("suite/wrong.yaml", WRONG + tail)
            self.assertIn("1 not run", self.run_tool("check", "suite", code=2))
        self.write("suite/wrong.yaml", "slipbench: 1\nsweep:\n  case: right.yaml\n  vary: {mu: [0.1]}\n")
        self.assertIn("1 case passed, 0 failed", self.run_tool("check", "suite"))
        for text in ("sweep: {}\n", "slipbench: 1\nparameters: {mu: 1}\nchecks: []\nsweep: {case: right.yaml}\n"):
            self.write("suite/wrong.yaml", text)
            self.assertIn("1 not run", self.run_tool("check", "suite", code=2))

    def test_what_is_left_out_of_a_folder_is_in_every_file(self):
        self.write("suite/right.yaml", RIGHT)
        self.write("shared/wrong.yaml", WRONG)
        (self.folder / "suite/shared").symlink_to(self.folder / "shared")
        said = self.run_tool("check", "suite", "--json", "a.json", "--junit", "a.xml", code=4)
        self.assertIn("suite/shared: error: is a link out of the folder and not searched", said)
        totals = json.loads((self.folder / "a.json").read_text())["totals"]
        self.assertEqual((totals["not_run"], totals["exit_code"]), (1, 4))
        self.assertEqual(xml.etree.ElementTree.parse(self.folder / "a.xml").getroot().get("errors"), "1")
        self.assertIn("is a link out of the folder", self.run_tool("check", "suite", "--filter", "right", code=4))
        self.run_tool("check", "suite", "--allow-outside")
        # Where the target is named too, nothing is left out.
        for paths in (("suite", "shared"), ("shared", "suite"), ("suite", ".")):
            self.assertIn("1 case passed, 1 failed", self.run_tool("check", *paths, code=1))
        (self.folder / "suite/shared").unlink()
        (self.folder / "suite/link.yaml").symlink_to(self.folder / "shared/wrong.yaml")
        for paths in (("suite", "suite/link.yaml"), ("suite/link.yaml", "suite"), ("suite", "shared/wrong.yaml")):
            said = self.run_tool("check", *paths, code=1 if "suite/link.yaml" in paths else 4)
            self.assertIn("1 case passed, 1 failed", said)
        self.write("none.yaml", CASE)
        self.run_tool("check", "none.yaml", "--strict", "--json", "b.json", code=1)
        self.assertEqual(json.loads((self.folder / "b.json").read_text())["totals"]["exit_code"], 1)

    def test_a_name_in_brackets_is_a_name(self):
        for name, text in (("a.yaml", RIGHT), ("[a.yaml]", WRONG), ("[a.yaml,a.yaml]", WRONG), ("[]", WRONG)):
            self.write(name, text)
        self.run_tool("check", "a.yaml")
        for words in (("[a.yaml]",), ("[a.yaml,a.yaml]",), ("a.yaml", "[]")):
            self.run_tool("check", *words, code=1)
        for words in (("--filter", "[a]"), ("--filter=[a]",)):
            self.assertIn("no case matches --filter '[a]'", self.run_tool("check", ".", *words, code=2))
        for words in (("--set", "[mu=0.1,mu=0.2]"), ("--set=[mu=0.1,mu=0.2]",)):
            self.assertIn("[mu", self.run_tool("check", "a.yaml", *words, code=2))

    def test_a_golden_curve_is_that_of_the_whole_run(self):
        self.write("case.yaml", GOLDEN)
        self.run_tool("bless", "case.yaml", "--reason", "looked at")
        golden = (self.folder / "golden.csv").read_text()
        self.assertIn("# rows: 51\n", golden)
        self.assertIn("1 case passed", self.run_tool("check", "case.yaml", "--strict"))
        lines = golden.splitlines(keepends=True)
        row = next(number for number, line in enumerate(lines) if line.startswith("time,")) + 1
        for text in (lines[:row + 3], lines[:row + 20] + lines[row + 21:], lines[:row + 1] + lines[-1:], lines + ["2,0\n"]):
            for mark in ("", "\ufeff"):
                self.write("golden.csv", mark + "".join(text))
                self.assertIn("it is cut off or edited", self.run_tool("check", "case.yaml", code=1))
        # Golden curves of older versions do not say how many rows they have.
        self.write("golden.csv", "".join(line for line in lines[:row + 3] if not line.startswith("# rows")))
        self.assertIn("goes from t = 0 to 0.04, and the rows that are compared from 0 to 1", self.run_tool("check", "case.yaml", code=1))
        self.write("golden.csv", golden)
        more = "  - {step: back, duration: 1, increments: 50, motion: {CP1: {to: -5}}, force: {f2: 100}}\nchecks"
        self.write("case.yaml", GOLDEN.replace("checks", more))
        self.assertIn("and the rows that are compared from 0 to 2", self.run_tool("check", "case.yaml", code=1))
        self.write("case.yaml", GOLDEN.replace("checks", more).replace("name: force", "name: force, step: pull"))
        self.run_tool("check", "case.yaml")

    def test_a_tolerance_or_curve_that_judges_nothing_is_doubted(self):
        self.write("curve.csv", "time,CSF1\n0,0\n0.01,1\n")
        self.write("case.yaml", CASE + CHECK % "against: {curve: curve.csv}")
        self.assertIn("the reference goes from 0 to 0.01 only, and the rows that the check selects from 0 to 1", self.run_tool("check", "case.yaml"))
        self.write("case.yaml", CASE + (CHECK % 'against: {expression: "= -CSF1"}').replace("absolute: 1.0e-9", "relative: 5"))
        self.assertIn("'relative: 5' allows 5 times the reference itself", self.run_tool("check", "case.yaml", "--strict", code=1))

        self.write("case.yaml", CASE + (CHECK % 'against: {expression: "= -5*(1-T)"}').replace("1.0e-9", "1000"))
        self.assertIn("the tolerance of 1e+03 is as large as the reference itself, 5", self.run_tool("check", "case.yaml", "--strict", code=1))
        self.write("curve.csv", "time,CU1,CSF1\n0,0,0\n0.1,0.01,900\n0.2,0.02,900\n1,0.1,900\n")
        far = "criterion: breakaway, abscissa: CU1, against: {curve: curve.csv}"
        self.write("case.yaml", CASE + (CHECK % far).replace("absolute: 1.0e-9", "abscissa: 1e9"))
        self.assertIn("for the position of breakaway is as wide as the reference itself, 0.1", self.run_tool("check", "case.yaml", "--strict", code=1))

    def test_units_that_a_result_states_are_those_of_its_columns(self):
        metres = RIGHT.replace("connector:", "units: {length: m, force: kN, time: s}\nconnector:")
        self.write("a.yaml", metres)
        self.run_tool("run", "a.yaml", "-o", ".")
        head = metres.split("history:")[0].replace("{length: m, force: kN, time: s}", "{length: mm, force: N, time: ms}")
        history = "history: {csv: a.csv, time: t, columns: {CP1: CP1, f2: CRF2}}\n"
        self.write("b.yaml", head + history + CHECK % "against: {curve: a.csv, abscissa: t}")
        said = self.run_tool("run", "b.yaml", "--no-output")
        for words in ("'CP1' is converted from m, as the file says, to mm", "'t' is converted from s", "'CSF1' is converted from kN"):
            self.assertIn(words, said)
        # In the units of the case nothing is said.
        self.write("b.yaml", metres.split("history:")[0] + history + CHECK % "against: {curve: a.csv, abscissa: t}")
        self.assertNotIn("converted", self.run_tool("run", "b.yaml", "--no-output"))

    def test_a_golden_curve_of_other_units_is_converted(self):
        golden = GOLDEN.replace("connector:", "units: {length: mm, force: N, time: s}\nconnector:")
        self.write("case.yaml", golden)
        self.run_tool("bless", "case.yaml", "--reason", "first")
        self.run_tool("check", "case.yaml", "--strict")
        for old, new in (("force: N", "force: kN"), ("time: s", "time: ms")):
            self.write("case.yaml", golden.replace(old, new))
            self.assertIn("as the file says", self.run_tool("run", "case.yaml", "--no-output", code=1))

    def test_verdicts_of_another_run_are_not_shown(self):
        def page(*words):
            said = self.run_tool("report", "out/case.csv", "-o", "page.html", "--force")
            text = (self.folder / "page.html").read_text()
            for word in words:
                self.assertIn(word, text)
            return said, text
        other = "it is of another run than the rows"
        self.write("case.yaml", RIGHT.replace("0.2", "0.5"))
        self.run_tool("run", "case.yaml", "-o", "out", code=1)
        self.assertNotIn(other, page()[1])
        self.write("case.yaml", RIGHT)
        self.run_tool("run", "case.yaml", "-o", "out", "--format", "npy")
        page("case.json is not shown (" + other, "case.events.csv is not shown (" + other)
        # Nor are the regimes of a picture those of the other run's events.
        self.run_tool("plot", "out/case.csv", "--as", "bands", "-o", "bands.svg")
        (self.folder / "out/case.json").unlink()
        (self.folder / "out/case.events.csv").unlink()
        self.run_tool("plot", "out/case.csv", "--as", "bands", "-o", "alone.svg")
        self.assertEqual((self.folder / "bands.svg").read_bytes(), (self.folder / "alone.svg").read_bytes())
        self.run_tool("run", "case.yaml", "-o", "out")
        self.assertNotIn(other, page()[1])

    def test_a_path_or_filter_that_names_no_case_is_told(self):
        self.write("suite/right.yaml", RIGHT)
        (self.folder / "empty").mkdir()
        for words in (("suite", "empty"), ("empty", "suite/right.yaml")):
            self.assertIn("has no case", self.run_tool("check", *words, code=4))
            self.assertIn("has no case", self.run_tool("report", *words, "-o", "page.html", "--force", code=4))
        self.assertIn("no case matches --filter 'other'", self.run_tool("check", "suite", "--filter", "right", "--filter", "other", code=2))

    def test_numbers_that_no_model_makes_are_neither_fitted_nor_collected(self):
        self.write("case.yaml", RIGHT.replace("connector:", "parameters: {mu: 0.2}\nconnector:").replace("coefficient: 0.2", "coefficient: = mu"))
        self.write("ratio.csv", "time,ratio\n0,0.23\n0.5,0.24\n1,0.22\n")
        for compared in ("= mu", "= mu*t"):
            self.write("fit.yaml", 'slipbench: 1\ncalibrate: {experiments: [{name: a, case: case.yaml, data: ratio.csv, time: time, compare: {"%s": {column: ratio}}}], vary: {mu: {bounds: [0, 1]}}}\n' % compared)
            self.assertIn("is the same number whatever the model does", self.run_tool("calibrate", "fit.yaml", code=2))
        self.write("sweep.yaml", 'slipbench: 1\nsweep: {case: case.yaml, samples: 2, sampler: lhs, vary: {mu: {uniform: [0.1, 0.2]}}, collect: {peak: {magnitude: "= 3"}}}\n')
        self.assertIn("is the same number in every sample", self.run_tool("sweep", "sweep.yaml", code=2))

    def test_a_column_of_times_that_no_check_wants_is_not_read(self):
        rows = [f"{0.002 * i},{min(2 * i, 20)}" for i in range(51)]
        check = CHECK % "abscissa: CU1, against: {curve: {file: curve.csv, missing: skip}, abscissa: x, column: F}"
        self.write("case.yaml", CASE + check)
        for time in ("12:00:00", ""):
            self.write("curve.csv", "time,x,F\n" + "".join(f"{time},{row}\n" for row in rows))
            self.assertIn("1 case passed", self.run_tool("check", "case.yaml"))
        # Rows without a time are compared, too.
        self.write("curve.csv", "time,x,F\n" + "".join(f"{'' if i % 2 else 1},{row}{'' if i % 2 == 0 else 7}\n" for i, row in enumerate(rows)))
        self.run_tool("check", "case.yaml", code=1)

    def test_a_result_with_rows_missing_is_none(self):
        self.write("case.yaml", RIGHT)
        self.run_tool("run", "case.yaml", "-o", "out")
        self.assertEqual(json.loads((self.folder / "out/case.json").read_text())["rows"], 51)
        rows = (self.folder / "out/case.csv").read_text()
        lines = rows.splitlines(keepends=True)
        self.assertIn("1 case, 0 failed", self.run_tool("report", "out/case.csv", "-o", "page.html"))
        for text in ("".join(lines[:-9]), "".join(lines[:-9] + lines[-8:]), rows + lines[-1]):
            self.write("out/case.csv", text)
            self.assertIn("and 51 were written with case.json", self.run_tool("report", "out/case.csv", "-o", "page.html", "--force", code=2))
        self.write("out/case.csv", rows[:-3])
        for words in (("report", "out/case.csv", "-o", "page.html"), ("plot", "out/case.csv", "-o", "a.svg"),
                      ("plot", "out/case.csv", "--as", "bands", "-o", "a.svg")):
            self.assertIn("its last line has no end: the result is cut off", self.run_tool(*words, "--force", code=2))
        # An editor's mark and ends of lines change no number.
        for text in ("\ufeff" + rows, rows.replace("\n", "\r\n")):
            (self.folder / "out/case.csv").write_bytes(text.encode())
            said = self.run_tool("report", "out/case.csv", "-o", "page.html", "--force")
            self.assertIn("1 case, 0 failed", said)
            self.assertFalse("it is of another run than the rows" in (self.folder / "page.html").read_text())
        self.run_tool("run", "case.yaml", "-o", "every", "--every", "7")
        self.assertEqual(json.loads((self.folder / "every/case.json").read_text())["rows"], 9)
        self.run_tool("report", "every/case.csv", "-o", "page.html", "--force")

    def test_standard_input_is_not_waited_for_in_a_folder(self):
        self.write("suite/case.yaml", CASE[:CASE.index("history")] + 'history: {csv: "-", time: t, columns: {CP1: x, f2: f}}\n')
        read, write = os.pipe()
        for words in (("check", "suite"), ("report", "suite", "-o", "page.html")):
            self.assertIn("standard input is not read by a case that was found in a folder", self.run_tool(*words, code=2, stdin=read))
        os.write(write, b"t,x,f\n0,0,100\n1,0.1,100\n")
        os.close(write)
        self.run_tool("check", "suite/case.yaml", stdin=read)
        os.close(read)

    def test_messages_in_files_are_as_printable_as_those_on_a_terminal(self):
        self.write("suite/case.yaml", RIGHT.replace("stiffness: 1000", '"stick\\x9b2J\\u202e": 1'))
        self.write("suite/c.yaml", "# \u202e\x85\n" + RIGHT)
        self.write("suite/b\u202e.yaml", RIGHT)
        self.run_tool("check", "suite", "--json", "a.json", "--junit", "a.xml", "--report", "a.html", code=2)
        document = json.loads((self.folder / "a.json").read_text())
        shown = [text for one in document["cases"] for text in (one["case"], one.get("message", ""))]
        for text in (*shown, (self.folder / "a.xml").read_text(), (self.folder / "a.html").read_text()):
            self.assertFalse({"\u202e", "\x9b", "\x85", "\x1b"} & set(text))
        # In the data of the page they would be escaped; the text of the case has such words itself.
        self.assertIsNone(re.search(r"(?i)(?<!\\)\\u(202e|009b|0085|001b)", (self.folder / "a.html").read_text()))

    def test_rows_of_a_sweep_that_were_edited_are_not_merged(self):
        for name in ("slot.yaml", "slot_sweep.yaml"):
            self.write(name, (SOURCE / "cases/sweeps" / name).read_text())
        for part in ("1/2", "2/2"):
            self.run_tool("sweep", "slot_sweep.yaml", "--part", part, "-o", "out")
        part = next((self.folder / "out").glob("*.1of2.csv"))
        lines = part.read_text().splitlines()
        fields = lines[-1].split(",")
        part.write_text("\n".join([*lines[:-1], ",".join([fields[0], "0.555", *fields[2:]])]) + "\n")
        self.assertIn("has other values than the sweep gives it", self.run_tool("merge", "slot_sweep.yaml", "-o", "out", code=4))


if __name__ == "__main__":
    unittest.main(verbosity=1)
