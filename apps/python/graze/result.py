"""What all results have in common."""

from __future__ import annotations

import json
import operator
import os
from functools import cached_property
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence, Type, Union

import numpy as np

from . import _core
from .entry import Entry
from .errors import NoSuchName, unknown_name
from .scene import Scene
from .table import Table


_kinds: Dict[str, Type["Result"]] = {}


def result_kind(kind: str) -> Callable[[Type["Result"]], Type["Result"]]:
    """The class of results that the compiled part calls so."""

    def register(made: Type["Result"]) -> Type["Result"]:
        _kinds[kind] = made
        return made

    return register


def wrapped(found: "_core.FoundResult", scene: Scene) -> Optional["Result"]:
    """The result in the class of its kind."""
    return _kinds[found.kind](found, scene) if found.kind is not None else None


class Result:
    """What a function of graze returns: a list of what was found, `len(result)`, `result[0]`, `for one in
    result`, and tables of it. `print(result)` prints it as the program does."""

    #: The table that to_pandas() and a notebook show.
    main_table = ""
    #: How tables are asked for that there are not always.
    asked_by: Dict[str, str] = {}

    def __init__(self, found: "_core.FoundResult", scene: Scene) -> None:
        self._found = found
        self.scene = scene
        self._tables: Dict[str, Table] = {}

    @property
    def outcome(self) -> str:
        """How it ended, in the word of the program: "reached_end", "found", "complete", .."""
        return self._found.outcome

    @property
    def message(self) -> str:
        """A sentence unless all went well."""
        return self._found.message

    @property
    def warnings(self) -> List[str]:
        return self._found.warnings

    @property
    def tables(self) -> List[str]:
        """Names of the tables that there are, those that `out` writes into its folder."""
        return self._found.table_names()

    def table(self, name: str) -> Table:
        """A table by its name. Raises NoSuchName, a KeyError, where there is none such, and says how it
        is asked for."""
        if name not in self._tables:
            if name not in self.tables:
                raise self._without(name)
            self._tables[name] = Table(name, self._found.table(name))
        return self._tables[name]

    def _without(self, name: str) -> NoSuchName:
        if name in self.asked_by:
            asked = self.asked_by[name]
            return NoSuchName(f"this result has no table {name!r}; call the function with {asked}")
        return unknown_name("table", name, self.tables)

    def _list(self) -> Sequence[Any]:
        """What the result is a list of."""
        return _Rows(self.table(self.main_table)) if self.main_table in self.tables else ()

    @cached_property
    def _entries(self) -> Sequence[Any]:
        return self._list()

    def _of_document(self, *path: str) -> List[Entry]:
        """The list that stands there in the document."""
        part: Any = self.document
        for name in path:
            part = part.get(name, [])
        return [Entry.of_document(one) for one in part]

    def _by(self, column: str) -> List[Table]:
        """The main table in parts, over which nothing changes in that column."""
        table = self.table(self.main_table)
        values = table[column]
        ends = [*np.flatnonzero(values[1:] != values[:-1]) + 1, len(values)] if len(values) else []
        starts = [0, *ends[:-1]] if ends else []
        return [table.where(slice(a, b), f"{column} {values[a]}") for a, b in zip(starts, ends)]

    def __len__(self) -> int:
        return len(self._entries)

    def __bool__(self) -> bool:
        """A result is one, also where nothing was found."""
        return True

    def __getitem__(self, index: Any) -> Any:
        return self._entries[index]

    def __iter__(self) -> Iterator[Any]:
        return iter(self._entries)

    def to_pandas(self, table: str = "") -> Any:
        """A table as a DataFrame, by default the one that matters most."""
        return self.table(table or self.main_table).to_pandas()

    def to_json(self) -> str:
        """The whole result as JSON, units included."""
        return self._found.json()

    @cached_property
    def document(self) -> Dict[str, Any]:
        """The same as a dict."""
        return json.loads(self.to_json())

    def plot(self, axes: Any = None, *, show: Optional[str] = None, at: Optional[str] = None) -> Any:
        """Draws the result with matplotlib, in the units that the labels say; returns the Figure.
        `axes`: where to, a list of them for several panels. `show`: what is shown of it, in the words of the function's
        keyword of that name; `at`: the place, as "probe.1" or "stop.2"."""
        from .chart_plot import plot_chart

        chart = self._found.chart(show or "", at or "")
        if chart is None:
            raise ValueError("there is nothing to draw in this result")
        return plot_chart(chart, axes)

    def save_picture(
        self,
        file: Union[str, "os.PathLike[str]"],
        *,
        show: Optional[str] = None,
        at: Optional[str] = None,
    ) -> None:
        """Writes the picture that the program draws, .svg, .png or .pdf (by gnuplot), or the page for a
        browser, .html. `show` and `at` as for plot()."""
        self._found.save(os.fspath(file), show or "", at or "")

    def __str__(self) -> str:
        return self._found.text(False)

    def __repr__(self) -> str:
        return f"<graze.{type(self).__name__} of {self.scene.name!r}: {self.outcome}>"

    def _repr_html_(self) -> str:
        if self.main_table in self.tables:
            return self.table(self.main_table)._repr_html_()
        import html

        return f"<pre>{html.escape(str(self))}</pre>"


class _Rows(Sequence[Entry]):
    """The rows of a table."""

    def __init__(self, table: Table) -> None:
        self._table = table

    def __len__(self) -> int:
        return self._table.rows

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self._table.row(i) for i in range(*index.indices(len(self)))]
        at = operator.index(index)
        if not -len(self) <= at < len(self):
            raise IndexError(f"there are {len(self)} rows, and none {at}")
        return self._table.row(at % len(self))
