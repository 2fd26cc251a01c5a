# SPDX-License-Identifier: Apache-2.0
"""Cases and their runs."""
import collections.abc
import json
import operator
import os
import warnings
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from . import _native
from ._errors import SlipbenchWarning

Number = Union[float, int, str]


class Event(NamedTuple):
    """A change of regime: from `origin` to `goal` (stick, slip, open, or "jump" of the force)."""

    time: float
    definition: str
    origin: str
    goal: str
    force: float
    limit: float
    accumulated_slip: float
    positions: Dict[str, float]


class Verdict(NamedTuple):
    """What became of a check; `details` has all that <case>.json has of it."""

    name: str
    passed: bool
    details: Dict[str, Any]

    def __bool__(self) -> bool:
        return self.passed


def _settings(values: Mapping[str, Number]) -> List[Tuple[str, Union[float, str]]]:
    return [(name, value if isinstance(value, str) else float(value)) for name, value in values.items()]


class Parameters(collections.abc.MutableMapping):
    """The parameters of a case: names with their numbers. A number or an expression ("= 2*R") replaces what the case's text
    has; the case is read again at once, and a fault raises CaseError and changes nothing."""

    def __init__(self, native):
        self._native = native

    def __getitem__(self, name: str) -> float:
        return self._native.parameters[name]

    def __setitem__(self, name: str, value: Number) -> None:
        self.update({name: value})

    def update(self, *others, **values: Number) -> None:
        """Gives several parameters other values at once."""
        given = dict(*others, **values)
        if given:
            self._native.set(_settings(given))

    def __delitem__(self, name: str) -> None:
        raise TypeError("a case keeps its parameters: give them another value")

    def __iter__(self) -> Iterator[str]:
        return iter(self._native.parameters)

    def __len__(self) -> int:
        return len(self._native.parameters)

    def __repr__(self) -> str:
        return repr(self._native.parameters)


def _no_column(name: str, names: List[str]) -> KeyError:
    import difflib

    near = difflib.get_close_matches(name, names, 3)
    hint = f"; did you mean {' or '.join(near)}?" if near else f"; the columns are {', '.join(names)}"
    return KeyError(f"no column {name!r}{hint}")


class Run(collections.abc.Mapping):
    """The result of a run. `run["CSF1"]` is a column as a read-only NumPy array, without a copy; names are those of the result file."""

    def __init__(self, native):
        self._native = native
        self._names = native.columns
        self._document: Optional[Dict[str, Any]] = None

    def __getitem__(self, name: str):
        try:
            return self._native.column(name)
        except KeyError:
            raise _no_column(name, self._names) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __reduce__(self):
        raise TypeError("a run is not pickled: hand over the case, which can run again, or arrays, dict(run), and run.document")

    def __repr__(self) -> str:
        return f"<slipbench.Run of {self.title!r}: {self._native.rows} rows, {len(self._names)} columns>"

    @property
    def title(self) -> str:
        """The title of the case."""
        return self._native.title

    @property
    def units(self) -> Dict[str, str]:
        """The units of the columns, as the case has them; "" where it has none."""
        return self._native.units

    @property
    def texts(self) -> Dict[str, str]:
        """What the columns are, a sentence each."""
        return self._native.texts

    @property
    def events(self) -> List[Event]:
        """Where stick, slip and lift-off changed, interpolated inside the increments."""
        return [Event(**one) for one in self._native.events]

    @property
    def document(self) -> Dict[str, Any]:
        """All that the program writes to <case>.json."""
        if self._document is None:
            self._document = json.loads(self._native.document)
        return self._document

    @property
    def summary(self) -> Dict[str, Any]:
        """Figures of the run: shares of slip, energies, cycles."""
        return self.document["summary"]

    @property
    def warnings(self) -> List[str]:
        """What is doubtful about the run, a sentence each."""
        return self._native.warnings

    @property
    def checks(self) -> List[Verdict]:
        """The verdicts of the case's checks."""
        return [Verdict(one["name"], one["passed"], one) for one in self.document["checks"]]

    @property
    def passed(self) -> bool:
        """Whether all checks passed."""
        return all(self.checks)

    def to_pandas(self):
        """The columns as a pandas.DataFrame over the time t; its attrs have the title and the units."""
        import pandas

        frame = pandas.DataFrame({name: self[name] for name in self._names if name != "t"}, index=pandas.Index(self["t"], name="t"))
        frame.attrs.update(title=self.title, units=self.units)
        return frame

    def to_xarray(self):
        """The columns as an xarray.Dataset over the time t, each with its unit and its text."""
        import xarray

        units, texts = self.units, self.texts

        def variable(name):
            return ("t", self[name], {"units": units[name], "long_name": texts[name]})

        return xarray.Dataset({name: variable(name) for name in self._names if name != "t"},
                              coords={"t": variable("t")}, attrs={"title": self.title})

    def plot(self, axes=None, definition: Optional[str] = None):
        """Draws friction force and limit over time with slip shaded, and over the motion. Returns the two matplotlib axes.

        axes: two matplotlib axes, or none; definition: which of several friction definitions, the first if none is said.
        """
        from ._look import draw

        return draw(self, axes, definition)

    def _repr_html_(self) -> str:
        from ._look import html

        return html(self)


def _text_of(source: Mapping) -> str:
    def plain(value):
        if hasattr(value, "tolist"):
            return value.tolist()
        if hasattr(value, "item"):
            return value.item()
        raise TypeError(f"a case has no {type(value).__name__}")

    # JSON is YAML, too.
    return json.dumps(source, default=plain, indent=1)


class Case:
    """A joint, its friction and its history. Made by `slipbench.load`."""

    def __init__(self, native):
        self._native = native

    @property
    def parameters(self) -> Parameters:
        """Its parameters: `case.parameters["mu"] = 0.2`."""
        return Parameters(self._native)

    @property
    def title(self) -> str:
        """Its title."""
        return self._native.title

    @property
    def text(self) -> str:
        """Its text, as it was read."""
        return self._native.text

    @property
    def definitions(self) -> List[str]:
        """The names of its friction definitions."""
        return self._native.definitions

    def with_parameters(self, **values: Number) -> "Case":
        """A copy with other values of some parameters."""
        one = Case(self._native.copy())
        one.parameters.update(values)
        return one

    def run(self, every: int = 1, checks: bool = True, columns: Optional[Sequence[str]] = None) -> Run:
        """Runs it. Ctrl-C ends it; other threads go on meanwhile.

        every: of so many rows one is kept, and the last; checks: whether they are judged; columns: those that are kept besides the time,
        which makes long runs quick; by default those of the result file. Raises RunError where the run does not come to its end.
        """
        try:
            rows = operator.index(every)
        except TypeError:
            raise TypeError(f"every: wanted a whole number of at least 1, found {every!r}") from None
        if rows < 1:
            raise ValueError(f"every: wanted a whole number of at least 1, found {every}")
        if isinstance(columns, str) or not isinstance(columns, (type(None), collections.abc.Iterable)):
            raise TypeError(f"columns: wanted a list of names, found {columns!r}")
        wanted = list(columns if columns is not None else ())
        for i, name in enumerate(wanted):
            if not isinstance(name, str):
                raise TypeError(f"columns: wanted a list of names, found {name!r} in it")
            if name not in self._native.columns:
                raise _no_column(name, self._native.columns)
            if name in wanted[:i]:
                raise ValueError(f"columns: {name!r} is there twice")
        most = 2**31 - 1  # rows that a run can have
        return Run(self._native.run(min(rows, most), checks, wanted))

    def __reduce__(self):
        """Text, parameters and folder: what another process, or a copy, reads it from again."""
        native = self._native
        return _case_of, (native.text, native.name, os.path.abspath(native.folder), native.allow_outside, native.overrides)

    def __repr__(self) -> str:
        return f"<slipbench.Case {self.title!r}: {', '.join(self.definitions)}>"


def _case_of(text: str, name: str, folder: str, allow_outside: bool, settings: List[Tuple[str, Union[float, str]]]) -> Case:
    """The case that was pickled; of its warnings its maker has heard."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SlipbenchWarning)
        return Case(_native.Case.of_text(text, name, folder, allow_outside, settings))


def load(source: Union[str, "os.PathLike[str]", Mapping], *, folder: Union[str, "os.PathLike[str]"] = ".", allow_outside: bool = False, **parameters: Number) -> Case:
    """Reads a case: a file's name, its text (which has a line feed), or a dict with its keys.

    folder: where data files of a text or a dict are looked for; allow_outside: whether they may lie outside it. Further arguments are
    values of its parameters. Raises CaseError with all that is wrong; warnings are SlipbenchWarning.
    """
    settings = _settings(parameters)
    if isinstance(source, collections.abc.Mapping):
        return Case(_native.Case.of_text(_text_of(source), "<dict>", os.fspath(folder), allow_outside, settings))
    if isinstance(source, str) and "\n" in source:
        return Case(_native.Case.of_text(source, "<text>", os.fspath(folder), allow_outside, settings))
    return Case(_native.Case(os.fspath(source), allow_outside, settings))
