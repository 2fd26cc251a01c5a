# SPDX-License-Identifier: Apache-2.0
"""One case with many values of its parameters, and many cases with their checks."""
import collections.abc
import concurrent.futures
import json
import os
import pathlib
from typing import Any, Callable, Dict, Iterator, List, Mapping, NamedTuple, Optional, Union

from . import _native
from ._case import Case, Run, Verdict, load
from ._errors import SlipbenchError


def _figures(case: Case) -> Dict[str, Dict[str, str]]:
    """What a sweep collects if nothing else is said: of each definition the largest force and limit, and what was dissipated."""
    friction, columns = case._native.friction, set(case._native.columns)
    figures = {}
    for name, coupled, forces in friction:
        def own(stem):
            return next((one for one in (f"{stem}.{name}", stem) if one in columns), None)

        tail = f".{name}" if len(friction) > 1 else ""
        for figure, part, column in (("force", "magnitude", own("CSFC") if coupled else next(iter(forces), None)),
                                     ("limit", "max", own("FLIM")), ("dissipation", "last", own("DISS"))):
            if column is not None:
                figures[figure + tail] = {part: column}
    return figures


class Sweep(collections.abc.Mapping):
    """Columns of a sweep as arrays: the parameters that vary, and what was collected; nan where a sample did not run, whose reason is in
    `failures`."""

    def __init__(self, columns: Dict[str, Any], failures: Dict[int, str]):
        self._columns = columns
        self.failures = failures

    def __getitem__(self, name: str):
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def to_pandas(self):
        """The columns as a pandas.DataFrame, a row each sample."""
        import pandas

        return pandas.DataFrame(self._columns)

    def __repr__(self) -> str:
        rows = len(next(iter(self._columns.values()), ()))
        return f"<slipbench.Sweep: {rows} samples, {', '.join(self._columns)}; {len(self.failures)} failed>"


Collect = Union[Callable[[Run], Mapping[str, float]], Mapping[str, Union[Callable[[Run], float], Mapping[str, Any]]]]


def sweep(case: Case, collect: Optional[Collect] = None, *, threads: int = 0, **parameters: Any) -> Sweep:
    """Runs a case with arrays of values of its parameters, which are broadcast against each other.

    collect: numbers of a run as a sweep file has them, {"peak": {"magnitude": "CSF1"}, "lost": {"last": "DISS"}}: the samples go through the
    engine of the program, many at once where they can; by default the largest force and limit and the dissipated energy of each
    definition. Or a function of a run that gives a dict of numbers, or a dict of such functions, at the cost of a run each.
    threads: 0 for as many as cores. A sample that makes no case, or whose run ends early, has nan and a reason in `failures`.

        slipbench.sweep(case, {"peak": {"max": "CSF1"}}, mu=numpy.linspace(0.1, 0.3, 50))
    """
    import numpy

    if not parameters:
        raise ValueError("sweep: which parameters vary? sweep(case, mu=array)")
    arrays = numpy.broadcast_arrays(*(numpy.asarray(values, dtype=float) for values in parameters.values()))
    columns = {name: numpy.array(values).ravel() for name, values in zip(parameters, arrays)}
    if collect is None:
        collect = _figures(case)
    if not callable(collect) and not any(callable(one) for one in collect.values()):
        native = case._native
        names, numbers, failures = _native.sweep(
            native.text, native.name, native.folder, native.allow_outside, [(name, value) for name, value in native.overrides if name not in columns],
            list(columns.items()), json.dumps(collect), threads)
        columns.update(zip(names, numbers.T))
        return Sweep(columns, failures)
    if callable(collect):
        take = collect
    else:
        def take(run):
            return {name: function(run) for name, function in collect.items()}

    def sample(index):
        try:
            one = case.with_parameters(**{name: values[index] for name, values in columns.items()})
            return dict(take(one.run(checks=False)))
        except SlipbenchError as error:
            return str(error)

    count = len(next(iter(columns.values())))
    with concurrent.futures.ThreadPoolExecutor(threads or os.cpu_count()) as pool:
        results = list(pool.map(sample, range(count)))
    failures = {index: result for index, result in enumerate(results) if isinstance(result, str)}
    names = next((list(result) for result in results if isinstance(result, dict)), [])
    for name in names:
        columns[name] = numpy.array([result[name] if isinstance(result, dict) else numpy.nan for result in results], dtype=float)
    return Sweep(columns, failures)


class Checked(NamedTuple):
    """A case that was run and judged; `error` says why it could not be."""

    file: str
    passed: bool
    verdicts: List[Verdict]
    error: str

    def __bool__(self) -> bool:
        return self.passed


def check(*paths: Union[str, "os.PathLike[str]"], allow_outside: bool = False) -> List[Checked]:
    """Runs cases and folders of cases and judges their checks, as `slipbench check` does: it finds the same ones. A link out of a folder is
    not followed unless allow_outside, and does not pass. Unlike there, a case of a folder reads standard input if it says so. A case
    without checks does not pass on nothing: it passes if it runs, and has no verdicts to show."""
    results = []
    for file, fault in _native.find_cases([os.fspath(path) for path in paths or (".",)], allow_outside):
        try:
            if fault:
                raise SlipbenchError(f"{file}: {fault}")
            run = load(pathlib.Path(file), allow_outside=allow_outside).run()
            results.append(Checked(file, run.passed, run.checks, ""))
        except SlipbenchError as error:
            results.append(Checked(file, False, [], str(error)))
    return results
