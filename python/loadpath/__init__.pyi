import collections.abc
import enum
import os
from typing import Any, Iterator, Mapping, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

__version__: str

_Numbers = npt.NDArray[np.float64]
_Array = npt.ArrayLike
# A text "12 kN*m", a number in SI, ("kN*m", number or array), an array, words, or what a project file would have.
_Value = str | float | _Array | tuple[str, float | _Array] | Sequence[str] | Mapping[str, Any] | Sequence[Any] | None

class State(enum.IntEnum):
    ABSENT = -1
    PASS = 0
    ACCEPTED = 1
    OPEN = 2
    NOT_JUDGED = 3
    NOT_COVERED = 4
    NOT_AVAILABLE = 5
    FAIL = 6
    REFUSED = 7

class Issue:
    file: str
    line: int
    column: int
    length: int
    key: str
    message: str
    help: str
    is_error: bool

class Error(ValueError):
    issues: list[Issue]
    file: str
    line: int
    column: int

class Refused(NamedTuple):
    count: int
    first: int
    key: str
    message: str

class Quantity:
    name: str
    meaning: str
    role: str
    kind: str
    si_unit: str
    unit: str
    value: float | str | _Numbers
    axis: str
    positions: _Numbers
    text: str
    reason: str
    def __float__(self) -> float: ...

class Mode:
    step: str
    id: str
    meaning: str
    state: str
    group: str
    utilisation: float
    governs: str
    reason: str

class Check:
    step: str
    name: str
    meaning: str
    value: float
    bound: str
    state: str

class Solution:
    state: str
    headline: str
    verdict: str
    passes: bool
    modes: list[Mode]
    checks: list[Check]
    warnings: list[Issue]
    def __getitem__(self, name: str) -> Quantity: ...
    def __contains__(self, name: str) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def keys(self) -> list[str]: ...

class Field:
    name: str
    meaning: str
    role: str
    kind: str
    si_unit: str
    unit: str
    optional: bool
    words: list[str]

class Sweep(collections.abc.Mapping[str, _Numbers]):
    points: int
    refused: list[Refused]
    def __getitem__(self, name: str) -> _Numbers: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def unit(self, name: str) -> str: ...
    def shown_in(self, name: str) -> str: ...
    def words(self, name: str) -> list[str]: ...
    def to(self, name: str, unit: str | None = None) -> _Numbers: ...
    @property
    def state(self) -> npt.NDArray[np.int8]: ...
    @property
    def passes(self) -> npt.NDArray[np.bool_]: ...
    @property
    def is_refused(self) -> npt.NDArray[np.bool_]: ...
    @property
    def summary(self) -> dict[str, Any]: ...

class Calculator:
    id: str
    title: str
    scope: str
    example: str
    inputs: dict[str, Field]
    results: dict[str, Field]
    def solve(self, inputs: Mapping[str, _Value] | None = None, /, *, strict: bool = False, **more: _Value) -> Solution: ...
    def sweep(
        self,
        inputs: Mapping[str, _Value] | None = None,
        /,
        *,
        results: str | Sequence[str] | None = None,
        jobs: int = 0,
        strict: bool = False,
        **more: _Value,
    ) -> Sweep: ...

class Project:
    title: str
    steps: list[str]
    swept: list[str]
    def solve(self, *, strict: bool = False) -> Solution: ...
    def sweep(
        self,
        results: str | Sequence[str] | None = None,
        *,
        samples: int | None = None,
        seed: int | None = None,
        latin: bool = False,
        zip: Sequence[Sequence[str]] = (),
        jobs: int = 0,
        strict: bool = False,
        rows: bool = True,
    ) -> Sweep: ...
    def point(
        self,
        index: int,
        *,
        samples: int | None = None,
        seed: int | None = None,
        latin: bool = False,
        zip: Sequence[Sequence[str]] = (),
        strict: bool = False,
    ) -> Solution: ...

def project(file: str | os.PathLike[str]) -> Project: ...
def read_project(text: str, name: str = "project") -> Project: ...
def calculator(id: str) -> Calculator: ...
def calculators() -> list[str]: ...
def quantity(text: str) -> float: ...
def convert(values: Any, source: str, target: str) -> Any: ...
