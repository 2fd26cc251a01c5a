# SPDX-License-Identifier: Apache-2.0
"""The pictures of docs/site/play.md: a run of the program for each position of a slider, drawn as SVG.

A picture is what all positions have in common, and for each position {identity: path or text}: assets/play.js puts that into the elements so called.
"""
import concurrent.futures
import html
import itertools
import json
import math
import os
import pathlib
import re
import tempfile

from drawing import Axes, rows_of

BLOCK = re.compile(r"^ *```yaml case (\S+)\n(.*?)^ *```", re.MULTILINE | re.DOTALL)
LEFT, RIGHT, TOP, SIDE = 62, 450, 16, 220  # of the two pictures


def dots(axes, points):
    """Small marks: strokes of no length with round ends."""
    return "".join("M{:.1f} {:.1f}h0".format(*axes.at(*point)) for point in points)


def curve(name, look):
    return f'<path id="{name}" class="{look}"/>'


def words(axes, x, y, text, look="", anchor="start"):
    return '<text class="{}" x="{:.0f}" y="{:.0f}" text-anchor="{}">{}</text>'.format(look, *axes.at(x, y), anchor, text)


def line(axes, look, *points):
    return f'<path class="{look}" d="{axes.curve(points)}"/>'


def last(rows, period):
    """The rows of the last period."""
    return [row for row in rows if row["t"] >= rows[-1]["t"] - period - 1e-9]


def column(rows, *names):
    return [tuple(row[name] for name in names) for row in rows]


class Stroke:
    """A loop of a block on a rail, and what a cycle costs."""

    label, unit, values, begin = "stroke", "mm", [0.005, 0.01, 0.015, 0.02, 0.025, 0.03, 0.035, 0.04, 0.05, 0.06, 0.08, 0.1], 0.05
    about = "Left the loop of force over travel, right the work of a cycle over the stroke"

    def __init__(self, runs):
        self.runs = runs
        self.loop = Axes(LEFT, TOP, 320, SIDE, (-0.11, 0.11), (-24, 24))
        self.work = Axes(RIGHT, TOP, 320, SIDE, (0, 0.11), (0, 8))

    def ground(self):
        a, b = self.loop, self.work
        return [*a.frame((-0.1, -0.05, 0, 0.05, 0.1), (-20, -10, 0, 10, 20), ("travel CP1 [mm]", "friction CSF1 [N]")),
                line(a, "limit", (-0.11, 20), (0.11, 20)), line(a, "limit", (-0.11, -20), (0.11, -20)), words(a, -0.108, 21, "limit", "limit"), curve("stroke-loop", "one"),
                *b.frame((0, 0.02, 0.04, 0.06, 0.08, 0.1), (0, 2, 4, 6, 8), ("stroke [mm]", "work of a cycle [N mm]")),
                line(b, "formula", (0, 0), (0.02, 0), (0.11, 7.2)), f'<path class="dots" d="{dots(b, ((v, cost(self.runs[v])) for v in self.values))}"/>', curve("stroke-here", "here")]

    def frame(self, value):
        rows = last(self.runs[value], 1)
        return {"stroke-loop": self.loop.curve(column(rows, "CP1", "CSF1")), "stroke-here": dots(self.work, [(value, cost(rows))]),
                "stroke-told": f"A cycle costs {cost(rows):.3g} N mm, the block slips {100 * sum(row['STATUS'] == 2 for row in rows[1:]) / len(rows[1:]):.0f} % of the time."}


def cost(rows):
    rows = last(rows, 1)
    return rows[-1]["DISS"] - rows[0]["DISS"]


class Direction:
    """The friction force of a plane and of two rails, in its two components."""

    label, unit, values, begin = "direction of the push", "°", list(range(0, 91, 5)), 45
    about = "Left the friction forces of both in their two components with their limits, a circle and a square; right one component over the way"
    others = {"rails": ("rails.yaml", [])}

    def __init__(self, runs, rails):
        self.runs, self.rails = runs, rails
        self.force = Axes(LEFT, TOP, SIDE * 1.0, SIDE, (0, 24), (0, 24))
        self.way = Axes(RIGHT, TOP, 320, SIDE, (0, 0.2), (0, 24))

    def ground(self):
        a, b = self.force, self.way
        return [*a.frame((0, 10, 20), (0, 10, 20), ("CSF2 [N]", "CSF3 [N]")), line(a, "limit", *((20 * math.cos(k * math.pi / 90), 20 * math.sin(k * math.pi / 90)) for k in range(46))),
                line(a, "limit", (20, 0), (20, 20), (0, 20)), curve("direction-rails", "two"), curve("direction-plane", "one"), curve("direction-rails-end", "two dots"), curve("direction-plane-end", "one dots"),
                *b.frame((0, 0.05, 0.1, 0.15, 0.2), (0, 10, 20), ("way [mm]", "CSF2 [N]")), curve("direction-rails-2", "two"), curve("direction-plane-2", "one"),
                words(b, 0.198, 22, "two rails", "two", "end"), words(b, 0.198, 1, "plane", "one", "end")]

    def frame(self, value):
        found = {}
        for name, rows in (("plane", self.runs[value]), ("rails", self.rails[value])):
            end = rows[-1]
            found[f"direction-{name}"] = self.force.curve([(0, 0), (end["CSF2"], end["CSF3"])])
            found[f"direction-{name}-end"] = dots(self.force, [(end["CSF2"], end["CSF3"])])
            found[f"direction-{name}-2"] = self.way.curve([(math.hypot(row["CP2"], row["CP3"]), row["CSF2"]) for row in rows if math.hypot(row["CP2"], row["CP3"]) <= 0.201])
        plane, rails = self.runs[value][-1], self.rails[value][-1]
        found["direction-told"] = (f"The plane holds {plane['CSF2']:.2f} and {plane['CSF3']:.2f} N, together {math.hypot(plane['CSF2'], plane['CSF3']):.2f} N; "
                                   f"two rails {rails['CSF2']:.2f} and {rails['CSF3']:.2f} N, together {math.hypot(rails['CSF2'], rails['CSF3']):.2f} N.")
        return found


class Wrap:
    """The pull of the hand over what it hauls, and over the wrap angle."""

    label, unit, values, begin = "wrap angle", "°", list(range(30, 541, 30)), 180
    about = "Left the pull of the hand over what it hauls, right its largest value over the wrap angle beside Euler's formula"

    def __init__(self, runs):
        self.runs = runs
        self.haul = Axes(LEFT, TOP, 320, SIDE, (0, 2), (0, 600))
        self.angle = Axes(RIGHT, TOP, 320, SIDE, (0, 540), (0, 10))

    def ground(self):
        a, b = self.haul, self.angle
        euler = [(v, math.exp(0.3 * math.radians(v))) for v in range(0, 441, 10)]
        return [*a.frame((0, 0.5, 1, 1.5, 2), (0, 200, 400, 600), ("hauled CP2 [mm]", "pull of the hand f_bc [N]")), curve("wrap-euler", "limit"), curve("wrap-pull", "one"),
                *b.frame((0, 90, 180, 270, 360, 450, 540), (0, 2, 4, 6, 8, 10), ("wrap angle [°]", "pull by load")), line(b, "formula", *euler), words(b, 380, 9, "Euler", "formula", "end"),
                f'<path class="dots" d="{dots(b, ((v, self.runs[v][-1]["f_bc"] / 100) for v in self.values))}"/>', curve("wrap-here", "here")]

    def frame(self, value):
        rows, euler = self.runs[value], math.exp(0.3 * math.radians(value))
        pull, slips = rows[-1]["f_bc"], rows[-1]["STATUS"] == 2
        return {"wrap-pull": self.haul.curve(column(rows, "CP2", "f_bc")), "wrap-here": dots(self.angle, [(value, pull / 100)]),
                "wrap-euler": self.haul.curve([(0, 100 * euler), (2, 100 * euler)]) if euler < 6 else "",
                "wrap-told": f"The hand pulls {pull:.1f} N, {pull / 100:.3f} times the load; Euler's formula says {euler:.3f}. The rope {'slips' if slips else 'sticks'} in the end."}


class Increments:
    """The force of backward Euler on a circle, against that which is exact."""

    label, unit, values, begin = "increments a turn", "", [4, 6, 8, 10, 12, 18, 24, 36, 60, 90, 180, 360], 12
    about = "Left the two components of the friction force at the ends of the increments of the second turn, on their circle; right one of them over time"
    others = {"exact": ("n.yaml", ["n=360"])}

    def __init__(self, runs, exact):
        self.runs, self.exact = runs, next(iter(exact.values()))
        self.force = Axes(LEFT, TOP, SIDE, SIDE, (-24, 24), (-24, 24))
        self.time = Axes(RIGHT, TOP, 320, SIDE, (1, 2), (-24, 24))

    def ground(self):
        a, b = self.force, self.time
        exact = last(self.exact, 1)
        return [*a.frame((-20, 0, 20), (-20, 0, 20), ("CSF2 [N]", "CSF3 [N]")), line(a, "formula", *column(exact, "CSF2", "CSF3")), curve("n-lag", "formula"), curve("n-force", "one"), curve("n-ends", "one dots"),
                *b.frame((1, 1.25, 1.5, 1.75, 2), (-20, 0, 20), ("time t [s]", "CSF2 [N]")), line(b, "formula", *column(exact, "t", "CSF2")), words(b, 1.53, 19, "exact", "formula", "end"),
                curve("n-time", "one"), curve("n-times", "one dots")]

    def frame(self, value):
        rows, exact = last(self.runs[value], 1), {round(row["t"], 6): row for row in self.exact}
        off = max(math.dist((row["CSF2"], row["CSF3"]), (of["CSF2"], of["CSF3"])) for row in rows for of in [exact.get(round(row["t"], 6))] if of)
        end, of = rows[-1], self.exact[-1]
        lag = math.degrees(math.atan2(of["CSF3"], of["CSF2"]) - math.atan2(end["CSF3"], end["CSF2"])) % 360
        return {"n-force": self.force.curve(column(rows, "CSF2", "CSF3")), "n-ends": dots(self.force, column(rows, "CSF2", "CSF3")) if value <= 60 else "",
                "n-lag": self.force.curve([(end["CSF2"], end["CSF3"]), (0, 0), (of["CSF2"], of["CSF3"])]),
                "n-time": self.time.curve(column(rows, "t", "CSF2")), "n-times": dots(self.time, column(rows, "t", "CSF2")) if value <= 60 else "",
                "n-told": f"Backward Euler is up to {off:.2f} N off, of 20 N; in the end it lags by {lag:.2f}° more than the exact force."}


class Belt:
    """The ride of a pad on a belt, and its swing over the speed of the belt."""

    label, unit, values, begin = "speed of the belt", "m/s", [0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6], 0.1
    about = "Left the pad's displacement over time, where it sticks thick; right its swing in the last half second over the speed of the belt"

    def __init__(self, runs):
        self.runs = runs
        self.time = Axes(LEFT, TOP, 320, SIDE, (0, 1), (-4, 16))
        self.swing = Axes(RIGHT, TOP, 320, SIDE, (0, 0.65), (0, 16))

    def ground(self):
        a, b = self.time, self.swing
        return [*a.frame((0, 0.25, 0.5, 0.75, 1), (0, 5, 10, 15), ("time t [s]", "displacement [mm]")), curve("belt-ride", "one"), curve("belt-stick", "one thick"),
                *b.frame((0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6), (0, 5, 10, 15), ("speed of the belt [m/s]", "swing [mm]")),
                f'<path class="dots" d="{dots(b, ((v, swing(self.runs[v])) for v in self.values))}"/>', curve("belt-here", "here")]

    def frame(self, value):
        rows = self.runs[value]
        shown = [row for row in rows if row["t"] <= 1]
        rides = [[(row["t"], 1000 * row["CU1"]) for row in run] for sticks, run in itertools.groupby(shown, lambda row: row["STATUS"] == 1) if sticks]
        late = last(rows, 0.5)[1:]
        return {"belt-ride": self.time.curve([(row["t"], 1000 * row["CU1"]) for row in shown]), "belt-stick": "".join(self.time.curve(ride) for ride in rides if len(ride) > 1),
                "belt-here": dots(self.swing, [(value, swing(rows))]),
                "belt-told": f"In the last half second the pad swings by {swing(rows):.2f} mm and rides along {100 * sum(row['STATUS'] == 1 for row in late) / len(late):.0f} % of the time."}


def swing(rows):
    way = [1000 * row["CU1"] for row in last(rows, 0.5)]
    return max(way) - min(way)


class Alpha:
    """The loops of a contact with a filter, as the page says and as the program does."""

    label, unit, values, begin = "filter α", "", [0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1.0], 0.05
    about = "Left the loops of both, right how far they are apart at most over the filter's number"

    def __init__(self, runs):
        self.runs = runs
        self.loop = Axes(LEFT, TOP, 320, SIDE, (-1.1, 1.1), (-36, 36))
        self.apart = Axes(RIGHT, TOP, 320, SIDE, (0, 1.05), (0, 60))

    def ground(self):
        a, b = self.loop, self.apart
        return [*a.frame((-1, -0.5, 0, 0.5, 1), (-30, 0, 30), ("travel [mm]", "friction [N]")), line(a, "limit", (-1.1, 30), (1.1, 30)), line(a, "limit", (-1.1, -30), (1.1, -30)),
                curve("alpha-coded", "two"), curve("alpha-documented", "one"), words(a, 0, 5, "as documented", "one", "middle"), words(a, 0, -9, "as coded", "two", "middle"),
                *b.frame((0, 0.2, 0.4, 0.6, 0.8, 1), (0, 20, 40, 60), ("filter α", "apart at most [N]")),
                f'<path class="dots" d="{dots(b, ((v, apart(self.runs[v])) for v in self.values))}"/>', curve("alpha-here", "here")]

    def frame(self, value):
        rows = last(self.runs[value], 1)
        return {"alpha-documented": self.loop.curve(column(rows, "CP2", "CSF2")), "alpha-coded": self.loop.curve(column(rows, "CP3", "CSF3")),
                "alpha-here": dots(self.apart, [(value, apart(rows))]), "alpha-told": f"In a cycle the two are up to {apart(rows):.2f} N apart, of 30 N."}


def apart(rows):
    return max(abs(row["CSF2"] - row["CSF3"]) for row in last(rows, 1))


PICTURES = {"stroke": Stroke, "direction": Direction, "wrap": Wrap, "n": Increments, "belt": Belt, "alpha": Alpha}
PARAMETERS = {"direction": "angle", "wrap": "angle"}  # where the parameter has another name than the case


def parameter(name):
    return PARAMETERS.get(name, name)


def pictures(page, program):
    """The figure of each picture as HTML, and the data of all positions, for a page's text and the program that makes the runs."""
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        folder = pathlib.Path(folder)
        for name, body in BLOCK.findall(page):
            (folder / name).write_text(re.sub(r"^    ", "", body, flags=re.MULTILINE))
        (folder / "exact.yaml").write_text((folder / "n.yaml").read_text() + "integration: {method: exact}\n")

        def runs(case, name, values):
            return {value: pool.submit(rows_of, program, folder / case, "--set", f"{parameter(name)}={value}") for value in values}
        begun = {name: [runs(f"{name}.yaml", name, one.values)] for name, one in PICTURES.items()}
        begun["direction"].append(runs("rails.yaml", "direction", Direction.values))
        begun["n"].append(runs("exact.yaml", "n", [360]))
        made = {name: [{value: run.result() for value, run in some.items()} for some in sets] for name, sets in begun.items()}
    figures, data = {}, {}
    for name, one in PICTURES.items():
        picture = one(*made[name])
        told = [f"{value:g}{'' if one.unit == '°' else ' '}{one.unit}".rstrip() for value in one.values]
        frames = [picture.frame(value) for value in one.values]
        at = one.values.index(one.begin)
        ground = "".join(picture.ground())
        for identity, what in frames[at].items():
            ground = ground.replace(f'<path id="{identity}" ', f'<path id="{identity}" d="{what}" ')
        figures[name] = (f'<figure class="play" data-play="{name}"><svg viewBox="0 0 790 280" role="img" aria-label="{html.escape(one.about)}">{ground}</svg>'
                         f'<label>{one.label} <input type="range" min="0" max="{len(told) - 1}" value="{at}"> <output>{told[at]}</output></label>'
                         f'<p id="{name}-told" aria-live="polite">{frames[at][f"{name}-told"]}</p></figure>')
        data[name] = {"told": told, "frames": frames}
    return figures, "// SPDX-License-Identifier: Apache-2.0\nconst played = " + json.dumps(data, ensure_ascii=False, separators=(",", ":")) + ";\n"
