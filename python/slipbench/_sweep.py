# SPDX-License-Identifier: Apache-2.0
"""One case with many values of its parameters, and many cases with their checks."""
import collections.abc
import concurrent.futures
import os
import pathlib
from typing import Any, Callable, Dict, Iterator, List, Mapping, NamedTuple, Optional, Union

from ._case import Case, Run, Verdict, load
from ._errors import RunError, SlipbenchError


def _figures(run: Run) -> Dict[str, float]:
    """What a sweep collects if nothing else is said: of each definition the largest force and limit, and what was dissipated."""
    figures = {}
    for name, coupled, forces in run._native.friction:
        def column(stem):
            return next((run[one] for one in (f"{stem}.{name}", stem) if one in run), None)

        tail = f".{name}" if len(run._native.friction) > 1 else ""
        force = column("CSFC") if coupled else (run[forces[0]] if forces and forces[0] in run else None)
        limit, lost = column("FLIM"), column("DISS")
        if force is not None:
            figures["force" + tail] = float(abs(force).max())
        if limit is not None:
            figures["limit" + tail] = float(limit.max())
        if lost is not None:
            figures["dissipation" + tail] = float(lost[-1])
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


def sweep(case: Case, collect: Optional[Union[Callable[[Run], Mapping[str, float]], Mapping[str, Callable[[Run], float]]]] = None, *,
          threads: int = 0, **parameters) -> Sweep:
    """Runs a case with arrays of values of its parameters, which are broadcast against each other.

    collect: a function of a run that gives a dict of numbers, or a dict of functions; by default the largest force and limit and the
    dissipated energy of each definition. threads: 0 for as many as cores. Raises CaseError where a sample makes no case.

        slipbench.sweep(case, mu=numpy.linspace(0.1, 0.3, 50), collect={"peak": lambda run: run["CSF1"].max()})
    """
    import numpy

    if not parameters:
        raise ValueError("sweep: which parameters vary? sweep(case, mu=array)")
    if collect is None:
        take = _figures
    elif callable(collect):
        take = collect
    else:
        def take(run):
            return {name: function(run) for name, function in collect.items()}

    arrays = numpy.broadcast_arrays(*(numpy.asarray(values, dtype=float) for values in parameters.values()))
    columns = {name: numpy.array(values).ravel() for name, values in zip(parameters, arrays)}
    count = len(next(iter(columns.values())))

    def sample(index):
        one = case.with_parameters(**{name: values[index] for name, values in columns.items()})
        try:
            return dict(take(one.run(checks=False)))
        except RunError as error:
            return str(error)

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
    """Runs cases and folders of cases and judges their checks, as `slipbench check` does. Folders named bad are not searched. A case
    without checks does not pass on nothing: it passes if it runs, and has no verdicts to show."""
    files: List[pathlib.Path] = []
    for path in map(pathlib.Path, paths or (".",)):
        if path.is_dir():
            files += sorted(one for one in path.rglob("*.yaml") if "bad" not in one.relative_to(path).parts)
        else:
            files.append(path)
    results = []
    for file in files:
        text = file.read_text(errors="replace") if file.exists() else ""
        if file.is_file() and any(line.startswith(("calibrate:", "sweep:")) for line in text.splitlines()):
            continue
        try:
            run = load(file, allow_outside=allow_outside).run()
            results.append(Checked(str(file), run.passed, run.checks, ""))
        except SlipbenchError as error:
            results.append(Checked(str(file), False, [], str(error)))
    return results
