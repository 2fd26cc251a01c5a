# SPDX-License-Identifier: Apache-2.0
"""A test bench for connector friction.

    import slipbench
    case = slipbench.load("shaft.yaml")
    case.parameters["mu"] = 0.2
    run = case.run()
    run["CSF1"]        # a NumPy array: the friction force along component 1
    run.plot()

The columns of a run, the keys of a case and the laws are those of the program: `slipbench list quantities`,
`slipbench describe KEY`.
"""
from ._case import Case, Event, Parameters, Run, Verdict, load
from ._errors import CaseError, Message, RunError, SlipbenchError, SlipbenchWarning
from ._fit import Calibration, Estimate, calibrate
from ._law import OPEN, SLIP, STICK, Law
from ._native import version as __version__
from ._sweep import Checked, Sweep, check, sweep

__all__ = ["Calibration", "Case", "CaseError", "Checked", "Estimate", "Event", "Law", "Message", "OPEN", "Parameters", "Run", "RunError",
           "SLIP", "STICK", "SlipbenchError", "SlipbenchWarning", "Sweep", "Verdict", "calibrate", "check", "closed_forms", "load", "sweep",
           "__version__"]


def __getattr__(name):
    # Imported when it is asked for: it makes a function of each form.
    if name == "closed_forms":
        import importlib

        return importlib.import_module(".closed_forms", __name__)
    raise AttributeError(f"module 'slipbench' has no attribute {name!r}")
