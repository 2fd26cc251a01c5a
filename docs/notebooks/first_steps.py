# SPDX-License-Identifier: Apache-2.0
# %% [markdown]
# # First steps
#
# A block on a rail is pressed down with 100 N and pushed to and fro. How large is the friction force, where does the block stick, and
# where does the work go?

# %%
import matplotlib.pyplot as plt

import slipbench

# %% [markdown]
# ## A case
#
# A case says what is joined, what rubs and how it is moved. It is a file, or, as here, a text; a `dict` with the same keys does as well.
# Connector SLOT slides along direction 1. Direction 2 is held, and what is held is loaded: 100 N press the block onto its rail.

# %%
case = slipbench.load("""
slipbench: 1
title: Block on a rail
units: {length: mm, force: N, time: s}
parameters: {mu: 0.2, press: 100, give: 0.02}
connector: {type: SLOT}
friction:
  - {predefined: {}, coefficient: = mu, stick: {elastic_slip: = give}}
history:
  - {step: cycles, duration: 2, increments: 400, force: {f2: = press}, motion: {CP1: {sine: {amplitude: 0.1, period: 1}}}}
""")
case

# %%
run = case.run()
run

# %% [markdown]
# ## Its columns
#
# A run is a mapping from the names of columns to NumPy arrays. `CP1` is the position, `CSF1` the friction force, `FLIM` its limit.
# `run.texts` says what each column is, `run.units` in what unit.

# %%
for name in ("CP1", "CSF1", "FLIM", "DISS"):
    print(f"{name:5} {run.units[name]:5} {run.texts[name]:40} largest {run[name].max():8.4f}")

# %% [markdown]
# The force grows with the elastic give of the contact, until it meets the limit $\mu N$ = 20 N. Then the block slips, until the motion
# turns. `run.plot()` draws the force over time, with slip shaded, and the loop that it makes over the motion.

# %% Friction force between its limits over time, slip shaded, and the loop of force over displacement
run.plot();

# %%
assert abs(run["CSF1"]).max() <= 20 * (1 + 1e-12)

# %% [markdown]
# ## When does it slip?
#
# Events say when stick and slip change. Their times are interpolated within the increments, so that they do not depend on how fine these
# are chosen.

# %%
for event in run.events[:4]:
    print(f"t = {event.time:.4f} s, at {event.positions['CP1']:+.3f} mm: {event.origin:5} -> {event.goal:5} at {event.force:+.1f} N")

# %% [markdown]
# The first slip begins where the motion has used up the give of 0.02 mm. After a turn it takes twice as much, since the contact
# has to be unloaded first: from 0.1 mm it slips at 0.06 mm.

# %%
assert abs(run.events[0].positions["CP1"] - 0.02) < 1e-9
assert abs(run.events[2].positions["CP1"] - (0.1 - 2 * 0.02)) < 1e-9

# %% [markdown]
# ## Other numbers
#
# The parameters of a case can be changed, one by one or all at once. `with_parameters` gives a copy and leaves the case as it was. All
# these runs are a matter of milliseconds.

# %% Loops of force over displacement for three coefficients: the larger the coefficient, the higher the loop
figure, axes = plt.subplots(figsize=(5.6, 3.6))
for mu in (0.1, 0.2, 0.3):
    loop = case.with_parameters(mu=mu).run()
    axes.plot(loop["CU1"], loop["CSF1"], label=f"coefficient {mu}")
axes.set(xlabel="displacement [mm]", ylabel="friction force [N]")
axes.legend(loc="center left", bbox_to_anchor=(1, 0.5));

# %% [markdown]
# A loop of height $2\mu N$ that slips the way $4(a - g)$ in a cycle, with the amplitude $a$ and the give $g$, dissipates
# $4\mu N(a - g)$. The second cycle does so:

# %%
mu, press, give, amplitude = 0.2, 100, 0.02, 0.1
second_cycle = run["DISS"][-1] - run["DISS"][200]
print(f"run {second_cycle:.4f} N mm, formula {4 * mu * press * (amplitude - give):.4f} N mm")
assert abs(second_cycle - 4 * mu * press * (amplitude - give)) < 1e-9

# %% [markdown]
# ## Where does the work go?
#
# Work done on the block is heat, but for the little that the elastic contact holds and gives back at each turn. Nothing is lost on the
# way: that is a test of the integration, and every run tells it.

# %% Energy over time: heat grows while the block slips and rests while it sticks; on top of it the little that is stored in the contact
t, heat, stored, work = (run[name][:201] for name in ("t", "DISS", "STRAIN_E", "WORK"))   # the first cycle
figure, axes = plt.subplots()
axes.stackplot(t, heat, stored, colors=["#c9d8ea", "#e6a49f"], labels=["heat", "stored in the contact"])
axes.plot(t, work, color="#0b1a33", linewidth=1.0, linestyle="--", label="work done on the block")
axes.set(xlabel="time [s]", ylabel="energy [N mm]", xlim=(0, 1), ylim=(0, None))
axes.legend(loc="upper left");

# %%
gap = abs(run["WORK"] - run["DISS"] - run["STRAIN_E"]).max() / run["WORK"].max()
print("work = heat + stored energy", "to rounding" if gap < 1e-12 else "with a gap")
assert gap < 1e-12

# %% [markdown]
# ## On from here
#
# `run.to_pandas()` and `run.to_xarray()` hand the columns on, with their units. What is wrong in a case is told with its line, and what
# would be right:

# %%
try:
    case.parameters["mu"] = -0.2
except slipbench.CaseError as error:
    print(error)

# %% [markdown]
# [import slipbench](../guide/python.md) has all of it; the next notebook, [sweep](sweep.md), runs a case with hundreds of numbers.
