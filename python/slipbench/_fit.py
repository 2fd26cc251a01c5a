# SPDX-License-Identifier: Apache-2.0
"""Fits of cases to measured data."""
import json
import os
from typing import Any, Dict, List, NamedTuple, Optional, Tuple, Union

from . import _native
from ._case import Case, load


class Estimate(NamedTuple):
    """The value found of an unknown, how sure it is, and where the search began."""

    name: str
    value: float
    standard_error: Optional[float]
    interval: Optional[Tuple[float, float]]
    unit: str
    start: float
    identifiability: str

    def __float__(self) -> float:
        return self.value


class Calibration:
    """What a fit found. `document` has all figures, as the program writes them to <fit>.json."""

    def __init__(self, native: Dict[str, Any]):
        self.document: Dict[str, Any] = json.loads(native["document"])
        self._text: str = native["text"]
        self._cases: Dict[str, str] = native["cases"]

    @property
    def converged(self) -> bool:
        """Whether the search came to its end for a good reason."""
        return self.document["result"]["converged"]

    @property
    def reason(self) -> str:
        """Why the search ended, a sentence."""
        return self.document["result"]["sentence"]

    @property
    def estimates(self) -> Dict[str, Estimate]:
        """The unknowns by their names."""
        return {one["name"]: Estimate(one["name"], one["value"], one["standard_error"], (one["interval"][0], one["interval"][1]) if one["interval"] else None,
                                      one["unit"], one["start"], one["identifiability"]) for one in self.document["unknowns"]}

    def __getitem__(self, name: str) -> float:
        return self.estimates[name].value

    @property
    def covariance(self):
        """The covariance of the estimates, in their order, as an array; None if it is not known."""
        import numpy

        matrix = self.document["covariance"]
        return None if not matrix else numpy.array(matrix, dtype=float)

    @property
    def correlation(self):
        """Likewise their correlation."""
        import numpy

        matrix = self.document["correlation"]
        return None if not matrix else numpy.array(matrix, dtype=float)

    @property
    def notes(self) -> List[str]:
        """What should be known of the fit, a sentence each."""
        return self.document["notes"] or []

    @property
    def cases(self) -> Dict[str, str]:
        """The texts of the cases with the values found, by the names of their files."""
        return self._cases

    def case(self, folder: Union[str, "os.PathLike[str]"] = ".") -> Case:
        """The only case with the values found. folder: where its data files are."""
        if len(self._cases) != 1:
            raise ValueError(f"the fit has {len(self._cases)} cases: take one of `cases`, {', '.join(self._cases)}")
        return load(next(iter(self._cases.values())), folder=folder)

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        values = ", ".join(f"{one.name}={one.value:.6g}" for one in self.estimates.values())
        return f"<slipbench.Calibration {'converged' if self.converged else 'not converged'}: {values}>"


def calibrate(fit: Union[str, "os.PathLike[str]"], *, bootstrap: Optional[int] = None, profile: bool = False, threads: int = 0,
              allow_outside: bool = False, **parameters: float) -> Calibration:
    """Fits the cases of a fit file to its data, as `slipbench calibrate` does; nothing is written.

    bootstrap: so many resamplings; profile: profile likelihoods; threads: 0 for as many as cores; further arguments give parameters of
    the cases other values. Raises CaseError for faults of the files, RunError where a case does not run.
    """
    return Calibration(_native.calibrate(os.fspath(fit), {name: float(value) for name, value in parameters.items()}, bootstrap, profile,
                                         threads, allow_outside))
