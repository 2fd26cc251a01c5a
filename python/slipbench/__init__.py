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
from ._law import OPEN, SLIP, STICK, Law
from ._native import version as __version__

__all__ = ["Case", "CaseError", "Event", "Law", "Message", "OPEN", "Parameters", "Run", "RunError", "SLIP", "STICK", "SlipbenchError", "SlipbenchWarning", "Verdict",
           "load", "__version__"]
