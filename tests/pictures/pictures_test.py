#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every kind of picture of several cases shows all of its text, none over another, and the moving picture of README.md plays the rows of its case:
pictures_test.py --slipbench EXE --source DIR [--keep DIR]

Without gnuplot nothing can be drawn, and the test fails.
"""

import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

from svg_texts import misplaced, texts

CASES = """
  examples/shock_absorber examples/belt examples/lift_off examples/press_fit examples/part_pairs examples/puck
  examples/modified_darmstad examples/renard examples/stick_slip_belt examples/ball_in_socket examples/hinge_wear
  verification/several_definitions verification/documented_and_as_coded verification/coulomb_free_vibration
  verification/wear_table_temperature verification/belt_chain verification/radioss_ellipse verification/helical_slip
  verification/planar_slider_circle verification/contact_force_ujoint verification/coefficient_table
  validation/calculix_circle
""".split()
FITS = ["slider_loop_fit", "rate_temperature_table_fit"]
# Texts that a picture of a kind cannot do without, or a part of them; gnuplot leaves out what would stand outside.
WANTED = {
    "": ["time t", "friction "], "--as history": ["time t"], "--as hysteresis": ["friction "],
    "--as bands": ["time t"], "--as shares": ["time t", "normal "], "--as mu_map": ["coefficient mu"],
    "--as residuals": ["residual"], "--law": ["coefficient mu"], "--as phase_portrait": ["velocity ", "time t"],
    "--as spectrum": ["frequency", "amplitude of "], "--x t": ["time t", "friction "],
}
LONG = "A title as long as a rig's whole name, with its place, its date, its oil and what was changed since the last run"
# A case of big and small numbers without units and with names of any length.
HOSTILE = f"""slipbench: 1
title: {LONG}
parameters: {{mu: 0.2}}
connector: {{type: [CARTESIAN, REVOLUTE]}}
friction:
  - name: the_sleeve_with_the_worn_liner_of_the_left_hand_side
    component: 1
    internal_contact_force: 80.0e6
    coefficient: = mu
    stick: {{stiffness: 1.0e13}}
  - name: b
    component: 3
    internal_contact_force: 80.0e6
    coefficient: {{exponential_decay: {{static: 2.0e-4, kinetic: 1.0e-4, decay: 10}}}}
    stick: {{stiffness: 1.0e13}}
history:
  - {{step: press, duration: 1.0e-3, increments: 1}}
  - {{step: cycle, duration: 2.0e-3, increments: 80, motion: {{CP1: {{triangle: {{amplitude: 1.234567e-5, period: 1.0e-3}}}}, CP3: {{sine: {{amplitude: 12345678, period: 0.7e-3}}}}}}}}
checks:
  - name: {LONG}
    quantity: CSF1
    against: {{closed_form: coulomb_slider, with: {{mu: 0.2, normal_force: 80.0e6, stick_stiffness: 1.0e13}}, inputs: {{motion: CU1}}, output: force}}
    tolerance: {{absolute: 1.0e-3, why: rounding}}
"""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--slipbench", required=True)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    parser.add_argument("--keep", type=pathlib.Path, help="keep the pictures in this folder")
    options = parser.parse_args()
    failures = []
    drawn = set()

    def run(*arguments):
        return subprocess.run([options.slipbench, *map(str, arguments)], capture_output=True, text=True, timeout=300)

    def look(name, svg, kind):
        found = [text for text, *_ in texts(svg)[0]]
        for part in WANTED.get(kind, []):
            if not any(part in text for text in found):
                failures.append(f"{name}: no text has '{part}'")
        failures.extend(f"{name}: {fault}" for fault in misplaced(svg))

    def draw(case, kind, folder):
        picture = folder / f"{case.stem}{kind.replace('--as ', '.').replace('--', '.').replace(' ', '_')}.svg"
        done = run("plot", case, *kind.split(), "-o", picture)
        if done.returncode == 2 and kind:
            return  # the case has nothing of this kind
        if done.returncode != 0:
            failures.append(f"{picture.name}: exit code {done.returncode}: {done.stderr}")
            return
        drawn.add(kind)
        look(picture.name, picture.read_text(), kind)

    def fit(name, folder):
        done = run("calibrate", options.source / "cases/calibration" / f"{name}.yaml", "-o", folder)
        if done.returncode != 0:
            failures.append(f"{name}: exit code {done.returncode}: {done.stderr}")
        for picture in sorted(folder.glob(f"{name}*.svg")):
            drawn.add("fit")
            look(picture.name, picture.read_text(), "fit")

    def moves():
        """The picture that is kept is what the program's rows give now, and it moves at every change of stick and slip."""
        sys.dont_write_bytecode = True
        sys.path.insert(0, str(options.source / "docs/site"))
        import moving
        kept = (options.source / "docs/images/shaft.svg").read_text()
        failures.extend(f"shaft.svg: {fault}" for fault in misplaced(kept))
        if kept != moving.draw(options.slipbench):
            failures.append("docs/images/shaft.svg is not what docs/site/moving.py draws: run it")
        if re.search(r"https?://(?!www\.w3\.org/2000/svg\")", kept):
            failures.append("docs/images/shaft.svg names a place elsewhere")
        rows = moving.rows_of_readme(options.slipbench)
        changes = sum((before["STATUS"] == 2) != (after["STATUS"] == 2) for before, after in zip(rows, rows[1:]))
        colours = re.findall(r"fill:(#\w+)", re.search(r"@keyframes rubs\{(.*?\})\}", kept)[1])
        if sum(before != after for before, after in zip(colours, colours[1:])) != changes or changes < 9:
            failures.append(f"shaft.svg: {changes} changes of stick and slip, its colours are {colours}")

    moves()
    help_text = run("plot", "--help").stdout
    kinds = re.search(r"One picture only: (.*)", help_text).group(1).split(", ")
    wanted = ["", "--law", "--x t", *(f"--as {kind}" for kind in kinds)]
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or pathlib.Path(temporary)
        hostile = pathlib.Path(temporary) / "hostile.yaml"
        hostile.write_text(HOSTILE)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            jobs = [pool.submit(draw, case, kind, folder) for kind in wanted
                    for case in [hostile, *(options.source / "cases" / f"{case}.yaml" for case in CASES)]]
            jobs += [pool.submit(fit, name, folder) for name in FITS]
            for job in jobs:
                job.result()
    for kind in [*wanted, "fit"]:
        if kind not in drawn:
            failures.append(f"no case has a picture '{kind}'")
    for failure in failures:
        print(failure)
    print(f"{len(jobs)} pictures asked for, {len(failures)} faults")
    return 1 if failures else 0


sys.exit(main())
