# SPDX-License-Identifier: Apache-2.0
"""A mass on a belt in a host of units: the host integrates the motion, the unit gives the friction.

    squeal.py SLIPBENCH [PICTURE]

It stick-slips as the case of docs/guide/history.md does, which the bench integrates itself from event to event. With PICTURE the
drawing of docs/guide/other-programs.md is made, as docs/site/pages.py does."""
import csv
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy

import host

PROGRAM = str(pathlib.Path(sys.argv[1]).absolute())
GUIDE = pathlib.Path(__file__).parents[2] / "docs/guide"


def example(page, name):
    """A case that a page of the guide shows."""
    return re.search(rf"^```yaml case {re.escape(name)}\n(.*?)^```", (GUIDE / page).read_text(), re.M | re.S)[1]


def ride(unit, duration, dt=2e-4, mass=1.0, stiffness=100.0, belt=0.05, load=10.0):
    """The mass starts with the belt. A step is implicit (backward Euler): it is made again, from the kept state, until force and
    velocity agree. Returns rows of time, displacement, velocity, friction force, regime."""
    one = unit.instance()
    one.set(f2=load)
    x, v, rows = 0.0, belt, []
    for time in dt * numpy.arange(1, round(duration / dt) + 1):
        kept = one.state()
        old, friction, change = v, one.get("CSF1"), belt
        while abs(change) > 1e-9 * belt:
            change, v = v, (old - dt / mass * (friction + stiffness * x)) / (1 + dt * dt * stiffness / mass)
            change -= v
            one.go_back(kept)
            one.set(CP1=x + dt * v - belt * time)
            one.step(dt)
            friction = one.get("CSF1")
        one.free_state(kept)
        x += dt * v
        rows.append((time, x, v, friction, one.get("STATUS")))
    one.free()
    return numpy.array(rows)


def sticks(rows):
    """(begin, end) of each stick that lasts 10 ms; shorter ones are turns of the mass. The last one's end is that of the ride."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate([[False], rows[:, 4] == 1, [False]]).astype(int)))
    times = rows[numpy.minimum(edges, len(rows) - 1), 0]
    return [(begin, end) for begin, end in zip(times[::2], times[1::2]) if end - begin > 0.01]


def draw(rows, exact, file):
    """Draws displacement, friction force and the limit cycle, stick shaded."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams.update({"svg.hashsalt": "slipbench", "font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "path.simplify_threshold": 0.3})
    from matplotlib import pyplot

    figure = pyplot.figure(figsize=(8.0, 4.0), layout="constrained")
    places = figure.subplot_mosaic([["x", "cycle"], ["f", "cycle"]], width_ratios=[1.7, 1.0])
    time, x, v, force, _ = rows.T
    for name, y, text in (("x", 1000 * x, "displacement [mm]"), ("f", force, "friction force [N]")):
        axes = places[name]
        for i, (begin, end) in enumerate(sticks(rows)):
            axes.axvspan(begin, end, color="0.9", lw=0, label="stick" if i == 0 else None)
        axes.plot(time, y, color="tab:blue", lw=1.2, label="unit in the host")
        axes.set(ylabel=text, xlim=(0, time[-1]))
    places["x"].plot(exact["t"], 1000 * exact["CU1"], color="tab:orange", lw=1.2, ls=(0, (4, 3)), label="slipbench run")
    places["x"].tick_params(labelbottom=False)
    places["f"].set_xlabel("time [s]")
    places["cycle"].plot(1000 * x, 1000 * v, color="tab:blue", lw=1.0)
    places["cycle"].axhline(50, color="0.6", lw=0.8, ls=":")
    places["cycle"].text(0.02, 50, "belt", transform=places["cycle"].get_yaxis_transform(), va="bottom", color="0.4")
    places["cycle"].set(xlabel="displacement [mm]", ylabel="velocity [mm/s]")
    handles, labels = places["x"].get_legend_handles_labels()
    places["x"].legend(handles, labels, loc="lower left", bbox_to_anchor=(0, 1), ncols=3, frameon=False)
    figure.savefig(file, metadata={"Date": None} if file.endswith(".svg") else None)


def table(file):
    """The columns of a file of results."""
    with file.open() as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return {name: [row[name] for row in rows] for name in rows[0]}


def main():
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        case = folder / "pad.yaml"
        case.write_text(example("other-programs.md", "pad.yaml"))
        unit_file = folder / "pad.fmu"
        subprocess.run([PROGRAM, "export", case, "--to", "fmu", "-o", unit_file], check=True, capture_output=True)
        rows = ride(host.Unit(unit_file, folder / "unit"), 5.0)
        (folder / "squeal.yaml").write_text(example("history.md", "squeal.yaml"))
        subprocess.run([PROGRAM, "run", folder / "squeal.yaml", "-o", folder], check=True, capture_output=True)
        exact = table(folder / "squeal.csv")
        exact = {name: numpy.array(exact[name], float) for name in ("t", "CU1", "CP1")}
        events = table(folder / "squeal.events.csv")
    loose = [end for _, end in sticks(rows) if end < rows[-1, 0]]
    wanted = [float(time) for time, left, entered in zip(events["t"], events["from"], events["to"]) if (left, entered) == ("stick", "slip")]
    print(f"breaks loose at {numpy.round(loose, 3).tolist()} s in the host, {numpy.round(wanted, 3).tolist()} s in the bench")
    if len(sys.argv) > 2:
        draw(rows, exact, sys.argv[2])
    assert len(loose) == len(wanted) >= 5
    # The host's steps of 0.1 ms, and a fall of the coefficient within 2 mm/s in place of a jump.
    numpy.testing.assert_allclose(loose, wanted, atol=0.03)
    numpy.testing.assert_allclose(abs(rows[:, 1]).max(), abs(exact["CP1"]).max(), rtol=0.01)


if __name__ == "__main__":
    main()
