"""What all results have in common."""

from __future__ import annotations

import json
import os
from functools import cached_property
from typing import Any, Dict, List, Union

from . import _core
from .scene import Scene
from .table import Table


class Result:
    """What a function of graze returns. `print(result)` prints what the program prints."""

    #: The table that to_pandas() and a notebook show.
    main_table = ""

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
        """Names of the tables that there are, those that the program's --out writes."""
        return self._found.table_names()

    def table(self, name: str) -> Table:
        """A table by its name; KeyError where there is none such."""
        if name not in self._tables:
            self._tables[name] = Table(name, self._found.table(name))
        return self._tables[name]

    def to_pandas(self, table: str = "") -> Any:
        """A table as a DataFrame, by default the one that matters most."""
        return self.table(table or self.main_table).to_pandas()

    def to_json(self) -> str:
        """The document that the program prints with --json, units included."""
        return self._found.json()

    @cached_property
    def document(self) -> Dict[str, Any]:
        """The same as a dict."""
        return json.loads(self.to_json())

    def plot(self, axes: Any = None) -> Any:
        """Draws the result with matplotlib, in SI units or thousandths of them as the labels say;
        returns the Figure. `axes`: where to, if it is one panel."""
        from .chart_plot import plot_chart

        chart = self._found.chart()
        if chart is None:
            raise ValueError("there is nothing to draw in this result")
        return plot_chart(chart, axes)

    def save_picture(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """The picture that the program's --plot draws, .svg, .png or .pdf (by gnuplot), or the page
        for a browser, .html."""
        self._found.save(os.fspath(file))

    def __str__(self) -> str:
        return self._found.text(False)

    def __repr__(self) -> str:
        return f"<graze.{type(self).__name__} of {self.scene.name!r}: {self.outcome}>"

    def _repr_html_(self) -> str:
        if self.main_table in self.tables:
            return self.table(self.main_table)._repr_html_()
        import html

        return f"<pre>{html.escape(str(self))}</pre>"
