"""Planes of cells."""

from __future__ import annotations

from typing import Any, List

import numpy as np

from .branch_plot import draw_loci, label_plane
from .picture_style import add_legend, looks, one_axes


def plot_map(result: Any, axes: Any = None) -> Any:
    table = result.table("map")
    found = result.document["attractors"]
    names = {i: place["attractor"] for i, place in enumerate(found, start=1)}
    number = np.asarray(table["attractor"], dtype=float)
    shown = [names.get(int(n), f"attractor {int(n)}") if np.isfinite(n) else "none" for n in number]
    return _plot_cells(result, table, shown, axes)


def plot_comparison(result: Any, axes: Any = None) -> Any:
    table = result.table("comparison")
    same = table["one"] == table["other"]
    shown = [one if agree else "differs" for one, agree in zip(table["one"], same)]
    return _plot_cells(result, table, shown, axes)


def _plot_cells(result: Any, table: Any, shown: List[str], axes: Any) -> Any:
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    figure, cell = one_axes(axes, 8.0)
    x, columns = np.unique(table["x"], return_inverse=True)
    y, rows = np.unique(table["y"], return_inverse=True)
    labels = sorted(set(shown), key=lambda name: -shown.count(name))
    grounds = {name: look for look in looks()["grounds"].values() for name in (look["id"], look["title"])}
    others = iter(looks()["other_grounds"])
    colours = [
        grounds[name]["colour"] if name in grounds else next(others, grounds["other"]["colour"])
        for name in labels
    ]
    cells = np.full((len(y), len(x)), np.nan)
    cells[rows, columns] = [labels.index(name) for name in shown]
    cell.pcolormesh(
        x, y, np.ma.masked_invalid(cells), cmap=ListedColormap(colours or ["#FFFFFF"]),
        vmin=-0.5, vmax=max(len(labels), 1) - 0.5, shading="nearest", rasterized=True,
    )
    options = result.document["graze"]["options"]
    label_plane(cell, result, (options["parameter"], options["second"]))
    if "loci" in result.tables:
        draw_loci(cell, result.table("loci"))
    # A legend names those that have the most cells.
    add_legend(figure, axes, [Patch(color=c, label=name) for name, c in zip(labels, colours)][:9])
    return figure
