#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""SLIDE-PLANE with two tables as a script with NumPy has it, in a plain loop or in one that numba compiles: mu over
the rate of the motion and the temperature, the grip over the accumulated slip at the start of the increment.

usage: plane.py python|numba IN.csv OUT.csv     a measured history in, twelve columns out
       plane.py python|numba N                  the loop alone on N increments, timed within the process
The last line is the end state, as JSON.
"""
import json
import math
import sys
import time
from bisect import bisect_right

import numpy as np

RATE = [0, 0.5, 1, 2, 5, 10, 20, 50]
TEMPERATURE = [0, 50, 100, 200]
MU = [[.30, .27, .25, .23, .20, .18, .17, .16], [.28, .25, .235, .22, .19, .175, .165, .155],
      [.25, .23, .215, .20, .18, .165, .155, .15], [.20, .19, .18, .17, .16, .15, .145, .14]]
SLIP = [0, 5, 10, 20, 50, 100, 500, 1000]
GRIP = [100, 98, 95, 90, 80, 72, 60, 55]
STIFFNESS = 2e3


def find(x, value):
    return bisect_right(x, value)


def line(x, y, value):
    if value <= x[0]:
        return y[0]
    if value >= x[-1]:
        return y[-1]
    i = find(x, value) - 1
    return y[i] + (y[i + 1] - y[i]) * (value - x[i]) / (x[i + 1] - x[i])


def loop(rows, out, rates, temperatures, table, slips, grips):
    f2 = f3 = s = 0.0
    for i in range(1, len(rows)):
        now = rows[i]
        before = rows[i - 1]
        d2 = now[1] - before[1]
        d3 = now[2] - before[2]
        x = f2 + STIFFNESS * d2
        y = f3 + STIFFNESS * d3
        size = math.sqrt(x * x + y * y)
        rate = math.sqrt(d2 * d2 + d3 * d3) / (now[0] - before[0])
        j = min(max(find(temperatures, now[4]) - 1, 0), len(temperatures) - 2)
        low = line(rates, table[j], rate)
        high = line(rates, table[j + 1], rate)
        mu = low + (high - low) * (now[4] - temperatures[j]) / (temperatures[j + 1] - temperatures[j])
        normal = abs(now[3] + line(slips, grips, s))
        limit = mu * normal
        slipping = 0.0
        if size > limit:
            x = x * limit / size
            y = y * limit / size
            s += (size - limit) / STIFFNESS
            size = limit
            slipping = 1.0
        f2 = x
        f3 = y
        row = out[i]
        row[0] = f2
        row[1] = f3
        row[2] = s
        row[3] = mu
        row[4] = normal
        row[5] = slipping
        row[6] = size
    return f2, f3, s


def compiled():
    """Returns the loop as numba compiles it, and keeps what it compiled."""
    import numba

    global find, line

    @numba.njit(cache=True)
    def find(x, value):
        return np.searchsorted(x, value, side="right")

    line = numba.njit(cache=True)(line)
    fast = numba.njit(cache=True)(loop)
    tables = [np.array(values, float) for values in (RATE, TEMPERATURE, MU, SLIP, GRIP)]

    def run(rows):
        out = np.zeros((len(rows), 7))
        return fast(rows, out, *tables), out

    return run


def plain(rows):
    out = [[0.0] * 7 for _ in rows]
    return loop(rows.tolist(), out, RATE, TEMPERATURE, MU, SLIP, GRIP), out


def main():
    run = compiled() if sys.argv[1] == "numba" else plain
    seconds = 0.0
    if len(sys.argv) == 3:
        turn = 2 * np.pi
        t = np.linspace(0.0, 100.0, int(sys.argv[2]) + 1)
        rows = np.column_stack([t, np.sin(turn * t), 0.5 * np.sin(turn * 1.37 * t + 0.3),
                                500 + 200 * np.sin(turn * 0.31 * t), 60 + 40 * np.sin(turn * 0.05 * t)])
        run(rows[:3])
        begin = time.perf_counter()
        end, _ = run(rows)
        seconds = time.perf_counter() - begin
    else:
        rows = np.loadtxt(sys.argv[2], delimiter=",", skiprows=1)
        end, out = run(rows)
        np.savetxt(sys.argv[3], np.column_stack([rows, out]), delimiter=",", fmt="%.17g",
                   header="t,u2,u3,f1,T,f2,f3,s,mu,normal,slips,size", comments="")
    print(json.dumps({**dict(zip(("f2", "f3", "s"), end)), "seconds": seconds}))


if __name__ == "__main__":
    main()
