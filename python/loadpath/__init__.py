"""Design of machine elements: what the program `loadpath` does, from Python.

    import loadpath
    torsion = loadpath.calculator("shaft.torsion")
    torsion.solve(T="1.2 kN*m", d="60 mm", tau_adm="40 MPa")["tau_max"].text
    torsion.sweep(T=("kN*m", torques), d="60 mm", tau_adm="40 MPa")["tau_max"]

Numbers without a unit are SI: Pa, m, N*m, rad. Arrays of float64 are read where they stand, results are handed over
with their memory, and other Python threads run meanwhile. docs/from-other-languages.md tells the rest.
"""

import collections
import collections.abc
import enum
import json
import numbers

import numpy as np

from . import _loadpath
from ._loadpath import Check, Error, Field, Issue, Mode, Quantity, Solution

__version__ = _loadpath.__version__
Error.__module__ = __name__

__all__ = [
    "Calculator", "Check", "Error", "Field", "Issue", "Mode", "Project", "Quantity", "Refused", "Solution", "State",
    "Sweep", "calculator", "calculators", "convert", "project", "quantity", "read_project",
]


class State(enum.IntEnum):
    """How a point, a part or a failure mode came out: the numbers of the column `state`."""

    ABSENT = -1  # the mode does not concern the part
    PASS = 0
    ACCEPTED = 1
    OPEN = 2
    NOT_JUDGED = 3
    NOT_COVERED = 4
    NOT_AVAILABLE = 5
    FAIL = 6
    REFUSED = 7  # the point breaks a rule between inputs, or a value is none that its field takes


Refused = collections.namedtuple("Refused", "count first key message")


def _numbers(name, value):
    """An array of float64 without gaps: the same one where it is that already."""
    if isinstance(value, np.ma.MaskedArray):
        value = value.astype(np.float64).filled(np.nan)
    array = np.asarray(value)
    if array.size == 0 and not isinstance(value, np.ndarray):
        array = array.astype(np.float64)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name}: an array of numbers is expected, not of {array.dtype}")
    if array.ndim != 1:
        raise ValueError(f"{name}: an array of one dimension is expected, not of {array.ndim}")
    return np.ascontiguousarray(array, dtype=np.float64)


def _toml(name, value):
    """A value as a project file would have it."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007F")
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, collections.abc.Mapping):
        return "{ " + ", ".join(f"{json.dumps(str(k))} = {_toml(name, v)}" for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(_toml(name, v) for v in value) + "]"
    raise TypeError(f"{name}: {type(value).__name__} is no value of a project file")


def _is_structure(value):
    return isinstance(value, collections.abc.Mapping) or (
        isinstance(value, (list, tuple)) and any(isinstance(v, (collections.abc.Mapping, list, tuple)) for v in value))


def _input(name, value, lists):
    """Name, value and unit as the module takes them; `lists` are the inputs that are lists themselves."""
    unit = ""
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[0], str) and not isinstance(value[1], str):
        unit, value = value
        if isinstance(value, (bool, np.bool_)) or _is_structure(value):
            raise TypeError(f"{name}: behind a unit stands a number or an array")
    elif isinstance(value, str):
        return name, value, ""
    elif name in lists or _is_structure(value):
        return name, _toml(name, value).encode(), ""
    if isinstance(value, (bool, np.bool_, bytes)):
        raise TypeError(f"{name}: a number, a text or an array is expected, not {type(value).__name__}")
    if isinstance(value, numbers.Real):
        return name, float(value), unit
    if isinstance(value, np.ndarray) and value.ndim == 0:
        return _input(name, (unit, value.item()) if unit else value.item(), lists)
    if isinstance(value, np.ndarray) and value.dtype.kind == "U":
        value = value.tolist()
    if isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(v, str) for v in value):
        return name, list(value), unit
    if not isinstance(value, (list, tuple, range, np.ndarray)) and not hasattr(value, "__array__"):
        raise TypeError(f"{name}: a number, a text or an array is expected, not {type(value).__name__}")
    return name, _numbers(name, value), unit


class Sweep(collections.abc.Mapping):
    """Columns by name, SI. Every row is there: `state` tells how it came out, what has no value is NaN."""

    def __init__(self, parts):
        self.points = parts["points"]
        self.refused = [Refused(*r) for r in parts["refused"]]
        self._summary = parts["summary"]
        self._columns = {name: array for name, array, *_ in parts["columns"]}
        self._meta = {name: tuple(meta) for name, _, *meta in parts["columns"]}

    def __getitem__(self, name):
        return self._columns[name]

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        return len(self._columns)

    def __repr__(self):
        return f"<{self.points} points: {', '.join(self._columns)}>"

    def unit(self, name):
        """The unit of the values: "Pa"; "1" of a number."""
        return self._meta[name][0]

    def shown_in(self, name):
        """The unit that people read it in: "MPa"."""
        return self._meta[name][1]

    def words(self, name):
        """The words that a column of an input counts, from 0; none of a quantity."""
        return self._meta[name][2]

    def to(self, name, unit=None):
        """A copy in another unit; without one in that which people read it in."""
        return convert(self[name], self.unit(name), unit or self.shown_in(name))

    @property
    def state(self):
        """How the rows came out, as whole numbers: compare with `State`."""
        return self["state"].astype(np.int8)

    @property
    def passes(self):
        """Whether everything that applies is judged or accepted, row by row."""
        return (self["state"] >= State.PASS) & (self["state"] <= State.OPEN)

    @property
    def is_refused(self):
        return self["state"] == State.REFUSED

    @property
    def summary(self):
        """What `loadpath sweep --json` says: shares, moments, quantiles, the worst points; of a calculator {}."""
        return json.loads(self._summary) if self._summary else {}


class Calculator:
    """One calculator; `inputs` and `results` tell its fields."""

    def __init__(self, inner):
        self._inner = inner
        self.id = inner.id
        self.title = inner.title
        self.scope = inner.scope
        self.example = inner.example
        self.inputs = {field.name: field for field in inner.inputs}
        self.results = {field.name: field for field in inner.results}
        self._lists = {name for name, field in self.inputs.items() if field.kind in ("list", "group")}

    def __repr__(self):
        return f"<{self.id}: {self.title}>"

    def _given(self, inputs, more):
        given = {**(inputs or {}), **more}
        return [_input(name, value, self._lists) for name, value in given.items() if value is not None]

    def solve(self, inputs=None, /, *, strict=False, **more):
        """One machine: its numbers by name and its verdict."""
        return self._inner.solve(self._given(inputs, more), strict)

    def sweep(self, inputs=None, /, *, results=None, jobs=0, strict=False, **more):
        """A row for each value of the arrays, which have one length; single values stand for all rows.

        `results`: names; without them every result that is a number.
        """
        return Sweep(self._inner.sweep(
            self._given(inputs, more), {"results": list(_names(results)), "jobs": jobs, "strict": strict}))


def _names(names):
    return () if names is None else (names,) if isinstance(names, str) else names


class Project:
    """A project file. Every call reads its text anew: several threads may use one object."""

    def __init__(self, inner):
        self._inner = inner
        self.title = inner.title
        self.steps = inner.steps
        self.swept = inner.swept

    def __repr__(self):
        return f"<project {self.title or ', '.join(self.steps)}>"

    def solve(self, *, strict=False):
        """The machine: numbers by "step.field" and the verdict."""
        return self._inner.solve(strict)

    def sweep(self, results=None, *, samples=None, seed=None, latin=False, zip=(), jobs=0, strict=False, rows=True):
        """All points of the file's ranges, lists and distributions, as `loadpath sweep` goes through them.

        `results` are expressions, "mass = rod.A*rod.l*(7850 kg/m^3)", beside those of the file; `rows=False` keeps the
        summary alone, in constant memory.
        """
        options = {"results": list(_names(results)), "latin": latin, "zip": [list(z) for z in zip], "jobs": jobs,
                   "strict": strict, "rows": rows}
        return Sweep(self._inner.sweep({**options, **_drawn(samples, seed)}))

    def point(self, index, *, samples=None, seed=None, latin=False, zip=(), strict=False):
        """One point of the sweep, counted from 0, as a machine of its own."""
        options = {"latin": latin, "zip": [list(z) for z in zip], "strict": strict}
        return self._inner.solve_point(index, {**options, **_drawn(samples, seed)})


def _drawn(samples, seed):
    return {key: value for key, value in (("samples", samples), ("seed", seed)) if value is not None}


def project(file):
    """Reads a project file. What is wrong with it raises Error, with `issues`, `file`, `line` and `column`."""
    return Project(_loadpath.Project.open(str(file)))


def read_project(text, name="project"):
    """The same from a text."""
    return Project(_loadpath.Project.read(text, name))


def calculator(id):
    """The calculator of that name: "shaft.torsion"."""
    return Calculator(_loadpath.Calculator.find(id))


def calculators():
    """The names of all calculators."""
    return [c.id for c in _loadpath.Calculator.all()]


def quantity(text):
    """A quantity as people write it, in SI: "12 kN*m"."""
    return _loadpath.in_si(text)


def convert(values, source, target):
    """Numbers of one unit in another, as a new array: convert(tau, "Pa", "MPa")."""
    array = np.array(values, dtype=np.float64, order="C", ndmin=1)
    _loadpath.convert(array, source, target)
    return array if np.ndim(values) else float(array[0])
