# SPDX-License-Identifier: Apache-2.0
# %% [markdown]
# # A fit with SciPy, and with the bench
#
# The coefficient of a brake pad falls with the slip rate. A rig has measured the force; wanted is the table of the coefficient at five
# slip rates. `scipy.optimize.least_squares` can find it, as a run is a function of numbers. `slipbench.calibrate` can as well. Do they
# agree, and what does each ask for?

# %%
import pathlib
import tempfile

import matplotlib.pyplot as plt
import numpy
from scipy.optimize import least_squares

import slipbench

text = """
slipbench: 1
title: Pad on a disc
units: {length: mm, force: N, time: s}
parameters: {mu_0: 0.3, mu_5: 0.3, mu_20: 0.3, mu_60: 0.3, mu_120: 0.3}
connector: {type: SLOT}
friction:
  - name: pad
    predefined: {}
    coefficient: {columns: [mu, slip_rate], rows: [[= mu_0, 0], [= mu_5, 5], [= mu_20, 20], [= mu_60, 60], [= mu_120, 120]]}
    stick: {elastic_slip: 0.05}
history:
  - {step: strokes, duration: 2, increments: 800, force: {f2: 1000}, motion: {CP1: {sine: {amplitude: 20, period: 1}}}}
"""
case = slipbench.load(text)
speeds = [0, 5, 20, 60, 120]
names = [f"mu_{speed}" for speed in speeds]

# %% [markdown]
# ## The measurement
#
# It is made here, so that the truth is known: a run with numbers that neither fit is told, every fourth row of it, and noise of 4 N.

# %%
truth = numpy.array([0.42, 0.37, 0.30, 0.26, 0.25])
noise = 4.0
rig = case.with_parameters(**dict(zip(names, truth))).run(every=4)
measured = rig["CSF1"] + numpy.random.default_rng(3).normal(0, noise, len(rig["t"]))

# %% [markdown]
# ## SciPy
#
# The residual is a run with other numbers, minus what was measured. That is all; whatever else a run depends on, or a loss of one's own,
# is a line of Python more.


# %%
def residual(values):
    """What is left of the measurement, in standard deviations of its noise."""
    run = case.with_parameters(**dict(zip(names, values))).run(every=4)
    return (run["CSF1"] - measured) / noise


found = least_squares(residual, x0=[0.3] * 5, bounds=(0, 1))
freedom = len(measured) - len(names)
scale = numpy.sqrt(2 * found.cost / freedom)   # of the noise that is left over the noise that was said
errors = scale * numpy.sqrt(numpy.diag(numpy.linalg.inv(found.jac.T @ found.jac)))
for name, value, error in zip(names, found.x, errors):
    print(f"{name:6} {value:.4f} +- {error:.4f}")

# %% [markdown]
# ## The bench
#
# `slipbench.calibrate` reads a fit file with the case and the data beside it, as the program does. The rest is its own: derivatives,
# errors, and which of the numbers the data tell at all.

# %%
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    (folder / "pad.yaml").write_text(text)
    (folder / "rig.csv").write_text("t,F\n" + "".join(f"{t},{F}\n" for t, F in zip(rig["t"], measured)))
    (folder / "fit.yaml").write_text("""slipbench: 1
title: Coefficient of the pad
calibrate:
  experiments:
    - {case: pad.yaml, data: rig.csv, time: t, compare: {CSF1: {column: F, sigma: 4}}}
  tables: {pad.coefficient: {bounds: [0, 1]}}
""")
    fit = slipbench.calibrate(folder / "fit.yaml")
own = numpy.array([one.value for one in fit.estimates.values()])
own_errors = numpy.array([one.standard_error for one in fit.estimates.values()])
print("converged:", fit.converged, "-", fit.reason)
for speed, one in zip(speeds, fit.estimates.values()):
    print(f"mu at {speed:3} mm/s {one.value:.4f} +- {one.standard_error:.4f}, {one.identifiability}")

# %% [markdown]
# ## Do they agree?
#
# They minimise the same sum of squares, and end at the same place: the difference is far below what the noise leaves open. The errors
# are the same, too.

# %%
apart = abs(own - found.x) / own_errors
print("apart by less than a ten-thousandth of the standard error:", bool((apart < 1e-4).all()))
assert fit.converged and found.success
assert (apart < 1e-4).all()
numpy.testing.assert_allclose(own_errors, errors, rtol=1e-3)
assert (abs(own - truth) < 4 * own_errors).all()

# %% Above, force over position: measured dots on the fitted loop, unlike the start, which is flat; below, what is left, without a shape
figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(6.8, 4.6), gridspec_kw={"height_ratios": [3, 1]})
fitted = case.with_parameters(**dict(zip(names, own))).run()
start = case.run()
above.plot(rig["CP1"], measured, ".", color="#8a94a6", markersize=4, label="measured")
above.plot(start["CP1"], start["CSF1"], "--", color="#3a7d44", linewidth=1.0, label="start")
above.plot(fitted["CP1"], fitted["CSF1"], label="fitted")
above.legend(loc="center left", bbox_to_anchor=(0.1, 0.5))
above.set(ylabel="friction force [N]")
below.plot(rig["CP1"], measured - fitted["CSF1"][::4], ".", color="#8a94a6", markersize=4)
below.axhline(0, color="#0b1a33", linewidth=0.8)
below.set(xlabel="position [mm]", ylabel="what is left [N]");

# %% [markdown]
# ## What was found
#
# Bars are 95 % intervals, drawn ten times as long. They are wider where the pad is slow: few rows of the measurement are.

# %% Coefficient over slip rate: both answers lie on each other and close to the truth; the bars are longest at low rates
figure, axes = plt.subplots()
axes.plot(speeds, truth, color="#8a94a6", label="truth")
axes.errorbar(speeds, found.x, 10 * 1.96 * errors, fmt="o", markersize=8, markerfacecolor="none", color="#1f5fa8", linewidth=1.0, label="SciPy")
axes.errorbar(speeds, own, 10 * 1.96 * own_errors, fmt="x", markersize=6, color="#b3261e", linewidth=1.0, label="slipbench.calibrate")
axes.set(xlabel="slip rate [mm/s]", ylabel="coefficient of friction", ylim=(0.2, 0.5))
axes.legend(loc="upper right");

# %% [markdown]
# ## Which of the two?
#
# - *Time.* Here both take a few hundredths of a second. With a hundred times the increments SciPy took about six times as long as the
#   bench, on two cores: it differences whole runs, six for each of its steps, while the bench has exact derivatives of this case. Where
#   it has none it differences runs as well, and the advantage goes.
# - *Freedom.* SciPy takes any residual: two cases in one, a quantity that no column has, a prior. The fit file knows units, cleaning of
#   data, loops over position, hold-outs, monotone tables; a prior it does not know.
# - *What is told.* The bench names numbers that no data visit, and writes the case with the values found: `fit.case()` runs it.
#   With SciPy that is up to you: with an ordinate beyond the fastest stroke $J^T J$ is singular, and the lines above give no errors.
#
# [Calibration](../guide/calibration.md) is the page on fits.
