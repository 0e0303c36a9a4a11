"""Charts of the library (the same that gnuplot and the pages draw) by matplotlib."""

from __future__ import annotations

from typing import Any, Dict

import numpy as np

from .picture_style import add_legend, label, line_style, new_figure


def plot_chart(chart: Dict[str, Any], axes: Any = None) -> Any:
    rows = chart["rows"]
    if axes is not None:
        given = np.atleast_1d(np.asarray(axes, dtype=object)).ravel()
        panels = [panel for row in rows for panel in row]
        if len(given) != len(panels):
            raise ValueError(
                f"axes: this picture has {len(panels)} panels; give a list of as many, or leave it out"
            )
        for cell, panel in zip(given, panels):
            _draw_panel(cell, panel)
        add_legend(given[0].figure, given[0])
        return given[0].figure
    columns = max(len(row) for row in rows)
    heights = [max(panel["height"] for panel in row) for row in rows]
    figure, grid = new_figure(len(rows), columns, heights)
    for cells, row in zip(grid, rows):
        for cell, panel in zip(cells, row):
            _draw_panel(cell, panel)
        for unused in cells[len(row):]:
            unused.set_axis_off()
    for upper, lower, cells in zip(rows, rows[1:], grid):
        if len(upper) == len(lower) == 1 and _one_axis(upper[0]["x"], lower[0]["x"]):
            cells[0].set_xlabel("")
    add_legend(figure, None)
    return figure


def _one_axis(upper: Dict[str, Any], lower: Dict[str, Any]) -> bool:
    """Whether panels one below the other share the name of their axis."""
    return all(upper[key] == lower[key] for key in ("name", "unit", "range")) and bool(upper["range"])


def _draw_panel(axes: Any, panel: Dict[str, Any]) -> None:
    across, up = panel["x"], panel["y"]
    for fill in panel["fills"]:
        scaled = (up if fill["is_upright"] else across)["factor"]
        ends = [_within(axes, scaled * fill[end], end, fill["is_upright"]) for end in ("from", "to")]
        span = axes.axhspan if fill["is_upright"] else axes.axvspan
        span(*ends, color=fill["colour"], linewidth=0.0, zorder=0, label=fill["title"] or None)
    for series in panel["series"]:
        style = line_style(series["look"], series["is_line"], series["has_marks"])
        x, y = across["factor"] * series["x"], up["factor"] * series["y"]
        axes.plot(x, y, label=series["title"] or None, **style)
        if len(series["error"]):
            axes.errorbar(
                x, y, up["factor"] * series["error"], fmt="none", ecolor=series["look"]["colour"],
                elinewidth=0.6,
            )
    for level in panel["levels"]:
        axes.axhline(up["factor"] * level, color="#999999", linewidth=0.6)
    _settle(axes, across, "x")
    _settle(axes, up, "y")
    if panel["heading"]:
        axes.set_title(panel["heading"], fontsize=8.0)
    if panel["remark"]:
        axes.text(0.5, 0.5, panel["remark"], transform=axes.transAxes, ha="center", fontsize=8.0)


def _within(axes: Any, value: float, end: str, is_upright: bool) -> float:
    """The value, or where the axis ends."""
    if np.isfinite(value):
        return value
    low, high = axes.get_ylim() if is_upright else axes.get_xlim()
    return low if end == "from" else high


def _settle(axes: Any, axis: Dict[str, Any], which: str) -> None:
    getattr(axes, f"set_{which}label")(label(axis["name"], axis["unit"]))
    if axis["scale"] == "log":
        getattr(axes, f"set_{which}scale")("log")
    limits = getattr(axes, f"set_{which}lim")
    if axis["range"]:
        low, high = (axis["factor"] * end for end in axis["range"])
        if low < high:
            limits(low, high)
    elif axis["from_zero"] and axis["scale"] == "linear":
        low, high = getattr(axes, f"get_{which}lim")()
        limits(min(low, 0.0), max(high, 0.0))
