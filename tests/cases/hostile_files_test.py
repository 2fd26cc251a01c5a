# SPDX-License-Identifier: Apache-2.0
"""Names, links and decks that somebody made to do harm, and --force on files that a command has read.

usage: hostile_files_test.py PROGRAM SOURCE_FOLDER
"""
import ctypes
import os
import re
import resource
import shutil
import subprocess
import time
import unittest

from in_folder import InFolder, PROGRAM, SECONDS, SOURCE

SLIDER = """slipbench: 1
title: {title}
connector: {{type: SLOT}}
friction: [{{predefined: {{}}, coefficient: 0.2, stick: {{stiffness: 1000}}}}]
history:
{history}"""
STEP = '  - {{step: {name}, duration: 1, increments: 10, motion: {{CP1: {{to: 0.1}}}}, force: {{f2: 100}}}}\n'
MEASURED = "  csv: data.csv\n  time: t\n  columns: {CP1: x, f2: f}\n"


SLOT = """*NODE
1, 0., 0., 0.
2, 7., 0., 0.
*ELEMENT, TYPE=CONN3D2, ELSET=PIN
1, 1, 2
*CONNECTOR SECTION, ELSET=PIN, BEHAVIOR=B
SLOT
*CONNECTOR BEHAVIOR, NAME=B
*CONNECTOR FRICTION, PREDEFINED
150.
*FRICTION, ELASTIC SLIP=0.002
0.2
*AMPLITUDE, NAME=A, DEFINITION=EQUALLY SPACED, FIXED INTERVAL=1.
0., 1., 0., 1., 0.
*STEP
*STATIC, DIRECT
0.02, 4.
*CONNECTOR MOTION, AMPLITUDE=A
PIN, 1, 0.4
*CHANGE FRICTION, ELSET=PIN
*FRICTION
0.5
*END STEP
"""


class HostileFiles(InFolder):
    def slider(self, name="case.yaml", title="Slider", step="pull"):
        self.write(name, SLIDER.format(title=title, history=STEP.format(name=step)))

    def keeps(self, kept, *words, stdin=None):
        """The command ends with 4 for a file that it has read, which stays as it is."""
        before = (self.folder / kept).read_bytes()
        said = self.run_tool(*words, "--force", code=4, stdin=stdin)
        self.assertIn("is an input", said)
        self.assertEqual((self.folder / kept).read_bytes(), before)

    def test_force_replaces_nothing_that_was_read(self):
        self.write("data.csv", "t,x,f\n0,0,100\n1,0.1,100\n")
        self.write("measured.yaml", SLIDER.format(title="M", history=MEASURED))
        self.run_tool("run", "measured.yaml", "-o", "out")
        for to in ("table", "numbers", "abaqus"):
            self.keeps("data.csv", "export", "measured.yaml", "--to", to, "-o", "data.csv")
        (self.folder / "picture.svg").symlink_to("data.csv")
        self.keeps("data.csv", "plot", "measured.yaml", "-o", "picture.svg")
        self.keeps("data.csv", "run", "measured.yaml", "-o", self.linked("data.csv", "out2/measured.csv"))
        self.slider()
        with open(self.folder / "case.yaml") as text:
            self.keeps("case.yaml", "check", "-", "--json", "case.yaml", stdin=text)
        with open(self.folder / "case.yaml") as text:
            self.keeps("case.yaml", "export", "-", "--to", "abaqus", "-o", "case.yaml", stdin=text)

    def linked(self, kept, name):
        """Gives a file another name; returns that one's folder."""
        (self.folder / name).parent.mkdir()
        os.link(self.folder / kept, self.folder / name)
        return (self.folder / name).parent

    def test_a_journal_or_tally_takes_the_place_of_no_input(self):
        for name in ("press_fit.yaml", "press_fit_sweep.yaml"):
            shutil.copy(SOURCE / "cases/sweeps" / name, self.folder)
        for kept in ("press_fit.yaml", "press_fit_sweep.yaml"):
            for way, link in (("hard", os.link), ("soft", os.symlink)):
                for ending, words in ((".journal", ()), (".tally", ("--no-rows",))):
                    out = self.folder / f"{kept}.{way}{ending}"
                    out.mkdir()
                    link(self.folder / kept, out / f"press_fit_sweep{ending}")
                    self.keeps(kept, "sweep", "press_fit_sweep.yaml", "-o", out, *words)

    def test_a_deck_and_what_it_includes_stay(self):
        head, steps = SLOT.split("*STEP")
        self.write("head.inc", head)
        self.write("slot.inp", "*INCLUDE, INPUT=head.inc\n*STEP" + steps)
        self.run_tool("import", "slot.inp", "-o", "slot.yaml")
        for kept in ("slot.inp", "head.inc"):
            self.keeps(kept, "import", "slot.inp", "-o", kept)

    def test_a_deck_with_a_part_that_means_nothing_is_refused(self):
        self.write("slot.inp", SLOT)
        self.run_tool("import", "slot.inp", "-o", "slot.yaml")
        for old, new, words in (("0.02, 4.", "0.02, -4.", "times of 0 or more"), ("2, 7., 0., 0.", "2, abc, 0., 0.", "abc"), ("2, 7., 0., 0.", "2, 1e400, 0., 0.", "1e400"),
                                ("*CHANGE FRICTION, ELSET=PIN", "*CHANGE FRICTION, ELSET=PINN", "no element set"),
                                ("SLOT\n", "SLOT\n*CONNECTOR SECTION, ELSET=PIN, BEHAVIOR=B\nSLOT\n", "its elements have that of slot.inp:6 as well"),
                                ("SLOT\n", "SLOT\n*ELSET, ELSET=ALL\nPIN\n*CONNECTOR SECTION, ELSET=ALL, BEHAVIOR=B\nSLOT\n", "element 1 has that of slot.inp:"), ("*CHANGE FRICTION, ELSET=PIN", "*CHANGE FRICTION", "ELSET"),
                                ("INTERVAL=1.", "INTERVAL=abc", "FIXED INTERVAL"), ("INTERVAL=1.", "INTERVAL=-1.", "FIXED INTERVAL"), (", FIXED INTERVAL=1.", "", "FIXED INTERVAL"),
                                ("PIN, 1, 0.4", "PINN, 1, 0.4", "no element set"), ("SLIP=0.002", "SLIP=0", "above 0"),
                                ("*AMPLITUDE, NAME=A", "*AMPLITUDE, NAME=A\n0., 0., 9., 1.\n*AMPLITUDE, NAME=A", "has the name of the one in"),
                                ("*NODE", "*PARAMETER\na = 1\na = 2\n*NODE", "stated twice")):
            self.assertEqual(SLOT.count(old), 1, old)
            self.write("slot.inp", SLOT.replace(old, new))
            self.assertIn(words, self.run_tool("import", "slot.inp", "-o", "slot.yaml", "--force", code=2))

    def test_sets_of_sets_are_read_at_any_depth(self):
        depth = 20000
        chain = [f"*ELSET, ELSET=S{i}\nS{i + 1}\n" for i in range(depth)] + [f"*ELSET, ELSET=S{depth}\n1\n"]
        for sets in (chain, chain[::-1]):
            deck = SLOT.replace("ELSET=PIN, BEHAVIOR", "ELSET=S0, BEHAVIOR").replace("*CONNECTOR SECTION", "".join(sets) + "*CONNECTOR SECTION")
            self.write("slot.inp", deck)
            self.assertIn("CP1", self.run_tool("import", "slot.inp"))

    def test_names_with_control_characters_are_refused(self):
        for name in ("a\n::error::x.yaml", "a\x1b[31m.yaml", "a\u202e.yaml", "a\u061c.yaml", "a\u009b.yaml"):
            self.slider(name)
            for words in (("run", name), ("check", name), ("plot", name, "-o", "x.svg"), ("report", name, "-o", "x.html"),
                          ("run", "case.yaml", "-o", name)):
                said = self.run_tool(*words, code=2)
                self.assertIn("holds control characters", said)
                self.assertNotIn("\n::error", said)
                self.assertFalse(set("\x1b\u202e\u061c\u009b") & set(said), said)
        # In a folder they are found without being named.
        said = self.run_tool("check", ".")
        self.assertFalse(set("\x1b\u202e\u061c\u009b") & set(said), said)

    def test_what_a_message_quotes_of_a_file_cannot_reach_the_terminal(self):
        self.write("c.csv", "# columns: t [s], CP1 [m\x1b[2JX], CSF1 [N\u202e]\nt,CP1,CSF1\n0,0,1\n1,1,2\n")
        said = self.run_tool("plot", "c.csv", "--y", "CP1", "--y", "CSF1", "-o", "c.svg", code=2)
        self.assertIn("CP1", said)
        self.assertFalse(set("\x1b\u202e") & set(said), said)

    def test_a_sweep_script_has_no_line_of_its_file_name(self):
        for name in ("a'b $(touch ran).yaml", "--wrap=x.yaml"):
            text = (SOURCE / "cases/sweeps/press_fit_sweep.yaml").read_text()
            shutil.copy(SOURCE / "cases/sweeps/press_fit.yaml", self.folder)
            self.write(name, text)
            self.run_tool("sweep", f"./{name}", "-o", "out", "--emit", "slurm", "--rate", "1000")
            script = next((self.folder / "out").glob("*.slurm"))
            jobs = re.findall(r"(?m)^#SBATCH --job-name=(.*)$", script.read_text())
            self.assertEqual(len(jobs), 1)
            self.assertRegex(jobs[0], r"^\w+$")
            script.unlink()
        for rate in ("nan", "inf", "0", "-1", "1e-300"):
            self.assertIn("wanted a number from", self.run_tool("sweep", f"./{name}", "-o", "out", "--emit", "slurm", "--rate", rate, code=2))

    def test_a_title_is_no_keyword_of_a_deck(self):
        for title in ("*INCLUDE, INPUT=evil.inp", "  *EL FILE", "#include /etc/passwd", "/MAT/LAW1", "$ x"):
            self.slider(title=f'"{title}"', step="'x\", INC=5, NAME=\"y'")
            for to in ("abaqus", "radioss", "lsdyna", "opensees"):
                self.run_tool("export", "case.yaml", "--to", to, "-o", f"deck.{to}", "--force")
                lines = (self.folder / f"deck.{to}").read_text().splitlines()
                self.assertFalse([line for line in lines if line.strip() == title.strip()], to)
            steps = [line for line in (self.folder / "deck.abaqus").read_text().splitlines() if line.startswith("*STEP")]
            self.assertEqual(steps[0].count('"'), 2, steps)

    def test_files_that_include_the_next_one_twice_are_refused_in_time(self):
        for dialect, line, ending, begin in (("abaqus", "*INCLUDE, INPUT={}.inc\n", ".inp", "*HEADING\n"), ("radioss", "#include {}.inc\n", "_0000.rad", "#RADIOSS STARTER\n"),
                                             ("lsdyna", "*INCLUDE\n{}.inc\n", ".k", "*KEYWORD\n")):
            for i in range(40):
                self.write(f"{dialect}/{i}.inc", 2 * line.format(i + 1))
            self.write(f"{dialect}/40.inc", "")
            self.write(f"{dialect}/top{ending}", begin + line.format(0))
            start = time.monotonic()
            said = self.run_tool("import", f"{dialect}/top{ending}", code=2)
            self.assertLess(time.monotonic() - start, SECONDS)
            self.assertRegex(said, "included more than once are more than 16 MiB|include each other")

    def refused_in_time(self, text, words, code=2, command=("run", "{}", "--no-output"), longest=20000):
        self.write("case.yaml", text)
        start = time.monotonic()
        said = self.run_tool(*(word.format("case.yaml") for word in command), code=code)
        self.assertLess(time.monotonic() - start, SECONDS)
        self.assertIn(words, said)
        self.assertLess(len(said), longest)

    def test_much_of_one_thing_is_refused_in_time(self):
        case = SLIDER.format(title="Much", history=STEP.format(name="a"))
        for formula in ("= q{}", "= p{1}", "=1"):
            parameters = "".join(f"  p{i}: {formula.format(i, (i + 1) % 60000)}\n" for i in range(60000))
            self.refused_in_time(case + "parameters:\n" + parameters, "parameters: 60000 items, at most 2000 are read")
        columns = ", ".join(f"CP{i}" for i in range(10, 100000))
        self.refused_in_time(case + f"output: {{columns: [{columns}]}}\n", "no result column 'CP10'")
        steps = "".join(f"  - {{step: s{i}, increments: 1}}\n" for i in range(10000))
        checks = "".join(f"  - {{name: c{i}, quantity: CSF1, step: z{i}, against: {{expression: '= 20'}}, tolerance: {{absolute: 1, why: a}}}}\n" for i in range(5000))
        self.refused_in_time(case + steps + "checks:\n" + checks, "checks: 5000 items, at most 1000 are read")
        self.refused_in_time(case + steps + "checks:\n" + "".join(checks.splitlines(True)[:1000]), "no step 'z0'")
        rings = case.replace("{type: SLOT}", "{type: SLIPRING, wrap_angle: [" + "0.1, " * 20000 + "0.1]}")
        self.refused_in_time(rings, "a belt has at most 100 rings")

    def test_much_of_one_thing_in_a_sweep_or_a_fit_is_refused_in_time(self):
        self.slider("one.yaml")
        parameters = "".join(f"  parameter_number_{i}: {i}\n" for i in range(1900))
        self.write("many.yaml", SLIDER.format(title="Many", history=STEP.format(name="a")) + "parameters:\n" + parameters)
        self.write("faulty.yaml", SLIDER.format(title="Faulty", history=STEP.format(name="a")) + "".join(f"key_{i}: 1\n" for i in range(20000)))
        unknown = [f"parametre_numbr_{i}" for i in range(40000)]
        self.write("drawn.csv", ",".join(unknown) + "\n" + ",".join("1" for _ in unknown) + "\n")
        self.write("fewer.csv", ",".join(unknown[:9000]) + "\n" + ",".join("1" for _ in unknown[:9000]) + "\n")
        sweep = "slipbench: 1\nsweep: {{case: many.yaml, samples: 4, {}, collect: {{{}}}}}\n"
        vary = "vary: {{{}}}"
        for count, words in ((2000, "no parameter 'parametre_numbr_0'"), (20000, "sweep.vary: 20000 items, at most 2000 are read")):
            varied = vary.format(", ".join(f"{name}: {{uniform: [0, 1]}}" for name in unknown[:count]))
            self.refused_in_time(sweep.format(varied, "a: {max: CSF1}"), words, command=("sweep", "{}", "--no-output"))
        for file, words in (("drawn.csv", "the file has more than 10000 columns"), ("fewer.csv", "no parameter 'parametre_numbr_0'")):
            drawn = sweep.format(f"csv: {file}", "a: {max: CSF1}").replace("samples: 4, ", "")
            self.refused_in_time(drawn, words, command=("sweep", "{}", "--no-output"))
        collected = ", ".join(f"a{i}: {{max: CSF1*{i}}}" for i in range(30000))
        self.refused_in_time(sweep.format(vary.format("parameter_number_1: {uniform: [0, 1]}"), collected), "at most 1000 are read",
                             command=("sweep", "{}", "--no-output"))

        self.write("rig.csv", "t,F\n0,0\n1,1\n2,0\n")
        fit = "slipbench: 1\ncalibrate:\n  vary: {{{}}}\n  experiments:\n{}"
        experiment = "    - {{case: {}, data: rig.csv, time: t, compare: {{{}}}{}}}\n"
        one = experiment.format("many.yaml", "CSF1: {column: F, sigma: 1}", "")
        varied = ", ".join(f"{name}: {{bounds: [0, 1]}}" for name in unknown[:200])
        settings = ", set: {" + ", ".join(f"{name}: 1" for name in unknown[:2000]) + "}"
        table = ", ".join(f"[0.2, {i}]" for i in range(20000))
        self.write("table.yaml", SLIDER.format(title="T", history=STEP.format(name="a")).replace("coefficient: 0.2", f"coefficient: {{columns: [mu, slip_rate], rows: [{table}]}}"))
        of_table = fit.replace("vary: {{{}}}", "tables: {{friction1.coefficient: {{bounds: [0, 1]}}}}")
        compared = [f'"= CSF1 + {i}": {{column: F, sigma: 1}}' for i in range(10000)]
        known = "parameter_number_1: {bounds: [0, 9]}"
        for text, words in (
                (fit.format(varied, one * 50), "no case has a parameter 'parametre_numbr_0'"),
                (fit.format(known, one * 1000), "have 100700 parameters in all, at most 100000 are read"),
                (of_table.format(experiment.format("table.yaml", "CSF1: F", "")), "have 20000 rows, at most 500 are fitted"),
                (fit.format(known, experiment.format("many.yaml", "CSF1: F", settings)), "many.yaml has no parameter 'parametre_numbr_0'"),
                (fit.format(known, experiment.format("faulty.yaml", "CSF1: F", "") * 500), "unknown key"),
                (fit.format(known, experiment.format("one.yaml", ", ".join(compared), "")), "compare: 10000 items, at most 100 are read"),
                (fit.format(known, experiment.format("one.yaml", ", ".join(compared[:100]), "") * 100), "have 2100 columns to compare, at most 2000 are read")):
            self.refused_in_time(text, words, command=("calibrate", "{}", "-o", "fitted"))
            self.assertFalse((self.folder / "fitted").exists())

    def test_what_is_named_again_and_again_is_bounded(self):
        case = SLIDER.format(title="Again", history=STEP.format(name="a"))
        check = "  - {{name: c{0}, quantity: CSF1, against: {{expression: {1}}}, tolerance: {{absolute: 1, why: {2}}}}}\n"
        long = "= 1" + "+t" * 4900
        words = "characters of long texts"
        self.refused_in_time(case + "checks:\n" + check.format(0, f'&e "{long}"', "a") + "".join(check.format(i, "*e", "a") for i in range(1, 900)), words)
        self.refused_in_time(case + "checks:\n" + check.format(0, "'= 20'", "&w " + "why " * 50000) + "".join(check.format(i, "'= 20'", "*w") for i in range(1, 400)), words)
        # As many characters of numbers are a table.
        numbers = "x: &x [" + "0.123456, " * 9000 + "1]"
        self.refused_in_time(case + f"parameters: {{{numbers}, " + ", ".join(f"x{i}: *x" for i in range(9)) + "}\n", "wanted a number")
        self.write("rows.csv", "mu,slip_rate\n" + "".join(f"0.2,{i}\n" for i in range(50000)))
        change = "change_friction: {friction1: {coefficient: {columns: [mu, slip_rate], csv: rows.csv}}}, "
        steps = "".join(STEP.format(name=f"s{i}").replace("motion", change + "motion") for i in range(60))
        self.refused_in_time(SLIDER.format(title="Tables", history=steps), "the tables of this case have more than 2000000 rows from files")
        self.slider("given.yaml")
        parameters = ", ".join(f"p{i}: {i}" for i in range(400))
        self.write("given.yaml", (self.folder / "given.yaml").read_text() + f"parameters: {{{parameters}}}\n")
        vary = ", ".join(f"p{i}: {{uniform: [0, 1]}}" for i in range(400))
        collect = ", ".join(f"c{i}: {{max: CSF1}}" for i in range(400))
        self.refused_in_time(f"slipbench: 1\nsweep: {{case: given.yaml, samples: 2, sampler: lhs, vary: {{{vary}}}, collect: {{{collect}}}}}\n",
                             "400 varied parameters and 400 collected numbers have more than 100000 correlations", command=("sweep", "{}", "--no-output"))

    def test_no_step_of_a_case_takes_a_walk_through_all_that_stands_before_it(self):
        wear = ", ".join(f"[{9 + i % 2}, {i}]" for i in range(40000))
        changes = "".join(f"  - {{step: s{i}, increments: 1, change_friction: {{friction1: {{coefficient: 0.3}}}}}}\n" for i in range(16000))
        worn = SLIDER.format(title="Worn", history=STEP.format(name="a") + changes).replace(
            "predefined: {}", f"component: 1, internal_contact_force: {{columns: [F, accumulated_slip], rows: [{wear}]}}")
        for method in ("backward_euler", "exact"):
            self.refused_in_time(worn.replace("history:", f"integration: {{method: {method}}}\nhistory:"), "16010 increments", code=0)
        # Beside a definition with a long table of its own.
        other = "  - {name: friction2, component: 4, internal_contact_force: 9, coefficient: {columns: [mu, slip_rate], rows: ["
        two = SLIDER.format(title="Two", history=STEP.format(name="a") + changes).replace("type: SLOT", "type: CYLINDRICAL").replace(
            "friction: [{predefined: {}", "friction:\n  - {name: friction1, component: 1, internal_contact_force: 9").replace(
            "1000}}]", "1000}}\n" + other + ", ".join(f"[0.3, {i}]" for i in range(40000)) + "]}, stick: {stiffness: 1000}}")
        self.refused_in_time(two, "16010 increments", code=0)
        # Each looks for the places of its nodes behind all the steps before.
        fields = ", ".join(f"field{i}: 0" for i in range(1, 17))
        moved = "".join(f"  - {{step: s{i}, increments: 1, fields: {'&f {' + fields + '}' if i == 0 else '*f'}, nodes: {'&n {a: [5, 5, 5], b: [5, 5, 5], c: [5, 5, 5]}' if i == 0 else '*n'}}}\n" for i in range(10000))
        nodes = SLIDER.format(title="Nodes", history="  - {step: a, increments: 1, force: {f1: 100}}\n" + moved).replace("{type: SLOT}", "{type: SLIPRING, nodes: {a: [0, 0, 0], b: [1, 0, 0], c: [1, 1, 0]}}")
        self.refused_in_time(nodes, "node a is at 0 there", longest=2000000)

    def test_keys_below_long_ones_are_read_in_time(self):
        # Behind keys of 60 kB in all, those that are sound and those that are not.
        for key, words in (("a{}", "missing key 'connector'"), ("[a{}]", "a list cannot be a key")):
            inner = ", ".join(key.format(i) + ": 1" for i in range(250000))
            self.refused_in_time("slipbench: 1\nx: " + ("{" + "k" * 1000 + ": ") * 60 + "{" + inner + "}" * 61 + "\n", words, longest=2000000)

    def test_long_formulas_are_compiled_in_time(self):
        formula = "= 100" + "+0*t" * 2400
        self.write("case.yaml", SLIDER.format(title="Formulas", history="".join(STEP.format(name=f"s{i}").replace("100}", f'"{formula}"}}') for i in range(20))))
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        self.run_tool("run", "case.yaml", "--no-output")
        # A second or so; some 12 s where the time grows with the square of the length.
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, 6 * SECONDS / 20)

    def test_a_table_that_is_a_grid_already_is_exported_whatever_its_size(self):
        rows = "".join(f"{0.1 + 0.0001 * i + 0.00001 * j},{i},{100 * j}\n" for j in range(1, 181) for i in range(200))
        self.write("grid.csv", "mu,slip_rate,contact_force\n" + rows)
        case = SLIDER.format(title="Grid", history=STEP.format(name="a")).replace("coefficient: 0.2", "coefficient: {columns: [mu, slip_rate, contact_force], csv: grid.csv}")
        self.write("case.yaml", case)
        self.run_tool("export", "case.yaml", "--to", "table", "-o", "table.csv")
        ragged = "".join(f"0.2,{i + 0.001 * j},{100 * j}\n" for j in range(1, 181) for i in range(3))
        self.write("grid.csv", "mu,slip_rate,contact_force\n" + ragged)
        self.assertIn("too many slip rates and contact forces for a grid", self.run_tool("export", "case.yaml", "--to", "table", "-o", "b.csv", code=2))

    def test_what_makes_no_table_is_not_exported(self):
        self.write("case.yaml", "slipbench: 1\nconnector: {type: SLOT}\nfriction:\n  - {component: 1, contact_force: 2, coefficient: {exponential_decay: {static: 0.25, kinetic: 0.1, decay: 1}}}\n"
                   "history:\n  - {step: a, duration: 1e-309, increments: 10, force: {f2: 100}, motion: {CP1: {to: 1}}}\n")
        self.assertIn("its coefficient makes no table", self.run_tool("export", "case.yaml", "--to", "table", code=2))

    def test_a_sweep_or_a_fit_opens_no_case_outside_its_folder(self):
        self.slider("case.yaml")
        texts = {"sweep": "slipbench: 1\nsweep: {{case: {}, vary: {{x: {{uniform: [0, 1]}}}}, samples: 4, collect: {{a: {{max: CSF1}}}}}}\n",
                 "calibrate": "slipbench: 1\ncalibrate: {{vary: {{x: {{}}}}, experiments: [{{case: {}, data: rig.csv, time: t, compare: {{CSF1: F}}}}]}}\n"}
        libc = ctypes.CDLL(None)
        opened = libc.inotify_init1(os.O_NONBLOCK)
        self.addCleanup(os.close, opened)
        in_open = 0x20
        self.assertGreaterEqual(libc.inotify_add_watch(opened, str(self.folder / "case.yaml").encode(), in_open), 0)
        (self.folder / "case.yaml").read_text()
        self.assertTrue(os.read(opened, 4096), "the watch tells of an opening")
        self.write("in/rig.csv", "t,F\n0,0\n1,1\n")
        for command, text in texts.items():
            for named, words in ((f"{self.folder}/case.yaml", "absolute"), ("../case.yaml", "'..'"), ("'-'", "standard input cannot be a case here")):
                self.write(f"in/{command}.yaml", text.format(named))
                self.assertIn(words, self.run_tool(command, f"in/{command}.yaml", code=2, stdin=subprocess.DEVNULL))
                self.assertRaises(BlockingIOError, os.read, opened, 4096)

    def test_no_command_waits_for_a_pipe(self):
        self.slider("case.yaml")
        self.write("case.yaml", (self.folder / "case.yaml").read_text() + "parameters: {x: 1}\n")
        self.write("sweep.yaml", "slipbench: 1\nsweep: {case: case.yaml, vary: {x: {uniform: [0, 1]}}, samples: 4, collect: {a: {max: CSF1}}}\n")
        self.run_tool("run", "case.yaml", "-o", "out")
        (self.folder / "out" / "case.events.csv").unlink()
        for name in ("sweep.1of1.csv", "sweep.1of1.tally", "sweep.journal", "deck.k", "out/case.events.csv", "rows.csv", "rows.npy"):
            os.mkfifo(self.folder / name)
        for code, *words in ((2, "merge", "sweep.yaml", "sweep.1of1.csv"), (2, "merge", "sweep.yaml", "sweep.1of1.tally"), (2, "merge", "sweep.yaml", "sweep.journal"),
                             (4, "sweep", "sweep.yaml"), (4, "import", "deck.k"), (4, "plot", "rows.csv", "-o", "a.svg"), (4, "convert", "rows.csv", "-o", "a.npy"),
                             (4, "convert", "rows.npy", "-o", "a.csv")):
            self.assertRegex(self.run_tool(*words, code=code), "is no regular file|is not a regular file|is a pipe, not a file", words)
        self.run_tool("plot", "out/case.csv", "-o", "a.svg")
        self.run_tool("report", "out/case.csv", "-o", "a.html")

    def test_scripts_and_decks_of_many_names_are_read_in_time(self):
        models = "frictionModel Coulomb 1 0.1\n"
        python = "import openseespy.opensees as ops\nops.frictionModel('Coulomb', 1, 0.1)\n"
        node = "*NODE\n1, 0., 0., 0.\n2, 7., 0., 0.\n"
        for name, text, words in (
                ("names.tcl", models + "".join(f"set a{i} 1\n" for i in range(25000)) + "".join(f"proc p{i} {{}} {{}}\n" for i in range(25000)), "Coulomb 1"),
                ("names.py", python + "".join(f"a{i} = 1\n" for i in range(20000)) + "".join(f"def f{i}(): pass\n" for i in range(20000)), "Coulomb 1"),
                ("sum.tcl", models + "set mu [expr {1" + "+1" * 300000 + "}]\n" + "".join(f"frictionModel Coulomb {i} $mu\n" for i in range(2, 5000)), "Coulomb 1"),
                ("calls.tcl", models + "set mu [expr {" + "[expr 1]+" * 60000 + "1}]\n" , "Coulomb 1"),
                ("sum.py", python + "mu = 1" + "+1" * 300000 + "\n" + "".join(f"ops.frictionModel('Coulomb', {i}, mu)\n" for i in range(2, 5000)), "Coulomb 1"),
                ("sum.k", "*KEYWORD\n*PARAMETER_EXPRESSION\nR mu      1" + "+1" * 300000 + "\n*DEFINE_FRICTION\n         1       0.2\n", "more than 10000 characters"),
                ("models.tcl", "".join(f"frictionModel Coulomb {i} 0.1\n" for i in range(33000)), "33000 friction models"),
                ("tables.tcl", "".join(f"frictionModel VelPressureDep {i} 0.04 0.085 7.0e4 0.02 0.05 0.025\n" for i in range(14000)),
                 "at most 2000 models of tables are read"),
                ("sets.inp", node + "*ELEMENT, TYPE=CONN3D2\n" + "".join(f"{i},1,2\n" for i in range(1, 6000)) +
                 "".join(f"*ELSET, ELSET=E{i}, GENERATE\n{i},{i}\n*CONNECTOR BEHAVIOR, NAME=B{i}\n*CONNECTOR SECTION, ELSET=E{i}, BEHAVIOR=B{i}\nSLOT\n"
                         for i in range(1, 6000)), '"B5999", element 5999 of E5999')):
            self.write(name, text)
            start = time.monotonic()
            said = subprocess.run([PROGRAM, "import", name], cwd=self.folder, capture_output=True, text=True)
            self.assertLess(time.monotonic() - start, SECONDS, name)
            self.assertIn(words, said.stdout + said.stderr)

    def test_what_a_deck_makes_of_few_lines_stays_within_bounds(self):
        head, tail = SLOT.split("*STEP\n")
        step = "*STEP\n*STATIC, DIRECT\n0.02, 4.\n*CONNECTOR MOTION, AMPLITUDE=L, TYPE=VELOCITY\nPIN, 1, 0.4\n*END STEP\n"
        long, longer = ("*AMPLITUDE, NAME=L\n" + "".join(f"{4*i/count}, {i % 3}.\n" for i in range(count)) for count in (4000, 8000))
        smooth = "*AMPLITUDE, NAME=L, DEFINITION=SMOOTH STEP\n" + "".join(f"{i*0.001}, {i % 3}.\n" for i in range(20000))
        # The same amplitude again in every step; and one whose formula would be as long as all its points.
        for amplitude, steps, code, words in ((long, step * 3000, 2, "its history takes more than 4 MiB up to"),
                                              (longer, step, 0, "more points than are taken over"),
                                              (smooth, step.replace(", TYPE=VELOCITY", ""), 0, "is not taken over")):
            self.write("slot.inp", head + amplitude + steps)
            start = time.monotonic()
            said = self.run_tool("import", "slot.inp", "-o", "long.yaml", "--force", code=code)
            self.assertLess(time.monotonic() - start, SECONDS)
            self.assertIn(words, said + ((self.folder / "long.yaml").read_text() if code == 0 else ""))

    def in_bounds(self, files, *words, code=0, said=""):
        """A command of little time and memory, on these files."""
        for name, text in files.items():
            self.write(name, text)
        start = time.monotonic()
        done = subprocess.Popen([PROGRAM, *words], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        output = done.stdout.read()
        done.stdout.close()
        _, status, used = os.wait4(done.pid, 0)
        done.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(done.returncode, code, output[:2000])
        self.assertLess(time.monotonic() - start, SECONDS)
        self.assertLess(used.ru_maxrss, 400_000 * SECONDS // 20, words)
        self.assertIn(said, output)

    def test_a_deck_whose_contacts_name_one_table_stays_within_bounds(self):
        def card(*fields):
            return "".join(f"{field:>10}" for field in fields) + "\n"
        contact = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n{}" + card(1, 2, 3, 3) + "{}" + card(0.0)
        curve = "*DEFINE_TABLE_2D\n" + card(11) + "".join(f"{i},9\n" for i in range(5000)) + "*DEFINE_CURVE\n" + card(9) + "".join(f"{i},0.4\n" for i in range(5000))
        self.in_bounds({"d.k": "*KEYWORD\n" + contact.format(card(1), card(2.0, 11.0)) + curve}, "import", "d.k", "-o", "o.yaml", code=2, said="has more than 100000 records of part pairs and rows of tables")
        pairs = "*DEFINE_FRICTION\n" + card(7, 0.2) + "".join(card(i, i + 1, 0.3) for i in range(1, 2001))
        contacts = "*KEYWORD\n" + "".join(contact.format(card(i), card(-2.0, 7.0)) for i in range(1, 1001)) + pairs
        self.in_bounds({"d.k": contacts}, "import", "d.k", code=2, said="--interface takes one contact alone")
        self.in_bounds({}, "import", "d.k", "--interface", "999", "-o", "one.yaml")
        self.in_bounds({}, "import", "d.k", "--all", "-o", "all", code=2, said="has more than 100000 records")
        deck = (SOURCE / "tests/decks/radioss/type7_points_at_friction_0000.rad").read_text()
        head, interface = deck.split("/INTER/TYPE7/6\n")
        interface, frictions = interface.split("/FRICTION/21\n")
        record = "         1         2\n" + "".join(frictions.splitlines(keepends=True)[2:4])
        lining = "".join(frictions.splitlines(keepends=True)[:4]) + record * 1000 + "/END\n"
        many = head + "".join(f"/INTER/TYPE7/{i}\n{interface}" for i in range(1, 501)) + "/FRICTION/21\n" + lining
        self.in_bounds({"d_0000.rad": many}, "import", "d_0000.rad", "--all", "-o", "rad", code=2, said="more than 100000 records of part pairs together")
        self.in_bounds({}, "import", "d_0000.rad", "--interface", "499", "-o", "rad.yaml")

    def test_a_table_that_many_steps_have_stays_within_bounds_as_a_deck(self):
        rows = "mu,slip_rate\n" + "".join(f"0.{1 + i % 2},{i}\n" for i in range(50000))
        change = "change_friction: {}, "
        table = "&c {friction1: {coefficient: {columns: [mu, slip_rate], csv: d.csv}}}"
        steps = "".join(STEP.format(name=f"s{i}").replace("motion", change.format("*c" if i else table) + "motion") for i in range(39))
        self.in_bounds({"d.csv": rows, "c.yaml": SLIDER.format(title="Tables", history=steps)}, "export", "c.yaml", "--to", "abaqus", "-o", "o.inp", said="the deck is not read back")

    def test_a_deck_whose_frictions_name_one_group_stays_within_bounds(self):
        parts = "".join(",".join(f"{i + k}" for k in range(8)) + "\n" for i in range(1, 60000, 8))
        pairs = "".join(f"*DEFINE_FRICTION\n{i},.2\n4,4,.4,.2,1.,0.,PSET,PSET\n" for i in range(1, 3001))
        self.in_bounds({"d.k": "*KEYWORD\n*SET_PART_LIST\n4\n" + parts + pairs}, "import", "d.k", code=2, said="3000 contacts with friction")
        self.in_bounds({}, "import", "d.k", "--id", "2999", "-o", "one.yaml")
        refused = "its cases would list more than 1000000 parts together: choose one of them with --"
        self.in_bounds({}, "import", "d.k", "--all", "-o", "all", code=2, said=refused + "interface, or a *DEFINE_FRICTION with --id")
        group = "#RADIOSS STARTER\n/BEGIN\nrun\n      2022         0\n" + 2 * f"{'kg':>20}{'mm':>20}{'ms':>20}\n" + "/GRPART/PART/4\nbody\n" + "".join(
            "".join(f"{i + k:>10}" for k in range(10)) + "\n" for i in range(1, 40000, 10))
        law = "".join(f"{0:>20}" for _ in range(5)) + f"\n{0:>20}{0.1:>20}{1:>20}\n"
        frictions = "".join(f"/FRICTION/{i}\nlid\n{0:>10}{0:>10}{0:>20}{2:>10}\n{law}{4:>10}{0:>10}{0:>10}{3:>10}\n{law}" for i in range(1, 1000))
        self.in_bounds({"d_0000.rad": group + frictions + "/END\n"}, "import", "d_0000.rad", "--all", "-o", "rad", code=2, said=refused + "interface or --id")
        self.in_bounds({}, "import", "d_0000.rad", "--id", "999", "-o", "rad.yaml")
        # Collected piece by piece, each part once.
        collected = "*SET_PART_LIST_COLLECT\n4\n7,8\n" * 70000 + "*SET_PART_LIST_COLLECT\n4\n3,7\n"
        self.in_bounds({"c.k": "*KEYWORD\n" + collected + "*DEFINE_FRICTION\n1,.2\n4,4,.4,.2,1.,0.,PSET,PSET\n"}, "import", "c.k", said="S4: [3, 7, 8]")

    def test_connectors_that_share_the_steps_of_a_deck_stay_within_bounds(self):
        nodes, rest = SLOT.split("*ELEMENT, TYPE=CONN3D2, ELSET=PIN\n1, 1, 2\n")
        body = rest.split("*AMPLITUDE")[0]
        step = "*STEP\n*STATIC\n1.,1.\n*CONNECTOR MOTION\nPIN, 1, 0.5\n*END STEP\n"
        elements = "*ELEMENT, TYPE=CONN3D2, ELSET=PIN\n" + "".join(f"{i}, 1, 2\n" for i in range(1, 1000))
        for words in (("--all", "-o", "all"), ()):
            self.in_bounds({"d.inp": nodes + elements + body + step * 1000}, "import", "d.inp", *words, code=2, said="with --connector; their sections have PIN")
        self.in_bounds({}, "import", "d.inp", "--connector", "7", "-o", "seven.yaml")
        instances = "".join(f"*INSTANCE, NAME=I{i}, PART=P\n*END INSTANCE\n" for i in range(12000))
        ends = "*ELEMENT, TYPE=CONN3D2, ELSET=PIN\n" + "".join(f"{i}, I{i-1}.1, I{i-1}.2\n" for i in range(1, 12001))
        self.in_bounds({"d.inp": "*PART, NAME=P\n" + nodes + "*END PART\n*ASSEMBLY, NAME=A\n" + instances + ends + body.split("*CONNECTOR BEHAVIOR")[0] + "*END ASSEMBLY\n*CONNECTOR BEHAVIOR" + body.split("*CONNECTOR BEHAVIOR")[1]},
                       "import", "d.inp", "--connector", "1", "-o", "first.yaml")
        name = "N" * 150
        sets = "".join(f"*ELSET, ELSET={name}{i}\n{name}{i+1}\n" for i in range(2200)) + f"*ELSET, ELSET={name}2200\nPIN\n"
        self.in_bounds({"d.inp": nodes + elements + sets + body.replace("ELSET=PIN, BEHAVIOR", f"ELSET={name}0, BEHAVIOR")}, "import", "d.inp", "--connector", "1",
                       "-o", "none.yaml", code=2, said="names of them in sets for more than 150 MB")
        changes = "*STEP\n*STATIC\n1.,1.\n*CHANGE FRICTION, ELSET=PIN\n*FRICTION\n0.5\n*END STEP\n" * 12000
        self.in_bounds({"d.inp": nodes + "*ELEMENT, TYPE=CONN3D2, ELSET=PIN\n1, 1, 2\n" + body.replace(", ELASTIC SLIP=0.002", "") + changes}, "import", "d.inp", "-o", "changes.yaml")
        self.in_bounds({"d.inp": "*PARAMETER\na=1" + "**" * 470000 + "\n" + nodes}, "import", "d.inp", code=2)

    def test_no_step_of_a_deck_takes_a_walk_through_an_amplitude(self):
        head, tail = SLOT.split("*AMPLITUDE")
        amplitude = "*AMPLITUDE, NAME=A, TIME=TOTAL TIME, DEFINITION=EQUALLY SPACED, FIXED INTERVAL=1.\n" + "1,2,3,4,5,6,7,8\n" * 62500
        steps = "*STEP\n*STATIC\n1.,1.\n*CONNECTOR MOTION, AMPLITUDE=A\nPIN, 1, 0.5\n*END STEP\n" + "*STEP\n*STATIC\n1.,1.\n*END STEP\n" * 14000
        self.in_bounds({"slot.inp": head + amplitude + steps}, "import", "slot.inp", "-o", "slot.yaml", said="kept: 14001 steps")

    def test_no_step_of_a_deck_takes_a_walk_through_the_columns_of_a_history(self):
        head, tail = SLOT.split("*AMPLITUDE")
        steps = "*STEP\n*STATIC\n1.,1.\n*CONNECTOR MOTION\nPIN, 1, 0.5\n*END STEP\n" * 17000
        rows = "t," + ",".join(f"c{i}" for i in range(9990)) + "\n" + "".join(f"{i}" + ",0" * 9990 + "\n" for i in range(2))
        self.in_bounds({"slot.inp": head + steps, "h.csv": rows}, "import", "slot.inp", "--history", "h.csv", "-o", "slot.yaml", said="kept: 17000 steps")

    def test_no_element_of_a_deck_takes_a_walk_through_the_ranges_of_a_set(self):
        nodes, rest = SLOT.split("*ELEMENT, TYPE=CONN3D2, ELSET=PIN\n1, 1, 2\n")
        elements = "*ELEMENT, TYPE=CONN3D2, ELSET=PIN\n" + "".join(f"{i},1,2\n" for i in range(1, 95001))
        sets = "*ELSET, ELSET=ALL, GENERATE\n1,999999\n*ELSET, ELSET=E, GENERATE\n"
        steps = "*STEP\n*STATIC\n1.,1.\n*CONNECTOR MOTION\nE, 1, 0.5\nALL, 1, 0.25\n*END STEP\n"
        for ranges in ("9,9\n" * 500000, "".join(f"{i},{i}\n" for i in range(3, 1500000, 3))):
            self.write("slot.inp", nodes + elements + sets + ranges + rest.split("*AMPLITUDE")[0] + steps)
            for element, twice in ((9, True), (10, False)):
                self.in_bounds({}, "import", "slot.inp", "--connector", f"{element}", "-o", "slot.yaml", "--force", said="95000 connectors with friction")
                self.assertEqual("stated twice" in (self.folder / "slot.yaml").read_text(), twice)

    def test_ranges_of_a_set_that_lie_over_one_another_are_bounded(self):
        nodes, rest = SLOT.split("*ELEMENT, TYPE=CONN3D2, ELSET=PIN\n1, 1, 2\n")
        elements = "*ELEMENT, TYPE=CONN3D2, ELSET=PIN\n" + "".join(f"{i},1,2\n" for i in range(1, 30001))
        head = nodes + elements + "*ELSET, ELSET=E, GENERATE\n"
        rest = rest.replace("PIN, 1, 0.4", "E, 1, 0.4")
        # Each with a step of its own, none of which has the number of another.
        steps = "".join(f"{i},999999,{i + 30000}\n" for i in range(1, 35001))
        self.in_bounds({"slot.inp": head + steps + rest}, "import", "slot.inp", "--connector", "1", code=2, said="more than 1000 ranges of element sets lie around 1001")
        apart = "".join(f"{i},{i + 8},2\n" for i in range(1, 350001, 10))
        self.in_bounds({"slot.inp": head + apart + rest}, "import", "slot.inp", "--connector", "1", "-o", "slot.yaml")

    def test_a_file_that_many_steps_read_is_bounded(self):
        rows = "t,x\n" + "".join(f"{i},{i * 1e-6}\n" for i in range(40000))
        motion = "motion: &m {CP1: {csv: d.csv, time: t, value: x, begins: 39997}}"
        head = SLIDER.format(title="Again", history="")
        steps = f"  - {{step: a, increments: 1, {motion}, force: {{f2: 100}}}}\n" + "".join(f"  - {{step: s{i}, increments: 1, motion: *m}}\n" for i in range(4000))
        self.in_bounds({"d.csv": rows, "c.yaml": head + steps}, "run", "c.yaml", "--no-output", code=2, said="files of numbers are read again and again")
        # What lies before a step is read once.
        self.in_bounds({"c.yaml": head + f"  - {{step: a, increments: 1, repeat: 8000, {motion}, force: {{f2: 100}}}}\n"}, "run", "c.yaml", "--no-output")
        self.in_bounds({"c.yaml": head + f"  - {{step: a, increments: 1, repeat: 8000, {motion.replace('d.csv', '{file: d.csv, missing: hold}')}, force: {{f2: 100}}}}\n"}, "run", "c.yaml", "--no-output")
        change = "change_friction: {}{{friction1: {{coefficient: {{columns: [mu, slip_rate], csv: {{file: d.csv, missing: skip}}}}}}}}"
        steps = "".join(STEP.format(name=f"s{i}").replace("motion", (change.format("&c ") if i == 0 else "change_friction: *c") + ", motion") for i in range(4000))
        self.in_bounds({"d.csv": "mu,slip_rate\n0.2,0\n" + ",\n" * 80000, "c.yaml": head + steps}, "run", "c.yaml", "--no-output", code=2, said="files of numbers are read again and again")
        fields = "{" + ", ".join(f"field{i}: = t" for i in range(1, 17)) + "}"
        steps = f"  - {{step: a, increments: 1, motion: {{CP1: {{to: 1}}}}, force: {{f2: 100}}, fields: &f {fields}}}\n" + "".join(f"  - {{step: s{i}, increments: 1, fields: *f}}\n" for i in range(4000))
        self.in_bounds({"c.yaml": head + steps}, "run", "c.yaml", "--no-output", code=2, said="the steps have more than 10000 formulas over the time")

    def test_units_of_many_steps_are_settled_in_time(self):
        head = SLIDER.format(title="Units", history="").replace("connector:", "units: {length: mm, force: N, time: s}\nconnector:")
        wave = "{sine: {amplitude: 1 %s, mean: 1 %s, period: 1 s}}"
        steps = f"  - {{step: a, increments: 1, motion: &m {{CP1: {wave % ('mm', 'mm')}}}, force: &f {{f2: {wave % ('N', 'N')}}}}}\n"
        steps += "".join(f"  - {{step: s{i}, increments: 1, motion: *m, force: *f}}\n" for i in range(12000))
        self.in_bounds({"c.yaml": head + steps}, "run", "c.yaml", "--no-output")
        self.in_bounds({"c.yaml": head + steps.replace("1 N, period", "1 mm, period", 1)}, "run", "c.yaml", "--no-output", code=2, said="'1 mm'")

    def test_a_fit_of_many_experiments_and_a_sweep_of_many_parameters_stay_within_bounds(self):
        self.slider("c.yaml")
        one = "{{name: e{}, case: c.yaml, data: d.csv, time: t, compare: {{CSF1: F}}}}"
        fit = "slipbench: 1\ncalibrate: {{vary: {{mu: {{bounds: [0.1, 0.4]}}}}, stop: {{iterations: 1}}, polish: false, experiments: [{}]}}\n"
        self.write("c.yaml", (self.folder / "c.yaml").read_text().replace("0.2", "= mu") + "parameters: {mu: 0.2}\n")
        rows = "t,F\n" + "".join(f"{i / 40000},{20 * min(1, i / 8000)}\n" for i in range(40000))
        self.in_bounds({"d.csv": rows, "f.yaml": fit.format(", ".join(map(one.format, range(100))))}, "calibrate", "f.yaml", "-o", "out", code=2, said="rows together: the same files again and again")
        self.in_bounds({"d.csv": "t,F\n0,0\n0.5,21\n1,21\n", "f.yaml": fit.format(", ".join(map(one.format, range(60)))).replace("iterations: 1", "iterations: 9")}, "calibrate", "f.yaml", "-o", "out",
                       said="pictures show the first 20 of 60 experiments" if shutil.which("gnuplot") else "")
        chain = ", ".join(f"p{i}: = p{i + 1}+1" for i in range(1998)) + ", p1998: = mu"
        self.write("c.yaml", (self.folder / "c.yaml").read_text().replace("= mu,", '"= mu+0*p0",').replace("{mu: 0.2}", f"{{mu: 0.2, {chain}}}"))
        self.in_bounds({"s.yaml": "slipbench: 1\nsweep: {case: c.yaml, vary: {mu: {uniform: [0.1, 0.3]}}, samples: 100, sampler: lhs, collect: {a: {max: CSF1}}}\n"}, "sweep", "s.yaml", "-o", "swept")

    def test_a_message_about_a_curve_lists_few_of_its_columns(self):
        names = [f"c{i}" for i in range(9000)]
        self.write("wide.csv", "t," + ",".join(names) + "\n" + "".join(f"{t}" + ",0" * len(names) + "\n" for t in (0, 1)))
        self.write("twice.csv", "t,F,F\n0,0,0\n1,0,0\n")
        check = "  - {{name: d{}, quantity: CSF1, against: {{curve: {}, column: {}}}, tolerance: {{absolute: 1, why: a}}}}\n"
        case = SLIDER.format(title="Wide", history=STEP.format(name="a")) + "checks:\n"
        self.refused_in_time(case + check.format(0, "wide.csv", "F"), "the columns are t, c0, c1, c2, c3 and 8996 more", code=1)
        self.refused_in_time(case + check.format(0, "twice.csv", "F"), "twice.csv: two columns are named 'F'", code=1)
        many = case + "".join(check.format(i, "wide.csv", f"a_column_that_is_not_there_{i}") for i in range(1000))
        self.refused_in_time(many, "no column 'a_column_that_is_not_there_999'", code=1, longest=200000)

    def test_a_parameter_is_no_second_card_of_the_option_mpp(self):
        deck = """*KEYWORD
*PARAMETER
Isurf           1
*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MPP_ID
         3Pad on disc
         0       200
%s         2         3         3
      0.42       0.3      2e-3       0.0      20.0
       1.0       1.0
*END
"""
        for cards in ("    &surf", "&surf    ", "         1", "&                  1\n         1", "&,1,1\n         1"):
            self.write("deck.k", deck % cards)
            self.run_tool("import", "deck.k", "-o", "pad.yaml", "--force")
            self.assertIn("{static: 0.42, kinetic: 0.3, decay: 0.002}", (self.folder / "pad.yaml").read_text(), cards)

    def test_an_interface_that_lacks_a_card_is_told(self):
        deck = (SOURCE / "tests/decks/radioss/type7_points_at_friction_0000.rad").read_text()
        last = "         0         0                   0         1         0         0                   0        21\n"
        self.assertIn(last, deck)
        own = deck.replace(last, last.replace("21", " 0"))
        self.write("drum_0000.rad", own)
        self.run_tool("import", "drum_0000.rad", "--interface", "6", "-o", "drum.yaml")
        self.assertIn("0.9", (self.folder / "drum.yaml").read_text())
        for law, words in (("4", "the card of C1 to C5 is missing"), ("1", "the card of C1 to C5 is missing")):
            self.write("drum_0000.rad", deck.replace(last, law.rjust(10) + last.replace("21", " 0")[10:]))
            self.assertIn(words, self.run_tool("import", "drum_0000.rad", "--interface", "6", "-o", "none.yaml", code=2))
        third = "                   0                   0                   0                   0         0         0\n"
        self.assertIn(third, own)
        self.write("drum_0000.rad", own.replace(third, ""))
        self.assertIn("here card 4 has 000 in columns 8 to 10", self.run_tool("import", "drum_0000.rad", "--interface", "6", "-o", "none.yaml", code=2))

    def test_what_an_abaqus_deck_loses_is_told(self):
        for old, new, words in (("*NODE", "*NODE, SYSTEM=C", "positions begin at 0 here"), ("*STATIC, DIRECT", "*STATIC, RIKS", "RIKS is not followed"),
                                ("*FRICTION, ELASTIC SLIP=0.002", "*FRICTION, SHEAR TRACTION SLOPE=50", "SHEAR TRACTION SLOPE is not read"),
                                ("*STEP", "*STEP, PERTURBATION\n*STATIC\n1., 1.\n*CONNECTOR MOTION\nPIN, 1, 77.\n*END STEP\n*STEP", "is a perturbation, which changes no state")):
            self.write("slot.inp", SLOT.replace(old, new, 1))
            self.assertIn(words, self.run_tool("import", "slot.inp", "-o", "slot.yaml", "--force"))
            text = (self.folder / "slot.yaml").read_text()
            self.assertNotIn("77", text)
            self.assertEqual("CP1: 7" in text, "SYSTEM" not in new)

    def test_a_contact_deck_with_a_part_that_means_nothing_is_refused(self):
        deck = """*KEYWORD
*PARAMETER
Rmu       0.3
*SET_PART_LIST
         4
        11        12
*DEFINE_FRICTION
         1      &mu       0.2       1.0       0.0
         4         2       0.4       0.2       1.0       0.0      PSET
*DEFINE_CURVE
         9
                 0.0                 0.3
                 1.0                 0.4
*DEFINE_TABLE_2D
         5
                 0.0                   9
               100.0                   9
*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID
         8lid on drum
         1         2         3         3
       2.0        5.       0.0

*END
"""
        self.write("deck.k", deck)
        self.run_tool("import", "deck.k", "--all", "-o", "whole")
        rows = (self.folder / "whole" / "deck_CONTACT_8.yaml").read_text()
        self.assertIn("[0.3, 0, = 0*area]", rows)
        parameter = "*PARAMETER\nRmu       0.5\n*DEFINE_CURVE"
        for old, new, words in (("*DEFINE_CURVE", "*DEFINE_FRICTION\n         1       0.9\n*DEFINE_CURVE", "the id 1 stands twice"),
                                ("*DEFINE_TABLE_2D", "*DEFINE_CURVE\n         9\n                 0.0                 0.3\n*DEFINE_TABLE_2D", "the id 9 stands twice"),
                                ("*DEFINE_FRICTION\n", "*SET_PART_LIST\n         4\n        13\n*DEFINE_FRICTION\n", "the id 4 stands twice"),
                                ("1.0       0.0\n         4", "1.0      -5.0\n         4", "VC must not be negative"),
                                ("         4         2       0.4", "                   2       0.4", "wanted the id of a part"),
                                ("\n                 0.0                 0.3", "\n                 0.x                 0.3", "A:"),
                                ("PSET", "PART", "wanted PSET or nothing"), ("SURFACE_ID", "SURFACE_ID of the lid", "text behind the keyword")):
            self.assertIn(old, deck)
            self.write("deck.k", deck.replace(old, new, 1))
            self.assertIn(words, self.run_tool("import", "deck.k", "--all", "-o", "parts", code=2), words)
            self.assertFalse((self.folder / "parts").exists(), words)
        for old, new, words, row in (("*DEFINE_CURVE", parameter, "'mu' stands twice: it keeps its first number", "static: 0.3"),
                                     ("                 0.0                 0.3", "                                     0.3", "", "[0.3, 0, = 0*area]"),
                                     ("*DEFINE_CURVE", "*DEFINE_FRICTION_SCALING\n         1       0.9\n*DEFINE_CURVE", "is not read", "static: 0.3"),
                                     ("*DEFINE_FRICTION\n", "*SET_PART_LIST_COLLECT\n         4\n        13\n*DEFINE_FRICTION\n", "", "[11, 12, 13]"),
                                     ("PSET", "Pset", "", "[11, 12]"),
                                     ("SURFACE_ID", "SURFACE_ID $ of the lid", "", "[0.3, 0, = 0*area]"),
                                     ("\n         5\n", "\n         5      10.0       5.0\n", "", "[0.4, 1, = 1050*area]"),
                                     ("*CONTACT_AUTO", "*CONTACT_2D_AUTOMATIC_SURFACE_TO_SURFACE_ID\n         9\n         1         2\n       0.4\n*CONTACT_AUTO", "contacts of its kind are not read", "[0.3, 0, = 0*area]"),
                                     ("SURFACE_ID", "SURFACE_ORTHO_FRICTION_ID", "of _ORTHO_FRICTION, are not read", ""),
                                     ("SURFACE_ID\n         8lid on drum\n         1         2         3         3\n       2.0        5.", "SURFACE_THERMAL_FRICTION_ID\n         8lid on drum\n         1         2         3         3\n      -2.0        1.", "the curves over temperature of _THERMAL_FRICTION", ""),
                                     ("SURFACE_ID", "SURFACE_THERMAL_FRICTION_ID", "the curves over temperature of _THERMAL_FRICTION", "")):
            self.assertIn(old, deck)
            self.write("deck.k", deck.replace(old, new, 1))
            shutil.rmtree(self.folder / "parts", ignore_errors=True)
            self.assertIn(words, self.run_tool("import", "deck.k", "--all", "-o", "parts"), words)
            self.assertIn(row, "".join(file.read_text() for file in sorted((self.folder / "parts").iterdir())), new)
            self.assertEqual((self.folder / "parts" / "deck_CONTACT_8.yaml").exists(), "ORTHO" not in new)

        for deck, words in (("#RADIOSS STARTER\n/BEGIN\nrun\n      20x7         0\n/GRPART/PART/3\ngroup\n         1\n/GRPART/PART/3\ngroup\n         2\n", "stands twice"),
                            ("#RADIOSS STARTER\n/BEGIN\nrun\n      20x7         0\n", "version: wanted a number, found '20x7'"),
                            ("#RADIOSS STARTER\n//SUBMODEL/1\nlid\n       1x0\n//ENDSUB\n", "off_def: wanted a number, found '1x0'"),
                            ("#RADIOSS STARTER\n/PARAMETER/GLOBAL/REAL/1\na\n        mu       0.3\n/PARAMETER/GLOBAL/REAL/2\nb\n        mu       0.4\n", "'mu' stands twice, with 0.3 and 0.4")):
            self.write("deck_0000.rad", deck + "/FRICTION/1\nlid\n         0\n                   0\n                                     0.3\n/END\n")
            said = self.run_tool("import", "deck_0000.rad", "--id", "1", "-o", "out", code=0 if "version" in words else 2)
            self.assertIn(words, said)

    def test_an_increment_that_does_not_end_is_given_up(self):
        potential = "potential: {exponent: 1.0001, terms: [{component: 2}, {component: 3}]}, contact_force: 1, coefficient: 0.2, stick: {elastic_slip: 0.01}"
        corner = "slipbench: 1\nconnector: {type: SLIDE-PLANE}\nintegration: {method: exact}\nfriction: [{" + potential + "}]\n" \
                 "history: [{step: a, increments: 1, force: {f1: 100}, motion: {CP2: {to: 0.03}, CP3: {to: 0.01}}}]\n"
        self.refused_in_time(corner, "change too often within the increment", code=3)
        mass = "slipbench: 1\nconnector: {type: SLOT}\nfriction: [{predefined: {}, coefficient: 0.2, stick: {stiffness: 1000}}]\n" \
               "elasticity: [{component: 1, stiffness: 100}]\ndynamics: {mass: 1, belt_velocity: 0.05}\ndamping: [{component: 1, coefficient: 1.0e6}]\n" \
               "history: [{step: a, duration: 5, increments: 1, force: {f2: 10}}]\n"
        self.refused_in_time(mass, "needs too many time steps", code=3)

    def test_checks_of_nothing_do_not_pass(self):
        self.write("fall.csv", "t,CSF1\n0,0\n0.5,20\n0.4,20\n1,20\n")
        self.write("one.csv", "t,CSF1\n0.99,20\n250,4000\n")
        check = "checks: [{{name: c, quantity: CSF1, {}, tolerance: {{absolute: 1000, why: a}}}}]\n"
        case = SLIDER.format(title="Checks", history=STEP.format(name="a"))
        for criterion in ("peak", "plateau", "area", "sprague_geers"):
            for curve, words in (("fall", "the times of the reference fall"), ("one", "fewer than two rows of the reference")):
                bound = check if criterion != "sprague_geers" else check.replace("1000", "0.9")
                self.write("case.yaml", case + bound.format(f"criterion: {criterion}, against: {{curve: {curve}.csv}}"))
                self.assertIn(words, self.run_tool("check", "case.yaml", code=1))
        self.write("case.yaml", case + check.format('against: {expression: "=  CSF1"}'))
        self.assertIn("compare it with itself", self.run_tool("check", "case.yaml", code=2))
        self.write("case.yaml", case)
        self.assertIn("warning: no case has a check", self.run_tool("check", "case.yaml"))
        self.assertIn("error: no case has a check", self.run_tool("check", "case.yaml", "--strict", code=1))

    def test_a_unit_has_no_origin(self):
        case = SLIDER.format(title="U", history=STEP.format(name="a")).replace("connector", "units: {length: mm, force: N, time: s}\nconnector")
        for old, new in (("to: 0.1", "to: 1 m @ 5"), ("f2: 100", "f2: 100 N from 20"), ("length: mm", "length: mm @ 3"), ("to: 0.1", "to: 1 m^99999999999999999999")):
            self.assertEqual(case.count(old), 1)
            self.write("case.yaml", case.replace(old, new))
            self.assertIn("unit", self.run_tool("run", "case.yaml", "--no-output", code=2))

    def test_links_out_of_a_folder_are_not_followed(self):
        self.slider("suite/own.yaml")
        self.slider("private.yaml", title="Private")
        (self.folder / "suite/link.yaml").symlink_to("../private.yaml")
        for words in (("check", "suite", "--report", "page.html"), ("report", "suite", "-o", "page.html", "--force")):
            said = self.run_tool(*words, code=4)
            self.assertIn("link.yaml: error: is a link out of the folder", said)
            if (self.folder / "page.html").exists():
                self.assertNotIn("Private", (self.folder / "page.html").read_text())

    def test_a_status_that_is_no_regime_is_no_result(self):
        for status in ("7", "-1", "1e300"):
            rows = "".join(f"{i},{i % 5},{status if i % 3 == 2 else i % 3}\n" for i in range(20000))
            self.write("result.csv", "# friction: slider = CSF1\nt,CSF1,STATUS\n" + rows)
            for words in (("plot", "result.csv", "-o", "a.svg"), ("plot", "result.csv", "--as", "bands", "-o", "a.svg"), ("report", "result.csv", "-o", "page.html")):
                said = self.run_tool(*words, "--force", code=2)
                self.assertIn(f"STATUS is {status.replace('1e300', '1e+300')} at t = 2; it is 0 (open), 1 (stick) or 2 (slip)", said)

    def test_a_result_of_many_columns_takes_little_memory(self):
        names = [f"d{i}" for i in range(3000)]
        self.write("result.csv", "# friction: " + ", ".join(f"{name} = CSF1.{name}" for name in names) + "\n" +
                   "t," + ",".join(f"CSF1.{name},STATUS.{name}" for name in names) + "\n" + "".join(f"{i}" + ",1" * 6000 + "\n" for i in range(40)))
        for words in (("plot", "result.csv", "-o", "a.svg"), ("report", "result.csv", "-o", "page.html"), ("convert", "result.csv", "-o", "result.h5")):
            start = time.monotonic()
            done = subprocess.Popen([PROGRAM, *words, "--force"], cwd=self.folder, stdout=subprocess.DEVNULL)
            _, status, used = os.wait4(done.pid, 0)
            done.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(done.returncode, 0, words)
            self.assertLess(time.monotonic() - start, SECONDS)
            self.assertLess(used.ru_maxrss, 300_000 * SECONDS // 20, words)

    def test_apostrophes_are_drawn(self):
        for title in ("Pin of 2'' in a bush", "'A' against B", "it's `x` \\\\ \\\"q\\\" '"):
            self.slider("it's 'q''.yaml", title=f'"{title}"')
            self.run_tool("plot", "it's 'q''.yaml", "-o", "x.svg", env={"GNUTERM": "qt"})
            self.assertIn("Pin of 2'' in" if title.startswith("Pin") else "x" if title[0] == "i" else "'A' against", (self.folder / "x.svg").read_text())

    def test_a_table_whose_blocks_share_no_point_is_read_in_time(self):
        plain = SLIDER.format(title="Ragged", history=STEP.format(name="a"))
        two = [f"[0.{n % 7 + 1}, {n}, {n // 2}]" for n in range(20000)]
        three = [f"[0.{n % 7 + 1}, {n}, {n // 2}, {n // 2}]" for n in range(14000)]
        # Six independents, of which no two blocks share a point.
        six = ["[0.1, " + ", ".join(str((n >> 2 * k & 3) + 1e-4 * (n >> 2 * k + 2)) for k in range(6)) + "]" for n in range(4096)]
        for columns, rows, code, words in (("slip_rate, contact_force", two, 0, "ragged.csv"), ("slip_rate, contact_force, temperature", three, 0, "ragged.csv"),
                                           ("slip_rate, contact_force, temperature, field1, field2, field3", six, 2, "too few points in common")):
            text = plain.replace("coefficient: 0.2", f"coefficient: {{columns: [mu, {columns}], rows: [{', '.join(rows)}]}}")
            self.write("ragged.yaml", text.replace("0.1}}", "0.1}}, temperature: 20, fields: {1: 0, 2: 0, 3: 0}" if "field1" in columns else "0.1}}, temperature: 20"))
            start = time.monotonic()
            self.assertIn(words, self.run_tool("run", "ragged.yaml", "-o", "out", "--force", code=code))
            self.assertLess(time.monotonic() - start, SECONDS)
            if code == 0:
                said = self.run_tool("export", "ragged.yaml", "--to", "table", code=2)
                self.assertIn("too many slip rates and contact forces for a grid", said)

    def test_wear_through_a_table_of_many_forces_has_an_end(self):
        rows = ", ".join(f"[{0.1 + 0.01 * (i % 2)}, {i}]" for i in range(1, 60000))
        self.write("wear.yaml", f"""slipbench: 1
title: Wear
connector: {{type: SLOT}}
friction:
  - component: 1
    internal_contact_force: {{columns: [force, accumulated_slip], rows: [[60001, 0], [0.5, 60000]]}}
    coefficient: {{columns: [mu, contact_force], rows: [{rows}]}}
    stick: {{stiffness: 1.0e+6}}
history:
  - {{step: a, duration: 1, increments: 2, motion: {{CP1: {{to: 120000}}}}}}
""")
        start = time.monotonic()
        self.assertIn("wear.csv", self.run_tool("run", "wear.yaml", "-o", "out"))
        self.assertLess(time.monotonic() - start, SECONDS / 4)

    def test_a_deck_of_few_keys_has_an_end(self):
        steps = "  - {{step: a, duration: 1, increments: {}, repeat: {}, motion: {{CP1: {}}}, force: {{f2: 100}}}}\n"
        for increments, repeat, profile, code, words in (
                (1, 100000, "{sine: {amplitude: 1, period: 0.3, phase: 0.3}}", 0, "deck.inp"),
                (100, 1, "{triangle: {amplitude: 1, period: 1.0e-8}}", 2, "too many increments for a deck")):
            self.write("case.yaml", SLIDER.format(title="T", history=steps.format(increments, repeat, profile)))
            start = time.monotonic()
            self.assertIn(words, self.run_tool("export", "case.yaml", "--to", "abaqus", "-o", "deck.inp", "--force", code=code))
            self.assertLess(time.monotonic() - start, SECONDS)

    def test_groups_of_one_number_stay_two_in_a_deck(self):
        pairs = """friction_pairs:
  groups: {A5: [1, 4], B5: [2, 3], G1001: [6], x: [7], G0: [8]}
  default: {coefficient: 0.1}
  pairs: [{parts: [A5, B5], coefficient: 0.15}, {parts: [x, G0], coefficient: 0.3}]
"""
        case = SLIDER.format(title="T", history=STEP.format(name="a")).replace("{type: SLOT}", "{type: SLOT, parts: [4, 2]}")
        self.write("case.yaml", case.replace(" coefficient: 0.2,", "") + pairs)
        radioss = self.run_tool("export", "case.yaml", "--to", "radioss", "--part", "behaviour")
        self.assertEqual(re.findall(r"^/GRPART/PART/(\d+)\n(\S+)", radioss, re.M), [("5", "A5"), ("1002", "B5"), ("1001", "G1001"), ("1003", "x"), ("1004", "G0")])
        self.assertRegex(radioss, r"(?m)^ +5 +1002 +0 +0 ")
        lsdyna = self.run_tool("export", "case.yaml", "--to", "lsdyna")
        self.assertRegex(lsdyna, r"(?m)^ +5 +1002 .*PSET +PSET$")
        self.assertRegex(lsdyna, r"(?m)^ +1003 +1004 .*PSET +PSET$")

    def test_part_pairs_of_many_groups_are_exported_in_time(self):
        groups = ", ".join(f"g{i}: [1]" for i in range(300000))
        pairs = "[&p {parts: [g299999, 2], coefficient: 0.15}" + ", *p" * 34000 + "]"
        case = SLIDER.format(title="T", history=STEP.format(name="a")).replace("{type: SLOT}", "{type: SLOT, parts: [1, 2]}").replace(" coefficient: 0.2,", "")
        self.write("case.yaml", case + f"friction_pairs: {{groups: {{{groups}}}, default: {{coefficient: 0.1}}, pairs: {pairs}}}\n")
        self.in_bounds({}, "export", "case.yaml", "--to", "lsdyna", "-o", "case.k", said="34001 records of part pairs")

    def test_a_unit_of_many_parameters_is_written_in_time(self):
        many = "".join(f"  p{i}: 0.1\n" for i in range(900))
        chain = "  q999: 0.1\n" + "".join(f"  q{i}: = q{i + 1}\n" for i in range(998, -1, -1))
        rows = ", ".join(f"[= p{i % 900}*{i}*0.0001+0.1, {i}]" for i in range(6000))
        case = SLIDER.format(title="U", history=STEP.format(name="a"))
        for coefficient, words in (("= q0", "parameter q999: the host can set it"),
                                   (f"{{columns: [mu, slip_rate], rows: [{rows}]}}", "too long to be read again for as many parameters")):
            self.write("case.yaml", case.replace("0.2", coefficient) + "parameters:\n" + many + chain)
            start = time.monotonic()
            self.assertIn(words, self.run_tool("export", "case.yaml", "--to", "fmu", "-o", "u.fmu", "--force"))
            self.assertLess(time.monotonic() - start, SECONDS)

    def test_a_unit_without_a_data_base_of_units_is_refused(self):
        self.write("case.yaml", SLIDER.format(title="U", history=STEP.format(name="a")).replace("connector", "units: {length: mm, force: N, time: s}\nconnector"))
        self.run_tool("export", "case.yaml", "--to", "fmu", "-o", "u.fmu")
        said = self.run_tool("export", "case.yaml", "--to", "fmu", "-o", "none.fmu", env={"UDUNITS2_XML_PATH": "/nonexistent"}, code=4)
        self.assertIn("unit data base cannot be read", said)
        self.assertFalse((self.folder / "none.fmu").exists())


unittest.main()
