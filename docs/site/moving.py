#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the moving picture of README.md: moving.py SLIPBENCH [FILE]

The case that README.md shows is run, and its rows are played at half speed: the shaft in its sleeve, the loop of friction force over travel, the
force over time with slip shaded. Who wants no motion sees the whole loop. FILE is docs/images/shaft.svg, which a test holds against
the program's rows.
"""
import itertools
import math
import pathlib
import re
import sys
import tempfile

from drawing import Axes, number, path, rows_of

ROOT = pathlib.Path(__file__).resolve().parents[2]
WIDTH, HEIGHT = 840, 436
SECONDS, REST = 10.0, 1.5  # for all rows, and for looking at the last one
RADIUS, LENGTH, MILLIMETRE = 12, 40, 4.4  # of shaft and sleeve, as in the case; on the paper
BLUE, DARK, RED, SHADE, INK = "#1f77b4", "#16324f", "#c0392b", "#dcdcdc", "#444"


def rows_of_readme(program):
    """The rows that README's case gives."""
    case = re.search(r"^```yaml case (\S+)\n(.*?)^```", (ROOT / "README.md").read_text(), re.MULTILINE | re.DOTALL)
    assert f"R: {RADIUS}, L: {LENGTH}" in case[2], "README's case has another shaft than the picture"
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / case[1]
        file.write_text(case[2])
        return rows_of(program, file)


class Player:
    """Keyframes over the times of rows, as a style sheet."""

    def __init__(self, end):
        self.end, self.rules = end, []

    def play(self, name, frames, steps=False):
        """Plays declarations [(time, text)] on the element called so. What stays the same is said twice, at its begin and end."""
        told = [frame for before, frame, after in zip([None, *frames], frames, [*frames[1:], None])
                if before is None or after is None or not before[1] == frame[1] == after[1]]
        keys = "".join(f"{100 * time / self.end * SECONDS / (SECONDS + REST):.2f}%{{{text}}}" for time, text in told)
        timing = "step-end" if steps else "linear"
        self.rules.append(f"@keyframes {name}{{{keys}100%{{{told[-1][1]}}}}}#{name}{{animation:{name} {SECONDS + REST}s {timing} infinite}}")


def joint(player, rows):
    """The shaft in its sleeve, cut open: it slides and turns, and where it rubs it is orange while it slips."""
    x, y, half = 190, 118, LENGTH * MILLIMETRE / 2
    r, reach = RADIUS * MILLIMETRE, half + 52
    parts = ['<defs><pattern id="cut" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">'
             '<rect width="7" height="7" fill="#e3e6e8"/><path d="M0 0v7" stroke="#90999f"/></pattern>'
             f'<clipPath id="round"><rect x="{-reach:g}" y="{-r:g}" width="{2 * reach:g}" height="{2 * r:g}"/></clipPath></defs>']
    for edge in (y - r - 30, y + r + 6):
        parts.append(f'<rect x="{x - half:g}" y="{number(edge)}" width="{2 * half:g}" height="24" fill="url(#cut)" stroke="#37474f"/>')
    parts.append('<g id="rubs" fill="#e8862e">' + "".join(f'<rect x="{x - half:g}" y="{number(edge)}" width="{2 * half:g}" height="6"/>' for edge in (y - r - 6, y + r)) + "</g>")
    player.play("rubs", [(row["t"], f"fill:{'#e8862e' if row['STATUS'] == 2 else '#86afd9'}") for row in rows], steps=True)
    lines = []
    for k in range(8):
        # A line along the shaft, at its own angle; the back of the shaft is not seen.
        frames = []
        for row in rows[::3] + rows[-1:]:
            angle = row["CPR1"] + k * math.pi / 4
            frames.append((row["t"], f"transform:translateY({number(r * math.sin(angle))}px);opacity:{1 if math.cos(angle) > 0 else 0}"))
        player.play(f"line{k}", frames)
        lines.append(f'<path id="line{k}" d="M{-reach:g} 0H{reach:g}" stroke="#436c9a" style="{frames[-1][1]}"/>')
    parts.append(f'<g transform="translate({x} {y})"><g id="shaft"><rect x="{-reach:g}" y="{number(-r)}" width="{2 * reach:g}" height="{2 * r:g}" rx="4" '
                 f'fill="#a9c9ea" stroke="#37474f"/><g clip-path="url(#round)">{"".join(lines)}</g></g></g>')
    player.play("shaft", [(row["t"], f"transform:translateX({number(MILLIMETRE * row['CP1'])}px)") for row in rows])
    parts.append(f'<g transform="translate({x} {y + r + 48})"><path id="force" d="M0 -3h92v-5l14 8l-14 8v-5h-92z" fill="{RED}" '
                 f'style="transform:scaleX({rows[-1]["CSF1"] / limit_of(rows):.3f})"/></g>')
    player.play("force", [(row["t"], f"transform:scaleX({row['CSF1'] / limit_of(rows):.3f})") for row in rows])
    parts.append(f'<text x="{x - half:g}" y="{y + r + 76:g}">what it takes to push the shaft</text>')
    parts.append(f'<rect x="{x - half:g}" y="12" width="12" height="12" fill="#86afd9"/><text x="{x - half + 17:g}" y="22">sticks</text>'
                 f'<rect x="{x - half + 68:g}" y="12" width="12" height="12" fill="#e8862e"/><text x="{x - half + 85:g}" y="22">slips</text>')
    return parts


def limit_of(rows):
    return max(row["FLIM"] for row in rows)


def loop(player, rows, frames):
    """The friction force over the travel, traced step by step."""
    limit = limit_of(rows)
    axes = Axes(450, 24, 366, 190, (-6, 6), (-1.15 * limit, 1.15 * limit))
    parts = axes.frame((-5, 0, 5), (-50, 0, 50), ("travel of the shaft CP1 [mm]", "friction CSF1 [N]"), INK)
    for force in (limit, -limit):
        parts.append(f'<path d="{path([axes.at(-6, force), axes.at(6, force)])}" stroke="{RED}" stroke-dasharray="5 5"/>')
    parts.append(f'<text x="{axes.across(6):g}" y="{number(axes.down(limit) - 5)}" text-anchor="end" fill="{RED}">limit {limit:g} N</text>')

    def place(row):
        return axes.at(row["CP1"], row["CSF1"])
    shown = {row["t"] for row in frames}
    for k, (colour, begin, end) in enumerate(((BLUE, 1, 3), (DARK, 3, 5))):
        step = [row for row in rows if begin - 1e-9 <= row["t"] <= end + 1e-9]
        points = [place(row) for row in step]
        way = list(itertools.accumulate((math.dist(a, b) for a, b in itertools.pairwise(points)), initial=0.0))
        whole = math.ceil(way[-1]) + 1
        parts.append(f'<path d="{path(points)}" fill="none" stroke="#e6e6e6" stroke-width="2"/>')
        parts.append(f'<path id="trace{k}" d="{path(points)}" fill="none" stroke="{colour}" stroke-width="2" stroke-dasharray="{whole}"/>')
        player.play(f"trace{k}", [(0.0, f"stroke-dashoffset:{whole}"),
                                  *((row["t"], f"stroke-dashoffset:{number(whole - done)}") for row, done in zip(step, way) if row["t"] in shown)])
        parts.append(f'<text x="{number(axes.across(2.6))}" y="{number(axes.down(50 if k == 0 else 15))}" text-anchor="middle" fill="{colour}">{("stroke", "stroke and turn")[k]}</text>')
    x, y = place(rows[-1])
    parts.append(f'<circle id="here" r="4.5" fill="{RED}" style="transform:translate({number(x)}px,{number(y)}px)"/>')
    player.play("here", [(row["t"], "transform:translate({}px,{}px)".format(*map(number, place(row)))) for row in frames])
    return parts


def history(player, rows):
    """The friction force over time, slip shaded."""
    end, limit = rows[-1]["t"], limit_of(rows)
    axes = Axes(62, 292, 754, 96, (0, end), (-1.2 * limit, 1.2 * limit))
    parts = []
    for slips, run in itertools.groupby(itertools.pairwise(rows), lambda pair: pair[1]["STATUS"] == 2):
        run = list(run)
        if slips:
            begin, stop = axes.across(run[0][0]["t"]), axes.across(run[-1][1]["t"])
            parts.append(f'<rect x="{number(begin)}" y="{axes.top}" width="{number(stop - begin)}" height="{axes.height}" fill="{SHADE}"/>')
    parts += axes.frame(range(int(end) + 1), (-50, 0, 50), ("time t [s]", "CSF1 [N]"), INK)
    for sign in (1, -1):
        parts.append(f'<path d="{axes.curve((row["t"], sign * row["FLIM"]) for row in rows)}" fill="none" stroke="{RED}" stroke-dasharray="5 5"/>')
    parts.append(f'<path d="{axes.curve((row["t"], row["CSF1"]) for row in rows)}" fill="none" stroke="{BLUE}" stroke-width="2"/>')
    parts.append(f'<path id="now" d="M{axes.left} {axes.top}v{axes.height}" stroke="#111" style="transform:translateX({axes.width}px)"/>')
    player.play("now", [(row["t"], f"transform:translateX({number(axes.across(row['t']) - axes.left)}px)") for row in (rows[0], rows[-1])])
    return parts


def draw(program):
    """The picture as a text."""
    rows = rows_of_readme(program)
    # Every fourth row will do between the changes of stick and slip; the curves are of all.
    frames = [row for n, row in enumerate(rows) if n % 4 == 0 or n + 1 == len(rows) or not rows[n - 1]["STATUS"] == row["STATUS"] == rows[n + 1]["STATUS"]]
    player = Player(rows[-1]["t"])
    parts = [*joint(player, frames), *loop(player, rows, frames), *history(player, rows)]
    style = "@media (prefers-reduced-motion:no-preference){" + "".join(player.rules) + "}"
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" font-family="system-ui,sans-serif" font-size="13">\n'
            f'<style>{style}</style>\n<rect width="{WIDTH}" height="{HEIGHT}" rx="6" fill="#fff"/>\n' + "\n".join(parts) + "\n</svg>\n")


def main(program, file=ROOT / "docs/images/shaft.svg"):
    pathlib.Path(file).write_text(draw(program))


if __name__ == "__main__":
    main(*sys.argv[1:])
