#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fits a plane that slides along two directions for ten seconds with scipy.optimize.least_squares; both friction forces
were measured with noise of a standard deviation of 1. First there are 4 unknowns (stick stiffness, static and kinetic
coefficient, characteristic rate), then 20 (a table of 12 coefficients over the slip rate, one of 8 internal contact
forces over the accumulated slip).

usage: calibrate.py write ROWS            writes data, cases and fits for `slipbench calibrate` into this folder
       calibrate.py python|numba 4|20     reads these files, fits, prints its sum of squares as JSON
"""
import json
import math
import pathlib
import sys

import numpy as np

RATES = [0, 0.3, 0.6, 1, 1.5, 2, 2.7, 3.5, 4.5, 5.5, 6.5, 8]
SLIPS = [0, 2, 4, 8, 12, 18, 25, 40]
STIFFNESS = 2000.0  # of the problem with 20 unknowns
CONSTANT_LOAD = 50.0  # internal contact force of the problem with 4

CASE = """slipbench: 1
units: {{length: mm, force: N, time: s}}
{parameters}connector: {{type: SLIDE-PLANE}}
friction:
  - name: plane
    predefined: {{internal_contact_force: {internal}}}
    coefficient: {coefficient}
    stick: {{stiffness: {stiffness}}}
integration: {{slip_rate: relative_motion, accumulated_slip: start}}
history: {{csv: history.csv, time: t, columns: {{CP2: u2, CP3: u3, f1: f1}}}}
"""
FIT = """slipbench: 1
calibrate:
  experiments:
    - {{case: case{count}.yaml, data: data{count}.csv, time: t, compare: {{CSF2: f2, CSF3: f3}}}}
  {what}
"""


def loop(stiffness, limit_factor, internal, slips, wears, d2, d3, f1, force):
    """Forces of backward Euler; limit_factor is the coefficient of every increment."""
    a = b = slip = 0.0
    j = 0
    for i in range(1, len(d2)):
        if wears:
            while j < len(slips) - 2 and slip > slips[j + 1]:
                j += 1
            share = (slip - slips[j]) / (slips[j + 1] - slips[j])
            load = internal[j] + (internal[j + 1] - internal[j]) * share
        else:
            load = internal[0]
        limit = limit_factor[i] * abs(load + f1[i])
        x = a + stiffness * d2[i]
        y = b + stiffness * d3[i]
        trial = math.sqrt(x * x + y * y)
        if trial > limit:
            a = x * limit / trial
            b = y * limit / trial
            slip += (trial - limit) / stiffness
        else:
            a = x
            b = y
        force[0][i] = a
        force[1][i] = b
    return force


def make_model(kind, count, history):
    """Returns the forces as a function of the unknowns; a plain loop is faster on lists."""
    t, u2, u3, f1 = history
    d2 = np.diff(u2, prepend=u2[0])
    d3 = np.diff(u3, prepend=u3[0])
    rate = np.concatenate([[0.0], np.hypot(d2[1:], d3[1:]) / np.diff(t)])
    rates = np.array(RATES, float)
    if kind == "numba":
        import numba

        run = numba.njit(cache=True)(loop)
        own = np.ascontiguousarray
    else:
        run = loop
        own = np.ndarray.tolist
    slips, d2, d3, f1 = (own(values) for values in (np.array(SLIPS, float), d2, d3, f1))

    def model(x):
        if count == 4:
            k, static, kinetic, v = map(float, x)
            mu = kinetic + (static - kinetic) * np.exp(-rate / v)
            internal = np.array([CONSTANT_LOAD])
        else:
            k = STIFFNESS
            mu = np.interp(rate, rates, x[:12])
            internal = x[12:]
        force = np.zeros((2, len(rate)))
        return np.array(run(k, own(mu), own(internal), slips, count != 4, d2, d3, f1,
                            force if kind == "numba" else force.tolist()))

    return model


def truth_and_start(count):
    if count == 4:
        truth = [2000.0, 0.30, 0.18, 2.0]
        return truth, [truth[0] * 0.6, truth[1] * 1.3, truth[2] * 0.6, truth[3] * 2.0]
    truth = [0.18 + 0.12 * math.exp(-r / 2) for r in RATES]
    truth += [100 - 40 * (1 - math.exp(-s / 10)) for s in SLIPS]
    return truth, [0.25] * 12 + [50.0] * 8


def fit(kind, count):
    import scipy.optimize

    history = np.loadtxt("history.csv", delimiter=",", skiprows=1).T
    data = np.loadtxt(f"data{count}.csv", delimiter=",", skiprows=1).T
    model = make_model(kind, count, history)
    start = np.array(truth_and_start(count)[1])

    def residuals(x):
        return (model(x) - data[1:]).ravel()

    # Of its methods the fastest here.
    found = scipy.optimize.least_squares(residuals, start, method="lm", x_scale=start)
    print(json.dumps({"squares": 2 * found.cost, "x": list(found.x)}))


def write_files(folder, rows):
    t = np.arange(rows + 1) * (10.0 / rows)
    w = 2 * np.pi
    amplitude = 0.3 + 0.07 * t
    history = np.array([t, amplitude * np.sin(w * t), 0.5 * amplitude * np.sin(1.37 * w * t + 0.3),
                        500 + 200 * np.sin(0.31 * w * t)])
    np.savetxt(folder / "history.csv", history.T, fmt="%.17g", delimiter=",", header="t,u2,u3,f1",
               comments="")
    for count in (4, 20):
        truth, start = truth_and_start(count)
        model = make_model("python", count, history)
        noise = np.random.default_rng(1).normal(0, 1, (2, rows + 1))
        noise[:, 0] = 0.0
        data = np.vstack([t, model(np.array(truth)) + noise])
        np.savetxt(folder / f"data{count}.csv", data.T, fmt="%.17g", delimiter=",",
                   header="t,f2,f3", comments="")
        if count == 4:
            names = ["k", "mu_s", "mu_k", "v"]
            parameters = ", ".join(f"{n}: {v!r}" for n, v in zip(names, start))
            case = CASE.format(
                parameters=f"parameters: {{{parameters}}}\n", internal=CONSTANT_LOAD,
                coefficient="{exponential_decay: {static: = mu_s, kinetic: = mu_k, decay: = 1/v}}",
                stiffness="= k")
            vary = ", ".join(f"{n}: {{bounds: [0, none]}}" for n in names)
            what = f"vary: {{{vary}}}"
        else:
            def table(name, over, knots, values):
                lines = ", ".join(f"[{v!r}, {k!r}]" for v, k in zip(values, knots))
                return f"{{columns: [{name}, {over}], rows: [{lines}]}}"

            case = CASE.format(
                parameters="", stiffness=STIFFNESS,
                internal=table("force", "accumulated_slip", SLIPS, start[12:]),
                coefficient=table("mu", "slip_rate", RATES, start[:12]))
            what = ("tables: {plane.coefficient: {free: mu}, "
                    "plane.internal_contact_force: {free: force}}")
        (folder / f"case{count}.yaml").write_text(case)
        (folder / f"fit{count}.yaml").write_text(FIT.format(count=count, what=what))


if __name__ == "__main__":
    if sys.argv[1] == "write":
        write_files(pathlib.Path.cwd(), int(sys.argv[2]))
    else:
        fit(sys.argv[1], int(sys.argv[2]))
