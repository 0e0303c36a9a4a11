"""Entries of results: an orbit, a row, with its numbers by their names."""

from __future__ import annotations

from typing import Any, Dict, Iterator, List, Mapping

import numpy as np

from .errors import unknown_name

#: What the document has as pairs of real and imaginary part.
_COMPLEX = {"multiplier", "multipliers"}


class Entry(Mapping[str, Any]):
    """What a result lists: values by their names, as `entry["speed"]` or `entry.speed`, in SI units.
    Lists of numbers are arrays, with NaN where a number does not exist, and multipliers are complex;
    a single value that does not exist, or is not known, is None."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self._values: Dict[str, Any] = dict(values)

    @classmethod
    def of_document(cls, part: Mapping[str, Any]) -> "Entry":
        """Of a part of a result's document."""
        return cls({name: _value(name, value) for name, value in part.items()})

    def __getitem__(self, name: str) -> Any:
        if name not in self._values:
            raise unknown_name("value", name, self._values)
        return self._values[name]

    def __getattr__(self, name: str) -> Any:
        values = self.__dict__.get("_values", {})
        if name not in values:
            raise AttributeError(str(unknown_name("value", name, values)))
        return values[name]

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *self._values]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __repr__(self) -> str:
        return "<graze.Entry: " + ", ".join(f"{name} {_brief(v)}" for name, v in self.items()) + ">"

    def _repr_html_(self) -> str:
        from .table import html_rows

        return html_rows("", ("", "value"), [(name, _brief(v)) for name, v in self.items()])


def _value(name: str, value: Any) -> Any:
    if isinstance(value, Mapping):
        return Entry.of_document(value)
    if name in _COMPLEX and isinstance(value, list):
        pairs = np.array(value, dtype=float).reshape(-1, 2)
        numbers = pairs[:, 0] + 1j * pairs[:, 1]
        return numbers if name == "multipliers" else complex(numbers[0])
    if not isinstance(value, list):
        return value
    if all(isinstance(one, Mapping) for one in value) and value:
        return [Entry.of_document(one) for one in value]
    if all(one is None or type(one) in (int, float) for one in value):
        return np.array(value, dtype=float if None in value or not value else None)
    return [_value("", one) for one in value]


def _brief(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, np.ndarray):
        return np.array2string(value, precision=6, threshold=6)
    if isinstance(value, list):
        return f"[{len(value)}]"
    return str(value)
