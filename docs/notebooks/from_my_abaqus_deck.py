# SPDX-License-Identifier: Apache-2.0
# %% [markdown]
# # From my Abaqus deck, and back
#
# A lid turns on a brass pin. The connector is in an Abaqus deck; what its friction does is to be seen, changed, and taken home. The
# program `slipbench` reads the deck and writes one; it has to be on the `PATH`.

# %%
import pathlib
import subprocess
import tempfile

import matplotlib.pyplot as plt
import numpy

import slipbench

folder = tempfile.TemporaryDirectory()


def program(*words):
    """Runs the program in the folder; returns what it writes, and raises where it fails."""
    done = subprocess.run(["slipbench", *words], cwd=folder.name, check=True, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.stdout


# %% [markdown]
# ## The deck
#
# A HINGE with predefined friction: radius of the pin 6 mm, length 20 mm, and 150 N mm of contact moment from the fit. The coefficient
# falls from 0.2 to 0.12 with the slip rate. In its step the lid swings by 0.4 rad.

# %%
deck = """*HEADING
A lid on a pin, units N mm s
*NODE
1, 0., 0., 0.
2, 0., 0., 0.
*ELEMENT, TYPE=CONN3D2, ELSET=PIN
1, 1, 2
*CONNECTOR SECTION, ELSET=PIN, BEHAVIOR=BRASS
HINGE
*CONNECTOR BEHAVIOR, NAME=BRASS
*CONNECTOR FRICTION, PREDEFINED
6., , 20., 150.
*FRICTION, EXPONENTIAL DECAY, ELASTIC SLIP=0.02
0.2, 0.12, 0.5
*AMPLITUDE, NAME=SWING, DEFINITION=PERIODIC
1, 3.141592653589793, 0., 0.
0., 1.
*STEP
*STATIC, DIRECT
0.01, 4.
*CONNECTOR MOTION, AMPLITUDE=SWING
PIN, 4, 0.4
*END STEP
"""
(pathlib.Path(folder.name) / "lid.inp").write_text(deck);

# %% [markdown]
# ## In
#
# One command makes a case of it. It says what it kept, and what a deck cannot know: the forces across the pin are results of the model.

# %%
print(program("import", "lid.inp", "--units", "mm N s", "-o", "lid.yaml"))
text = (pathlib.Path(folder.name) / "lid.yaml").read_text()
print(text)

# %% [markdown]
# ## Run
#
# The forces that the model has are 60 N and 80 N across the pin, and 300 N mm that tilt it. With these numbers the case is complete.

# %%
for name, value in {"f2": 60, "f3": 80, "m2": 300, "m3": 0}.items():
    text = text.replace(f"  {name}: ", f"  {name}: {value} ")
case = slipbench.load(text)
run = case.run()
print(f"largest friction moment {abs(run['CSM1']).max():.1f} N mm, {run['DISS'][-1] / 1000:.2f} J lost in two cycles")

# %% Friction moment over time between limits that sink where the lid swings fast, slip shaded; beside it the loop over the angle
run.plot();

# %% [markdown]
# The limit is the coefficient times what presses, as a moment: that of the fit; the force across the pin, 100 N, at the radius; and the
# tilting moment, which the ends of the pin, 20 mm apart, carry as a pair of forces of 15 N. The run has the sum as `FN`.

# %%
contact = 150 + 6 * 100 + 6 * (15 + 15)
print(f"contact moment {run['FN'][-1]:.1f} N mm, by hand {contact:.1f} N mm")
assert abs(run["FN"] - contact).max() < 1e-9
assert (abs(run["CSM1"]) <= run["FLIM"] * (1 + 1e-12)).all() and run["FLIM"].max() <= 0.2 * contact

# %% [markdown]
# ## What if it tilts more?
#
# A run takes a millisecond, so this question needs no run of the model.

# %% Loops of friction moment over angle for three tilting moments: each is higher than the one before, and lower in its middle than at its ends
figure, axes = plt.subplots(figsize=(6.8, 3.6))
for tilt in (0, 300, 900):
    loop = case.with_parameters(m2=tilt).run()
    axes.plot(loop["CUR1"], loop["CSM1"], label=f"tilted by {tilt} N mm")
    assert abs(loop["FN"][-1] - (750 + 6 * 2 * tilt / 20)) < 1e-9
axes.set(xlabel="angle of the lid [rad]", ylabel="friction moment [N mm]")
axes.legend(loc="center left", bbox_to_anchor=(1, 0.5));

# %% [markdown]
# Where the lid turns round it is slow, and the coefficient is large. A soft drive would move it in jerks there.

# %% [markdown]
# ## Back
#
# The behaviour to paste into the model, with the same friction; before it is written it is read again and run beside the case.

# %%
(pathlib.Path(folder.name) / "lid_with_forces.yaml").write_text(case.text)
print(program("export", "lid_with_forces.yaml", "--to", "abaqus", "--part", "behaviour"))

# %% [markdown]
# Without `--part` it is a whole deck that runs as it stands. Read once more, it is the same friction:

# %%
program("export", "lid_with_forces.yaml", "--to", "abaqus", "-o", "again.inp")
program("import", "again.inp", "-o", "again.yaml")
again = slipbench.load(pathlib.Path(folder.name) / "again.yaml").run()
print("the same moment", "in all digits" if numpy.array_equal(again["CSM1"], run["CSM1"]) else "to rounding")
assert numpy.allclose(again["CSM1"], run["CSM1"], rtol=1e-12, atol=1e-12 * abs(run["CSM1"]).max())
folder.cleanup()

# %% [markdown]
# Other decks, of Radioss, LS-DYNA and OpenSees, come and go likewise: [Decks of solvers](../guide/decks.md).
