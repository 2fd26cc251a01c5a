#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The plane of plane.py for all combinations of LEVELS values of three numbers, vectorised over the cases with NumPy,
an increment at a time. Prints the means of the end states as JSON.

usage: sweep.py LEVELS STEPS
"""
import json
import sys

import numpy as np

from plane import GRIP, MU, RATE, SLIP, STIFFNESS, TEMPERATURE

levels, steps = int(sys.argv[1]), int(sys.argv[2])
turn = 2 * np.pi
t = np.arange(steps + 1) * 1e-3
u2 = np.sin(turn * t)
u3 = 0.5 * np.sin(turn * 1.37 * t + 0.3)
f1 = 500 + 200 * np.sin(turn * 0.31 * t)
temperature = 60 + 40 * np.sin(turn * 0.05 * t)
stiffness, factor, grip = (values.ravel() for values in np.meshgrid(
    STIFFNESS * np.linspace(0.9, 1.1, levels), np.linspace(0.8, 1.2, levels), np.linspace(0.9, 1.1, levels),
    indexing="ij"))
f2, f3, s = np.zeros((3, levels**3))
for i in range(1, steps + 1):
    d2 = u2[i] - u2[i - 1]
    d3 = u3[i] - u3[i - 1]
    rate = np.hypot(d2, d3) / (t[i] - t[i - 1])
    mu = np.interp(temperature[i], TEMPERATURE, [np.interp(rate, RATE, row) for row in MU])
    x = f2 + stiffness * d2
    y = f3 + stiffness * d3
    size = np.sqrt(x * x + y * y)
    over = np.maximum(size - factor * mu * np.abs(f1[i] + grip * np.interp(s, SLIP, GRIP)), 0.0)
    share = (size - over) / np.maximum(size, 1e-300)
    f2 = x * share
    f3 = y * share
    s += over / stiffness
print(json.dumps({"f2": f2.mean(), "s": s.mean()}))
