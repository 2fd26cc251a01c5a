# SPDX-License-Identifier: Apache-2.0
"""Pictures of runs in the look of the bench: stick and slip shaded, the limit drawn."""
import base64
import html as _html
import io

FORCE = "#0b1a33"
LIMIT = "#b3261e"
SLIP = "#dfe7f2"


def _columns(run, definition):
    """The columns of total force, force along a component, motion along it, limit and regime of a definition; None of those that
    the run has not, as a case may choose its columns."""
    friction = run._native.friction
    names = [name for name, _, _ in friction]
    if definition is not None and definition not in names:
        raise ValueError(f"no definition {definition!r}; the run has {', '.join(names)}")
    name, coupled, forces = friction[names.index(definition) if definition else 0]

    def own(stem):
        return next((one for one in (f"{stem}.{name}", stem) if one in run), None)

    along = next((one for one in forces if one in run), None)
    component = along.split(".")[0] if along else ""
    motion = f"CU{'R' if component.startswith('CSM') else ''}{component[3:]}"
    total = own("CSFC") if coupled else along
    return total or along, along, motion if motion in run else None, own("FLIM"), own("STATUS")


def _label(run, name):
    unit = run.units[name]
    return f"{name} [{unit}]" if unit else name


def draw(run, axes=None, definition=None):
    """Draws a run into two axes."""
    if axes is None:
        import matplotlib.pyplot as plt

        _, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
    over_time, over_motion = axes
    total, along, motion, limit, status = _columns(run, definition)
    if total is None:
        raise ValueError("the run has no column of a friction force: take it under 'output: {columns: ..}' of the case")
    time = run["T"] if "T" in run else run["t"]
    if status is not None:
        over_time.fill_between(time, 0, 1, where=run[status] == 2, step="pre", color=SLIP, linewidth=0,
                               transform=over_time.get_xaxis_transform(), label="slip")
    if limit is not None:
        # The total force of several components has no sign.
        for sign in (1.0, -1.0) if total == along else (1.0,):
            over_time.plot(time, sign * run[limit], color=LIMIT, linewidth=0.8, linestyle="--",
                           label="limit" if sign > 0 else None)
    over_time.plot(time, run[total], color=FORCE, linewidth=1.2, label=total)
    over_time.set_xlabel(_label(run, "T" if "T" in run else "t"))
    over_time.set_ylabel(_label(run, total))
    over_time.legend(frameon=False, fontsize="small", loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, borderaxespad=0.0)
    if motion is not None:
        over_motion.plot(run[motion], run[along], color=FORCE, linewidth=1.2)
        over_motion.set_xlabel(_label(run, motion))
        over_motion.set_ylabel(_label(run, along))
        over_motion.locator_params(axis="x", nbins=6)
    for one in axes:
        one.spines[["top", "right"]].set_visible(False)
    over_time.figure.suptitle(run.title)
    return axes


def html(run):
    """A small picture and the verdicts of a run for a notebook."""
    lines = [f"<b>{_html.escape(run.title)}</b>"]
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        figure = Figure(figsize=(6.4, 2.4), layout="constrained")
        FigureCanvasAgg(figure)
        draw(run, figure.subplots(1, 2))
        data = io.BytesIO()
        figure.savefig(data, dpi=96)
        lines.append(f'<br><img alt="" src="data:image/png;base64,{base64.b64encode(data.getvalue()).decode()}">')
    except ImportError:
        lines.append(f"<br>{_html.escape(repr(run))}")
    except ValueError as error:
        lines.append(f"<br>{_html.escape(str(error))}")
    for check in run.checks:
        lines.append(f"<br>{'PASS' if check else 'FAIL'} {_html.escape(check.name)}")
    return "".join(lines)
