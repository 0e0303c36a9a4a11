"""Planes of cells."""

from __future__ import annotations

from typing import Any, Dict, List

import numpy as np

from .branch_plot import draw_loci, label_plane
from .picture_style import add_legend, looks, one_axes


def plot_map(result: Any, axes: Any = None) -> Any:
    table = result.table("map")
    names = {place["attractor"]: place["label"] for place in _attractors(result)}
    number = np.asarray(table["attractor"], dtype=float)
    shown = [names.get(int(n), f"attractor {int(n)}") if np.isfinite(n) else "none" for n in number]
    figure = _plot_cells(result, table, shown, axes)
    if "loci" in result.tables:
        draw_loci(figure.axes[0] if axes is None else axes, result.table("loci"))
    return figure


def plot_comparison(result: Any, axes: Any = None) -> Any:
    table = result.table("comparison")
    same = table["one"] == table["other"]
    shown = [one if agree else "differs" for one, agree in zip(table["one"], same)]
    return _plot_cells(result, table, shown, axes)


def _attractors(result: Any) -> List[Dict[str, Any]]:
    found = result.document.get("attractors", [])
    return [
        {"attractor": i + 1, "label": str(place.get("label", place.get("kind", i + 1)))}
        for i, place in enumerate(found)
    ]


def _plot_cells(result: Any, table: Any, shown: List[str], axes: Any) -> Any:
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    figure, cell = one_axes(axes, 8.0)
    x, columns = np.unique(table["x"], return_inverse=True)
    y, rows = np.unique(table["y"], return_inverse=True)
    labels = sorted(set(shown), key=lambda name: -shown.count(name))
    grounds = looks()["grounds"]
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
    handles = [Patch(color=colour, label=name) for name, colour in zip(labels, colours)]
    add_legend(cell)
    cell.add_artist(
        cell.legend(handles=handles[:9], loc="upper left", bbox_to_anchor=(0.0, -0.16), ncol=3,
                    fontsize=7.0, frameon=False)
    )
    return figure
