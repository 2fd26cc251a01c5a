# SPDX-License-Identifier: Apache-2.0
"""Curves in axes as SVG, of the rows of a run."""
import csv
import math
import pathlib
import subprocess


def rows_of(program, case, *words):
    """The rows that a run of a case file gives, each a map of its columns."""
    case = pathlib.Path(case)
    done = subprocess.run([pathlib.Path(program).resolve(), "run", case.name, "-o", "-", *words], cwd=case.parent, capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"slipbench run {case.name} {' '.join(words)}: {done.stderr}")
    table = csv.DictReader(line for line in done.stdout.splitlines() if not line.startswith("#"))
    return [{name: float(value) for name, value in row.items()} for row in table]


def number(value):
    """A length on the paper as a text."""
    return f"{round(value, 1) + 0.0:g}"


def path(points):
    return "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)


def thinned(points, off=0.1):
    """Points of which those are left out that lie on the line between others (Douglas and Peucker)."""
    points = list(points)
    kept, left = {0, len(points) - 1}, [(0, len(points) - 1)]
    while left:
        begin, end = left.pop()
        (x0, y0), (x1, y1) = points[begin], points[end]
        length = math.hypot(x1 - x0, y1 - y0)

        def far(k):
            x, y = points[k][0] - x0, points[k][1] - y0
            return abs(x * (y1 - y0) - y * (x1 - x0)) / length if length > off else math.hypot(x, y)
        worst = max(range(begin + 1, end), key=far, default=begin)
        if worst != begin and far(worst) > off:
            kept.add(worst)
            left += [(begin, worst), (worst, end)]
    return [points[k] for k in sorted(kept)]


class Axes:
    """A rectangle of the paper, and the ranges of x and y that it shows."""

    def __init__(self, left, top, width, height, x, y):
        self.left, self.top, self.width, self.height, self.x, self.y = left, top, width, height, x, y

    def across(self, x):
        return self.left + self.width * (x - self.x[0]) / (self.x[1] - self.x[0])

    def down(self, y):
        return self.top + self.height * (self.y[1] - y) / (self.y[1] - self.y[0])

    def at(self, x, y):
        return self.across(x), self.down(y)

    def curve(self, points):
        """The path of values (x, y)."""
        return path(thinned(self.at(x, y) for x, y in points))

    def frame(self, x_ticks, y_ticks, names, colour="currentColor"):
        """The lines to the left and below, with their ticks and names, as parts of a picture."""
        left, bottom = self.left, self.top + self.height
        parts = [f'<path d="M{left} {self.top}V{bottom}h{self.width}" fill="none" stroke="{colour}"/>']
        for value in x_ticks:
            at = number(self.across(value))
            parts.append(f'<path d="M{at} {bottom}v4" stroke="{colour}"/><text x="{at}" y="{bottom + 17}" text-anchor="middle">{value:g}</text>')
        for value in y_ticks:
            at = self.down(value)
            parts.append(f'<path d="M{left} {number(at)}h-4" stroke="{colour}"/><text x="{left - 7}" y="{number(at + 4)}" text-anchor="end">{value:g}</text>')
        parts.append(f'<text x="{left + self.width / 2:g}" y="{bottom + 35}" text-anchor="middle">{names[0]}</text>')
        beside = left - 20 - 8 * max(len(f"{value:g}") for value in y_ticks)
        parts.append(f'<text transform="translate({beside} {self.top + self.height / 2:g}) rotate(-90)" text-anchor="middle">{names[1]}</text>')
        return parts
