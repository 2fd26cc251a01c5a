# SPDX-License-Identifier: Apache-2.0
# %% [markdown]
# # A belt over a ring, and Euler's formula
#
# A rope lies around a bollard. Whoever holds one end with a small force holds a ship at the other: the tension grows along the wrap by
# $e^{\mu\alpha}$, with the coefficient $\mu$ and the wrap angle $\alpha$. Euler found it in 1769. Connector SLIPRING is such a rope.

# %%
import matplotlib.pyplot as plt
import numpy

import slipbench
from slipbench import closed_forms

case = slipbench.load("""
slipbench: 1
title: Rope on a bollard
units: {length: mm, force: N, time: s}
parameters: {mu: 0.2, turns: 0.5, hold: 100, k: 20}
connector: {type: SLIPRING, wrap_angle: = 2*pi*turns}
friction:
  - {predefined: {}, coefficient: = mu, stick: {stiffness: = k}}
history:
  - {step: haul, increments: 200, force: {f1: = hold}, motion: {CP2: {to: 12}}}
  - {step: veer, duration: 2, increments: 400, motion: {CP2: {to: -12}}}
  - {step: haul again, duration: 2, increments: 400, motion: {CP2: {to: 12}}}
""")

# %% [markdown]
# ## Haul and veer
#
# One end is held with 100 N. The rope is hauled over the bollard, let back, and hauled again: `CP2` is the flow of rope, `f_bc` the
# tension at the far end. The same numbers come from a closed form, which knows nothing of the law that the run integrates.

# %%
run = case.run()
exact = closed_forms.capstan(mu=0.2, wrap_angle=numpy.pi, stick_stiffness=20, flow=run["CP2"], tension=100)
worst = abs(run["f_bc"] - exact["tension_bc"]).max()
print("run and closed form agree", "to rounding" if worst < 1e-9 else f"but for {worst:.2g} N")
assert worst < 1e-9

# %% [markdown]
# While it slips one way the far end has $e^{\mu\alpha}$ times the tension, the other way $e^{-\mu\alpha}$ times. The two are not
# symmetric about 100 N. In between the rope sticks: it holds every tension of the band.

# %% Tension at the far end over time with slip shaded: it rests on the upper Euler tension, then on the lower one; beside it the loop over the flow
figure, (left, right) = plt.subplots(1, 2, sharey=True, figsize=(8.6, 3.6))
left.fill_between(run["t"], 0, 1, where=run["STATUS"] == slipbench.SLIP, step="pre", color="#dfe7f2", linewidth=0,
                  transform=left.get_xaxis_transform(), label="slip")
left.plot(run["t"], run["f_bc"], label="run")
left.plot(run["t"][::40], exact["tension_bc"][::40], "o", markersize=3.5, markerfacecolor="none", color="#b3261e", label="closed form")
for sign, name, above in ((1, r"$100\,e^{\mu\alpha}$", 4), (-1, r"$100\,e^{-\mu\alpha}$", -13)):
    tension = 100 * numpy.exp(sign * 0.2 * numpy.pi)
    right.axhline(tension, color="#b3261e", linewidth=0.8, linestyle="--")
    right.annotate(name, (0, tension), (0, above), textcoords="offset points", color="#b3261e", ha="center")
right.plot(run["CP2"], run["f_bc"])
left.set(xlabel="time [s]", ylabel="tension at the far end [N]", ylim=(0, 210), xlim=(0, 5))
right.set(xlabel="flow of rope [mm]")
left.legend(loc="lower left", bbox_to_anchor=(0, 1), ncol=3, borderaxespad=0);

# %% [markdown]
# ## How many turns hold a ship?
#
# The same rope with other wrap angles and coefficients, as one sweep: the far end while it is hauled, over the tension of the hand.

# %%
turns = numpy.linspace(0.25, 2, 8)
mu = numpy.array([0.1, 0.2, 0.3])
result = slipbench.sweep(case, {"far": {"max": "f_bc"}}, mu=mu[:, None], turns=turns, k=1e5)
ratio = result["far"].reshape(3, 8) / 100
euler = numpy.exp(mu[:, None] * 2 * numpy.pi * turns)
assert (abs(ratio / euler - 1) < 1e-12).all()

# %% Ratio of the tensions over the turns on a logarithmic axis: runs lie on the straight lines of Euler's formula
figure, axes = plt.subplots()
for row, color in zip(range(3), ("#1f5fa8", "#b3261e", "#3a7d44")):
    axes.semilogy(turns, euler[row], color=color, linewidth=1.0)
    axes.semilogy(turns, ratio[row], "o", color=color, markersize=4)
    axes.annotate(f"coefficient {mu[row]:.1f}", (turns[-1], euler[row, -1]), (6, 0), textcoords="offset points", color=color, va="center",
                  annotation_clip=False)
axes.set(xlabel="turns of the rope", ylabel="tension over that of the hand", title="dots: runs; lines: Euler", xlim=(0, 2.05), ylim=(1, 50))
axes.set_yticks([1, 2, 5, 10, 20, 50], ["1", "2", "5", "10", "20", "50"])
axes.minorticks_off();

# %%
for row in range(3):
    needed = numpy.log(1000) / (mu[row] * 2 * numpy.pi)
    print(f"coefficient {mu[row]:.1f}: a thousand times the tension takes {needed:.1f} turns")

# %% [markdown]
# ## Does it hold?
#
# With both tensions given nothing flows: the run judges. `UTILISATION` is the part of the wrap that is needed to hold the load. Here
# half a turn holds 100 N against a load that rises to 250 N.

# %%
both = slipbench.load({
    "slipbench": 1, "title": "Does it hold?", "units": {"length": "mm", "force": "N", "time": "s"},
    "connector": {"type": "SLIPRING", "wrap_angle": "= pi"},
    "friction": [{"predefined": {}, "coefficient": 0.2, "stick": {"elastic_slip": 0.01}}],
    "history": [{"step": "raise", "increments": 300, "force": {"f1": 100, "f_bc": {"columns": ["value", "t"], "rows": [[100, 0], [250, 1]]}}}],
})
load = both.run()
first = load["f_bc"][load["STATUS"] == slipbench.SLIP][0]
print(f"holds up to some {first:.0f} N; Euler says {100 * numpy.exp(0.2 * numpy.pi):.1f} N")
assert abs(first - 100 * numpy.exp(0.2 * numpy.pi)) < 0.5   # an increment of load

# %% Part of the wrap that is needed over the load: it grows with the logarithm, and beyond one, shaded, the rope slips
figure, axes = plt.subplots(figsize=(6.4, 3.0))
axes.axvspan(first, 250, color="#dfe7f2", linewidth=0)
axes.plot(load["f_bc"], load["UTILISATION"])
axes.axhline(1, color="#b3261e", linewidth=0.8, linestyle="--")
axes.text(150, 0.1, "sticks", ha="center")
axes.text((first + 250) / 2, 0.1, "slips", ha="center")
axes.set(xlabel="load [N]", ylabel="part of the wrap needed", xlim=(100, 250), ylim=(0, 1.6));

# %% [markdown]
# Belts have more to them: their stretch, several rings, nodes that move. [Belts](../guide/history.md#belts) has it all, and
# `slipbench.closed_forms` the formulas to hold it against, `capstan_chain`, `elastic_belt` and `v_groove_capstan` among them.
