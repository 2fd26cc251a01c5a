# SPDX-License-Identifier: Apache-2.0
"""Closed forms to hold results against: `slipbench.closed_forms.capstan(alpha=[..], friction_coefficient=0.2, ..)`.

Each is a function with keywords: numbers for its parameters, arrays of one length (or numbers) for its inputs. It gives the outputs as
arrays by their names, or the array if there is one output. Along a path, as of a slider, rows go from the first to the last.
"""
from . import _native


class ClosedForm:
    """A closed form with its formula and source; call it with its parameters and inputs."""

    def __init__(self, entry):
        self.name = entry["name"]
        self.title = entry["title"]
        self.formula = entry["formula"]
        self.source = entry["source"]
        self.parameters = {one["name"]: one for one in entry["parameters"]}
        self.inputs = {name: (dimension, text) for name, dimension, text in entry["inputs"]}
        self.outputs = {name: (dimension, text) for name, dimension, text in entry["outputs"]}
        lines = [self.title, "", f"    {self.formula}", "", f"Source: {self.source}", ""]
        for kind, all_of in (("Parameters", [(name, one["dimension"], one["text"]) for name, one in self.parameters.items()]),
                             ("Inputs", [(name, *one) for name, one in self.inputs.items()]),
                             ("Outputs", [(name, *one) for name, one in self.outputs.items()])):
            lines += [f"{kind}:"] + [f"    {name} [{dimension or '1'}]: {text}" for name, dimension, text in all_of] + [""]
        self.__doc__ = "\n".join(lines)

    def __call__(self, **values):
        import numpy

        unknown = set(values) - set(self.parameters) - set(self.inputs)
        if unknown:
            known = ", ".join([*self.parameters, *self.inputs])
            raise TypeError(f"{self.name}: unknown {', '.join(sorted(unknown))}; it has {known}")
        parameters = []
        for name, one in self.parameters.items():
            value = values.get(name, one["default"])
            if value is None:
                raise TypeError(f"{self.name}: {name} is missing: {one['text']}")
            parameters.append([float(each) for each in numpy.atleast_1d(value)])
        missing = [name for name in self.inputs if name not in values]
        if missing:
            raise TypeError(f"{self.name}: {', '.join(missing)} is missing: {self.inputs[missing[0]][1]}")
        arrays = numpy.broadcast_arrays(*(numpy.atleast_1d(numpy.asarray(values[name], dtype=float)) for name in self.inputs))
        outputs = _native.closed_form(self.name, parameters, numpy.column_stack(arrays) if arrays else numpy.zeros((1, 0)))
        columns = {name: outputs[:, index] for index, name in enumerate(self.outputs)}
        return next(iter(columns.values())) if len(columns) == 1 else columns

    def __repr__(self):
        return f"<closed form {self.name}: {self.title}>"


_forms = {entry["name"]: ClosedForm(entry) for entry in _native.closed_forms()}
globals().update(_forms)
__all__ = list(_forms)


def __dir__():
    return __all__
