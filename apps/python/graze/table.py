"""Tables of results: columns as NumPy arrays."""

from __future__ import annotations

import html
from typing import Any, Dict, Iterable, Iterator, List, Mapping, Sequence, Tuple

import numpy as np


class Table(Mapping[str, np.ndarray]):
    """Columns by their names, as in the table of the same name that the program writes. Numbers are
    read-only views of the result's own memory, with NaN for what does not exist; words come as an
    array of str."""

    def __init__(self, name: str, columns: Iterable[Tuple[str, Any]]) -> None:
        self.name = name
        self._columns: Dict[str, Any] = dict(columns)

    def __getitem__(self, column: str) -> np.ndarray:
        values = self._columns[column]
        if isinstance(values, tuple):
            codes, words = values
            return np.array(words + [""], dtype=object)[codes]
        return values

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

    def to_pandas(self) -> Any:
        """A DataFrame; numbers are not copied until they are changed, words are categories."""
        import pandas

        series = {}
        for name, values in self._columns.items():
            if isinstance(values, tuple):
                series[name] = pandas.Categorical.from_codes(values[0], values[1])
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
