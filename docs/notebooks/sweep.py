# SPDX-License-Identifier: Apache-2.0
# %% [markdown]
# # A sweep: how far do tolerances spread a force?
#
# A pin sits in a press fit. It is pulled and pushed, and the grip wears with the way that it slips. The drawing gives the grip with a
# tolerance, the lubricant a range of coefficients. How large a force moves the pin, and what is left of it after five cycles?

# %%
import matplotlib.pyplot as plt
import numpy

import slipbench

case = slipbench.load("""
slipbench: 1
title: Press fit of a pin
units: {length: mm, force: N, time: s}
parameters: {mu: 0.2, grip: 100, left: 0.4}
connector: {type: SLOT}
friction:
  - predefined:
      internal_contact_force:
        columns: [force, accumulated_slip]
        rows: [[= grip, 0], [= grip*(1 + left)/2, 5], [= grip*left, 20]]
    coefficient: = mu
    stick: {stiffness: 500}
history:
  - {step: cycles, duration: 5, increments: 500, motion: {CP1: {sine: {amplitude: 1, period: 1}}}}
""")

# %% [markdown]
# ## One run first
#
# A sweep of a case that nobody has looked at tells little. Each loop is lower than the one before, since the grip falls with the slip.

# %% Friction force over time, falling from cycle to cycle, slip shaded; beside it the loops of force over displacement, one in the other
one = case.run()
one.plot();

# %% [markdown]
# ## Three hundred samples
#
# `slipbench.sweep` takes arrays of values for parameters, and runs the case with each, on all cores. `collect` says what is left of a
# run, in the words of a sweep file; a function of the run does as well.

# %%
dice = numpy.random.default_rng(7)
samples = 300
result = slipbench.sweep(
    case,
    collect={
        "new": {"max": "CSF1"},
        "worn": {"last": "FLIM"},
    },
    mu=dice.uniform(0.15, 0.25, samples),
    grip=dice.normal(100, 8, samples),
    left=dice.uniform(0.3, 0.5, samples),
)
result

# %% [markdown]
# The result is a mapping of arrays, as a run is; `result.to_pandas()` makes a data frame of it. Samples whose run fails are `nan`, with
# the reason in `result.failures`.

# %%
assert not result.failures
for name, text in (("new", "first moves at"), ("worn", "after 5 cycles")):
    low, middle, high = numpy.quantile(result[name], [0.05, 0.5, 0.95])
    print(f"{text:15} {middle:5.1f} N, nine in ten between {low:.1f} and {high:.1f} N")

# %% [markdown]
# ## What does it depend on?
#
# A point is a sample. New, the force is all but the product of coefficient and grip: it scatters about the line $\mu$ times 100 N as
# far as the grip does, whose value is the colour. Worn, it scatters more for its size, since what the wear leaves varies as well.

# %% Force over coefficient for 300 samples, coloured by the grip: close to a straight line when new, a wider cloud when worn
figure, pair = plt.subplots(1, 2, sharex=True, sharey=True, figsize=(8.0, 3.6))
for axes, name, title in zip(pair, ("new", "worn"), ("new", "after five cycles")):
    dots = axes.scatter(result["mu"], result[name], c=result["grip"], s=12, cmap="viridis")
    axes.set(title=title, xlabel="coefficient of friction")
pair[0].plot([0.15, 0.25], [15, 25], color="#0b1a33", linewidth=1.0, linestyle="--", zorder=3, label="coefficient times 100 N")
pair[0].legend(loc="lower right")
pair[0].set(ylabel="force [N]", ylim=(0, 32))
figure.colorbar(dots, ax=pair, label="grip [N]");

# %% [markdown]
# No sample exceeds $\mu$ times its grip, and the first pull takes a little of the grip already:

# %%
share = result["new"] / (result["mu"] * result["grip"])
print(f"first peak: {share.min():.3f} to {share.max():.3f} of coefficient times grip")
assert (share <= 1 + 1e-12).all() and (share > 0.97).all()

# %% [markdown]
# ## Which tolerance matters?
#
# Squared correlations are the parts of the variance that straight lines explain. The force that moves the new pin is up to
# the lubricant; of what is left after the wear, a good part is up to how far the fit wears. So that is what to measure next.

# %% Bars of squared correlation: the coefficient explains most of the new force; of the worn force the wear explains a good part
names = {"mu": "coefficient", "grip": "grip, new", "left": "part left by wear"}
figure, axes = plt.subplots(figsize=(6.4, 2.6))
for offset, collected, label in ((-0.2, "new", "force, new"), (0.2, "worn", "force after five cycles")):
    parts = [100 * numpy.corrcoef(result[name], result[collected])[0, 1] ** 2 for name in names]
    axes.barh(numpy.arange(3) + offset, parts, 0.36, label=label)
axes.set(xlabel="part of the variance [%]", xlim=(0, 100), yticks=range(3), yticklabels=names.values())
axes.invert_yaxis()
axes.legend(loc="lower right");

# %%
assert numpy.corrcoef(result["mu"], result["new"])[0, 1] ** 2 > 0.5
assert abs(numpy.corrcoef(result["left"], result["new"])[0, 1]) < 0.2

# %% [markdown]
# ## More samples
#
# The program runs [sweeps](../guide/sweeps.md) from a file: more evenly spread samples, Sobol' indices, millions of runs on many machines,
# to the same bytes. For some thousand runs, and for functions of one's own, this is the shorter way.
