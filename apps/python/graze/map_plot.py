"""Planes of cells."""

from __future__ import annotations

from typing import Any, List

import numpy as np

from .branch_plot import draw_loci, label_plane, shown_column
from .picture_style import add_legend, label, looks, one_axes, unit_for


def plot_map(result: Any, axes: Any = None) -> Any:
    table = result.table("map")
    show = result.document["graze"]["options"].get("show", "attractor")
    if show != "attractor":
        columns = {
            "impacts": ("impacts_per_period", "impacts a forcing period", ""),
            "speed": ("peak_speed", "peak speed", "m/s"),
            "stuck": ("stuck_part", "part of the time that it sticks", ""),
            "exponent": ("exponent", "largest exponent", "1/s"),
        }
        return _plot_scale(result, table, *columns.get(show) or shown_column(result, table), axes)
    found = result.document["attractors"]
    names = {i: place["attractor"] for i, place in enumerate(found, start=1)}
    number = np.asarray(table["attractor"], dtype=float)
    shown = [names.get(int(n), f"attractor {int(n)}") if np.isfinite(n) else "none" for n in number]
    return _plot_cells(result, table, shown, axes)


def plot_comparison(result: Any, axes: Any = None) -> Any:
    table = result.table("comparison")
    show = result.document["graze"]["options"]["show"]
    if show != "attractor":
        return _plot_scale(result, table, show, show.replace("_", " "), "", axes)
    same = table["one"] == table["other"]
    shown = [one if agree else "differs" for one, agree in zip(table["one"], same)]
    return _plot_cells(result, table, shown, axes)


def _plane(table: Any, values: Any) -> Any:
    """(x, y, values by rows and columns), NaN where there is no cell."""
    x, columns = np.unique(table["x"], return_inverse=True)
    y, rows = np.unique(table["y"], return_inverse=True)
    cells = np.full((len(y), len(x)), np.nan)
    cells[rows, columns] = values
    return x, y, np.ma.masked_invalid(cells)


def _plot_scale(result: Any, table: Any, column: str, title: str, unit: str, axes: Any) -> Any:
    figure, cell = one_axes(axes, 8.0)
    factor, unit = unit_for(unit, np.asarray(table[column], dtype=float))
    x, y, cells = _plane(table, factor * table[column])
    drawn = cell.pcolormesh(x, y, cells, cmap="viridis", shading="nearest", rasterized=True)
    figure.colorbar(drawn, ax=cell, label=label(title, unit))
    options = result.document["graze"]["options"]
    label_plane(cell, result, (options["parameter"], options["second"]))
    return figure


def _plot_cells(result: Any, table: Any, shown: List[str], axes: Any) -> Any:
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    figure, cell = one_axes(axes, 8.0)
    labels = sorted(set(shown), key=lambda name: -shown.count(name))
    grounds = {name: look for look in looks()["grounds"].values() for name in (look["id"], look["title"])}
    others = iter(looks()["other_grounds"])
    colours = [grounds[name]["colour"] if name in grounds else next(others, None) for name in labels]
    # Those beyond the colours that there are share one.
    rest = [name for name, colour in zip(labels, colours) if colour is None]
    told = {name: colour for name, colour in zip(labels, colours) if colour}
    if rest:
        told[rest[0] if len(rest) == 1 else f"{len(rest)} other motions"] = grounds["other"]["colour"]
    colours = [colour or grounds["other"]["colour"] for colour in colours]
    x, y, cells = _plane(table, [labels.index(name) for name in shown])
    cell.pcolormesh(
        x, y, cells, cmap=ListedColormap(colours or ["#FFFFFF"]),
        vmin=-0.5, vmax=max(len(labels), 1) - 0.5, shading="nearest", rasterized=True,
    )
    options = result.document["graze"]["options"]
    label_plane(cell, result, (options["parameter"], options["second"]))
    if "loci" in result.tables:
        draw_loci(cell, result.table("loci"))
    add_legend(figure, axes, [Patch(color=colour, label=name) for name, colour in told.items()])
    return figure
