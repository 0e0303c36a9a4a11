"""Charts of the library (the same that gnuplot and the pages draw) by matplotlib."""

from __future__ import annotations

from typing import Any, Dict, List, Tuple

import numpy as np

from .picture_style import STYLE, add_legend, label, line_style, new_figure


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
        add_legend(given[0].figure, given[0], _patches(chart), chart["legend"])
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
    add_legend(figure, None, _patches(chart), chart["legend"])
    return figure


def _patches(chart: Dict[str, Any]) -> List[Any]:
    """The grounds of cells that there are, for a legend."""
    from matplotlib.patches import Patch

    used = []
    for row in chart["rows"]:
        for panel in row:
            cells = panel["cells"]
            for i in np.unique(cells["ground"]) if cells else []:
                if i >= 0:
                    title, colour = cells["grounds"][i]
                    used.append(Patch(facecolor=colour, edgecolor="#999999", linewidth=0.4, label=title))
    return used


def _one_axis(upper: Dict[str, Any], lower: Dict[str, Any]) -> bool:
    """Whether panels one below the other share the name of their axis."""
    return all(upper[key] == lower[key] for key in ("name", "unit", "range")) and bool(upper["range"])


def _draw_panel(axes: Any, panel: Dict[str, Any]) -> None:
    across, up = panel["x"], panel["y"]
    if panel["cells"]:
        _draw_cells(axes, panel)
    for fill in panel["fills"]:
        scaled = (up if fill["is_upright"] else across)["factor"]
        ends = [_within(axes, scaled * fill[end], end, fill["is_upright"]) for end in ("from", "to")]
        span = axes.axhspan if fill["is_upright"] else axes.axvspan
        span(*ends, color=fill["colour"], linewidth=0.0, zorder=0, label=fill["title"] or None)
    for series in panel["series"]:
        style = line_style(series["look"], series["is_line"], series["has_marks"])
        x, y = across["factor"] * series["x"], up["factor"] * series["y"]
        if panel["cells"] and series["is_line"]:
            seam = {**style, "color": "#FFFFFF", "linestyle": "-", "linewidth": style["linewidth"] + 1.0}
            axes.plot(x, y, **seam)
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
    _write_names(axes, panel)
    if panel["heading"]:
        axes.set_title(panel["heading"], fontsize=8.0)
    if panel["remark"]:
        axes.text(0.5, 0.5, panel["remark"], transform=axes.transAxes, ha="center", fontsize=8.0)


def _draw_cells(axes: Any, panel: Dict[str, Any]) -> None:
    """Each in its ground, or by its number in the colours of the bar; what has neither stays white."""
    from matplotlib.colors import LinearSegmentedColormap, ListedColormap

    cells = panel["cells"]
    shape = (cells["rows"], cells["columns"])
    edges = [
        panel[which]["factor"] * np.linspace(cells[which][0], cells[which][1], count + 1)
        for which, count in (("x", cells["columns"]), ("y", cells["rows"]))
    ]
    style = {"shading": "flat", "rasterized": True}
    ground = cells["ground"].reshape(shape)
    if cells["grounds"]:
        colours = ListedColormap([colour for _, colour in cells["grounds"]])
        axes.pcolormesh(
            *edges, np.ma.masked_less(ground, 0), cmap=colours, vmin=-0.5,
            vmax=len(cells["grounds"]) - 0.5, **style,
        )
    if not len(cells["numbers"]):
        return
    bar = cells["bar"]
    numbers = np.ma.masked_invalid(bar["factor"] * cells["numbers"].reshape(shape))
    low, high = (bar["factor"] * end for end in bar["range"])
    colours = LinearSegmentedColormap.from_list("cells", cells["colours"])
    drawn = axes.pcolormesh(*edges, numbers, cmap=colours, vmin=low, vmax=high, **style)
    beside = axes.figure.colorbar(drawn, ax=axes)
    beside.set_label(label(bar["name"], bar["unit"]), fontsize=STYLE["axes.labelsize"])
    beside.ax.tick_params(labelsize=STYLE["ytick.labelsize"])


def _write_names(axes: Any, panel: Dict[str, Any]) -> None:
    """Points with their names, those that stand too close for names of their own with one; areas over
    several lines. Curves are told apart by the legend."""
    spans = np.array([np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())])
    factors = np.array([panel["x"]["factor"], panel["y"]["factor"]])
    points: List[Tuple[List[str], Any]] = []
    for name in panel["names"]:
        place = factors * np.array(name["places"][0]) if name["places"] else spans * np.nan
        if name["of"] == "area":
            axes.text(*place, name["text"], ha="center", va="center", fontsize=7.0)
        elif name["of"] == "point":
            near = [names for names, at in points if np.abs((at - place) / spans).max() < 0.03]
            if near:
                near[0].append(name["text"])
            else:
                points.append(([name["text"]], place))
    for names, place in points:
        text = ", ".join(names) if len(names) < 3 else f"{names[0]} and {len(names) - 1} more"
        axes.annotate(text, place, fontsize=6.0, xytext=(2, 2), textcoords="offset points", clip_on=True)


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
