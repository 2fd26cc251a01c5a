#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Races 'slipbench calibrate' against scipy.optimize.least_squares, whole process against whole process.

usage: bench/calibrate_scipy.py [SLIPBENCH] [--rounds N] [--rows N]

A plane that slides along two directions for ten seconds, 10 000 increments, both friction forces
measured with noise of a standard deviation of 1: first with 4 unknowns (stick stiffness, static and
kinetic coefficient, characteristic rate), then with 20 (a table of 12 coefficients over the slip
rate, one of 8 internal contact forces over the accumulated slip). Both programs read the same files
and start at the same values. The peer is timed twice: compiling its loop, as a script does that runs
for the first time, and with the compiled loop from numba's cache. Prints the best time of each, the
ratios, and both sums of squares; ends with 1 if these differ by more than 1e-6.

Needs python3 with numpy, scipy and numba (Debian: python3-scipy python3-numba).
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

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


def load_peer():
    """What only the peer needs, imported late: the time of it is the peer's."""
    import numba
    import numpy as np

    @numba.njit(cache=True)
    def loop(stiffness, limit_factor, internal, slips, wears, d2, d3, f1):
        """Forces of backward Euler; limit_factor is the coefficient of every increment."""
        n = len(d2)
        force = np.zeros((2, n))
        a = b = slip = 0.0
        j = 0
        for i in range(1, n):
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
            force[0, i] = a
            force[1, i] = b
        return force

    return np, loop


def make_model(count, history):
    np, loop = load_peer()
    t, u2, u3, f1 = history
    d2 = np.diff(u2, prepend=u2[0])
    d3 = np.diff(u3, prepend=u3[0])
    rate = np.concatenate([[0.0], np.hypot(d2[1:], d3[1:]) / np.diff(t)])
    rates = np.array(RATES, float)
    slips = np.array(SLIPS, float)

    def model(x):
        if count == 4:
            k, static, kinetic, v = x
            mu = kinetic + (static - kinetic) * np.exp(-rate / v)
            return loop(k, mu, np.array([CONSTANT_LOAD]), slips, False, d2, d3, f1)
        mu = np.interp(rate, rates, x[:12])
        return loop(STIFFNESS, mu, np.ascontiguousarray(x[12:]), slips, True, d2, d3, f1)

    return np, model


def truth_and_start(count):
    if count == 4:
        truth = [2000.0, 0.30, 0.18, 2.0]
        return truth, [truth[0] * 0.6, truth[1] * 1.3, truth[2] * 0.6, truth[3] * 2.0]
    truth = [0.18 + 0.12 * math.exp(-r / 2) for r in RATES]
    truth += [100 - 40 * (1 - math.exp(-s / 10)) for s in SLIPS]
    return truth, [0.25] * 12 + [50.0] * 8


def peer(folder, count):
    """The peer's whole process: reads the files, fits, prints its sum of squares."""
    import scipy.optimize

    np = __import__("numpy")
    history = np.loadtxt(folder / "history.csv", delimiter=",", skiprows=1).T
    data = np.loadtxt(folder / f"data{count}.csv", delimiter=",", skiprows=1).T
    _, model = make_model(count, history)
    start = np.array(truth_and_start(count)[1])

    def residuals(x):
        return (model(x) - data[1:]).ravel()

    # Of its methods the fastest here.
    found = scipy.optimize.least_squares(residuals, start, method="lm", x_scale=start)
    print(json.dumps({"squares": 2 * found.cost, "x": list(found.x)}))


def write_files(folder, rows):
    import numpy as np

    t = np.arange(rows + 1) * (10.0 / rows)
    w = 2 * np.pi
    amplitude = 0.3 + 0.07 * t
    history = np.array([t, amplitude * np.sin(w * t), 0.5 * amplitude * np.sin(1.37 * w * t + 0.3),
                        500 + 200 * np.sin(0.31 * w * t)])
    np.savetxt(folder / "history.csv", history.T, fmt="%.17g", delimiter=",", header="t,u2,u3,f1",
               comments="")
    for count in (4, 20):
        truth, start = truth_and_start(count)
        np, model = make_model(count, history)
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


def timed(command, folder, cache=None):
    begin = time.perf_counter()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True,
                          env={**os.environ, "NUMBA_CACHE_DIR": str(cache or folder)})
    elapsed = time.perf_counter() - begin
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n"
                 f"{done.stdout}{done.stderr}")
    return elapsed, done.stdout


def race(slipbench, rounds, rows):
    agree = True
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        os.environ["NUMBA_CACHE_DIR"] = name  # else it would write beside this file
        write_files(folder, rows)
        for count in (4, 20):
            ours, compiling, cached = [], [], []
            peer_command = [sys.executable, __file__, "--peer", str(count), name]
            for _ in range(rounds):
                elapsed, _ = timed([slipbench, "calibrate", f"fit{count}.yaml", "--no-output"],
                                   folder)
                ours.append(elapsed)
                with tempfile.TemporaryDirectory() as cache:
                    compiling.append(timed(peer_command, folder, cache)[0])
                    elapsed, text = timed(peer_command, folder, cache)
                    cached.append(elapsed)
            timed([slipbench, "calibrate", f"fit{count}.yaml"], folder)
            result = json.loads((folder / f"fit{count}.json").read_text())
            squares = 2 * result["result"]["cost"]
            peer_squares = json.loads(text)["squares"]
            difference = squares / peer_squares - 1
            agree = agree and abs(difference) <= 1e-6
            best = min(ours)
            print(f"{count} unknowns, {2 * (rows + 1)} points: slipbench {1e3 * best:.1f} ms; scipy + numba "
                  f"{1e3 * min(compiling):.0f} ms ({min(compiling) / best:.0f} times), compiled before "
                  f"{1e3 * min(cached):.0f} ms ({min(cached) / best:.0f} times); sums of squares "
                  f"{squares:.6f} and {peer_squares:.6f} (relative difference {difference:.1e})")
    return 0 if agree else 1


def main():
    if len(sys.argv) == 4 and sys.argv[1] == "--peer":
        peer(pathlib.Path(sys.argv[3]), int(sys.argv[2]))
        return 0
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("slipbench", nargs="?", default="build/release/slipbench")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--rows", type=int, default=10000)
    options = parser.parse_args()
    return race(str(pathlib.Path(options.slipbench).resolve()), options.rounds, options.rows)


if __name__ == "__main__":
    sys.exit(main())
