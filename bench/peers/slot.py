#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""SLOT with a constant limit of 12 under u = sin(2 pi t) as a script with NumPy has it, in a plain loop or in
one that numba compiles.

usage: slot.py python|numba N [OUT.csv]

Ten increments are one cycle, more are a hundred. The last line is the end state, as JSON.
"""
import json
import sys

import numpy as np


def loop(u, stiffness, limit, f, slip, s):
    force = slipped = accumulated = 0.0
    for i in range(1, len(u)):
        trial = force + stiffness * (u[i] - u[i - 1])
        size = abs(trial)
        if size > limit:
            passed = (size - limit) / stiffness
            sense = 1.0 if trial > 0 else -1.0
            force = sense * limit
            slipped += sense * passed
            accumulated += passed
        else:
            force = trial
        f[i] = force
        slip[i] = slipped
        s[i] = accumulated
    return force, slipped, accumulated


def main():
    kind, steps = sys.argv[1], int(sys.argv[2])
    t = np.linspace(0.0, 1.0 if steps == 10 else 100.0, steps + 1)
    u = np.sin(2 * np.pi * t)
    if kind == "numba":
        import numba
        f, slip, s = np.zeros((3, steps + 1))
        end = numba.njit(cache=True)(loop)(u, 1e4, 12.0, f, slip, s)
    else:  # lists: the elements of an array take twice as long
        f, slip, s = ([0.0] * (steps + 1) for _ in range(3))
        end = loop(u.tolist(), 1e4, 12.0, f, slip, s)
    if len(sys.argv) > 3:
        np.savetxt(sys.argv[3], np.column_stack([t, u, f, slip, s]), delimiter=",", fmt="%.17g",
                   header="t,u,force,slip,accumulated", comments="")
    print(json.dumps(dict(zip(("f", "slip", "s"), end))))


if __name__ == "__main__":
    main()
