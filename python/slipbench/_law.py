# SPDX-License-Identifier: Apache-2.0
"""Friction definitions, updated increment by increment."""
from __future__ import annotations

from typing import TYPE_CHECKING, List, Mapping, Optional, Sequence, Union

from . import _native
from ._case import _text_of

if TYPE_CHECKING:  # numpy is imported when an array is made
    import numpy
    import numpy.typing

    ArrayLike = numpy.typing.ArrayLike
    Array = numpy.typing.NDArray[numpy.float64]

#: Values of `regime` of an update, and of the column STATUS.
OPEN, STICK, SLIP = 0, 1, 2


class Law:
    """The friction of a connector without a history: an explicit state in, a new one out.

        law = slipbench.Law({"connector": {"type": "SLOT"}, "friction": [{"predefined": {}, "coefficient": 0.2}]})
        state = law.initial_state()
        step = law.update(state, motion=[0.1, 0, 0, 0, 0, 0], forces=[0, 100, 0, 0, 0, 0])
        step.force, step.limit, step.state

    The keys are those of a case: `connector`, `friction`, and what these need (`parameters`, `units`, `derived_components`).
    Raises CaseError.
    """

    def __init__(self, definition: Union[str, Mapping]):
        if isinstance(definition, str):
            text = definition
        else:
            keys = dict(definition)
            keys.setdefault("slipbench", 1)
            keys.setdefault("title", "a law")
            keys.setdefault("history", [{"step": "none", "increments": 1}])
            text = _text_of(keys)
        self._native = _native.Law(text)

    def update(self, state: ArrayLike, motion: ArrayLike, forces: Optional[ArrayLike] = None, begin: Optional[ArrayLike] = None,
               duration: Optional[ArrayLike] = None, temperature: Optional[ArrayLike] = None, fields: Optional[ArrayLike] = None,
               tangent: bool = False, end: Optional[ArrayLike] = None, reference: Optional[ArrayLike] = None) -> _native.Update:
        """One increment, or one of each row.

        state: as `initial_state` and `Update.state` have it; motion: 6 differences of positions over the increment [L, rad]; forces: 6
        constraint forces and moments at its end [F, F L], 0 by default; begin: 6 positions at its begin, 0; duration [T], 1; temperature
        and fields at its end. `end` gives 6 positions in place of begin + motion, free of the rounding of that sum; reference: 6
        constitutive reference positions that tables over CCU count from, 0.

        Shapes: motion is (6,) for one increment or (N, 6) for N. The others hold for all as (6,), fields (F,), duration and temperature
        as a number, or have a row each: (N, 6), (N, F), (N,). Fields of shape (N,) could mean either, and are a ValueError.

        Returns an Update: state, force (of the connector's 6 components), limit, normal_force, mu, slip_increment, slip_rate, dissipation,
        stored_energy, work and regime, with a column for each definition where there are several; with tangent=True also
        tangent = d force/d motion and force_tangent = d force/d forces, 6 by 6. Other threads go on meanwhile.
        """
        return self._native.update(state, motion, forces, begin, duration, temperature, fields, tangent, end, reference)

    @classmethod
    def from_numbers(cls, numbers: ArrayLike, names: Sequence[str] = ()) -> Law:
        """The law whose `numbers` these are: of another process, of the C interface's slip_law_pack. Numbers have no names of the
        definitions: `names` gives them, or they are empty. Raises ValueError."""
        law = cls.__new__(cls)
        law._native = _native.Law(numbers, list(names))
        return law

    def __reduce__(self):
        return Law.from_numbers, (self.numbers, self.names)

    @property
    def numbers(self) -> Array:
        """All numbers of the law as one array, tables and all: to save it, and for slip_law_unpack of the C interface."""
        return self._native.numbers

    @property
    def names(self) -> List[str]:
        """The names of its definitions."""
        return self._native.names

    @property
    def state_size(self) -> int:
        """How many numbers a state has: for each definition 6 of elastic slip [L], 6 of force [F], the accumulated slip [L], what rounding left out of it [L], the regime."""
        return self._native.state_size

    def initial_state(self, count: int = 0) -> Array:
        """A state without force and slip; with a count, a row for each of so many points."""
        import numpy

        state = numpy.zeros((count, self.state_size) if count else self.state_size)
        each = self.state_size // len(self.names)
        state[..., each - 1 :: each] = STICK
        return state
