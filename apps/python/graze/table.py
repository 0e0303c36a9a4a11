"""Tables of results: columns as NumPy arrays."""

from __future__ import annotations

import html
from typing import Any, Dict, Iterable, Iterator, List, Mapping, Sequence, Tuple, Union

import numpy as np

from .entry import Entry
from .errors import unknown_name


#: Of columns whose numbers are 1 for true, 0 for false and -1 for what is not known.
_TRUTH = np.dtype(np.int8)


class Table(Mapping[str, np.ndarray]):
    """Columns by their names, as in the table of the same name in a folder that `out` names. Numbers
    are read-only views of the result's own memory, with NaN for what does not exist; words come as an
    array of str; what is true or false as an array of bool, masked where it is not known."""

    def __init__(self, name: str, columns: Iterable[Tuple[str, Any]]) -> None:
        self.name = name
        self._columns: Dict[str, Any] = dict(columns)

    def __getitem__(self, column: str) -> np.ndarray:
        if column not in self._columns:
            raise unknown_name("column", column, self._columns)
        values = self._columns[column]
        if isinstance(values, tuple):
            codes, words = values
            return np.array(words + [""], dtype=object)[codes]
        return _truths(values) if values.dtype == _TRUTH else values

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        """Number of columns; `rows` is that of the rows."""
        return len(self._columns)

    @property
    def columns(self) -> List[str]:
        return list(self._columns)

    @property
    def rows(self) -> int:
        for values in self._columns.values():
            return len(values[0] if isinstance(values, tuple) else values)
        return 0

    def row(self, index: int) -> Entry:
        """A row, counted from 0."""
        return Entry({name: _scalar(values, index) for name, values in self._columns.items()})

    def where(self, chosen: Union[np.ndarray, slice], name: str = "") -> "Table":
        """The rows of which `chosen`, an array of bool or a slice, is true."""
        columns = (
            (column, (v[0][chosen], v[1]) if isinstance(v, tuple) else v[chosen])
            for column, v in self._columns.items()
        )
        return Table(name or self.name, columns)

    def to_pandas(self) -> Any:
        """A DataFrame; numbers are not copied until they are changed, words are categories, what is true
        or false is `boolean`, NA where it is not known: frame[frame.stable] are the stable ones."""
        import pandas

        series = {}
        for name, values in self._columns.items():
            if isinstance(values, tuple):
                series[name] = pandas.Categorical.from_codes(values[0], values[1])
            elif values.dtype == _TRUTH:
                series[name] = pandas.arrays.BooleanArray(values == 1, values < 0)
            else:
                series[name] = pandas.Series(values, copy=False)
        return pandas.DataFrame(series, copy=False)

    def __repr__(self) -> str:
        return f"<graze.Table {self.name!r}: {self.rows} rows of {', '.join(self.columns)}>"

    def _repr_html_(self) -> str:
        shown = min(self.rows, 10)
        heads = [self[name][:shown] for name in self.columns]
        title = self.name if shown == self.rows else f"{self.name}, the first {shown} of {self.rows} rows"
        return html_rows(title, self.columns, list(zip(*heads)))


def _truths(codes: np.ndarray) -> np.ndarray:
    holds = codes == 1
    holds.flags.writeable = False
    return np.ma.MaskedArray(holds, codes < 0) if (codes < 0).any() else holds


def _scalar(values: Any, index: int) -> Any:
    if isinstance(values, tuple):
        code = values[0][index]
        return values[1][code] if code >= 0 else None
    value = values[index]
    if values.dtype == _TRUTH:
        return None if value < 0 else bool(value)
    return value.item()


def html_rows(title: str, head: Sequence[str], rows: Sequence[Sequence[Any]]) -> str:
    """A table in HTML, everything in it escaped."""
    cells = "".join(f"<th>{html.escape(name)}</th>" for name in head)
    lines = [f"<table><caption>{html.escape(title)}</caption><thead><tr>{cells}</tr></thead><tbody>"]
    for row in rows:
        lines.append("<tr>" + "".join(f"<td>{html.escape(_cell(value))}</td>" for value in row) + "</tr>")
    return "".join(lines) + "</tbody></table>"


def _cell(value: Any) -> str:
    if isinstance(value, (float, np.floating)):
        return "" if np.isnan(value) else f"{value:.6g}"
    return str(value)
