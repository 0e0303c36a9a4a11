"""Planes of cells, as the compiled part says what they show (apps/python/charts.hpp)."""

from __future__ import annotations

from typing import Any, Dict

import numpy as np

from .branch_plot import draw_loci, settle_parameter
from .picture_style import STYLE, add_legend, label, one_axes, unit_for


def plot_plane(result: Any, plane: Dict[str, Any], axes: Any = None) -> Any:
    from matplotlib.patches import Patch

    figure, cell = one_axes(axes, 8.0)
    patches = []
    if "values" in plane:
        _draw_values(figure, cell, plane)
    else:
        _draw_entries(cell, plane)
        patches = [Patch(color=colour, label=name) for name, colour in plane["legend"]]
    for which in "xy":
        settle_parameter(cell, which, plane[f"{which}_name"], plane[f"{which}_unit"])
    if "loci" in result.tables:
        draw_loci(cell, result.table("loci"))
    add_legend(figure, axes, patches)
    return figure


def _cells(plane: Dict[str, Any], values: Any) -> Any:
    shape = (len(plane["y"]), len(plane["x"]))
    return np.ma.masked_invalid(np.asarray(values, dtype=float)).reshape(shape)


def _draw_values(figure: Any, cell: Any, plane: Dict[str, Any]) -> None:
    factor, unit = unit_for(plane["unit"], plane["values"])
    values = _cells(plane, factor * plane["values"])
    look: Dict[str, Any] = {"cmap": "viridis"}
    if plane["is_signed"] and values.count() > 0:
        largest = float(np.abs(values).max()) or 1.0
        look = {"cmap": "RdBu_r", "vmin": -largest, "vmax": largest}
    drawn = cell.pcolormesh(plane["x"], plane["y"], values, shading="nearest", rasterized=True, **look)
    bar = figure.colorbar(drawn, ax=cell)
    bar.set_label(label(plane["title"], unit), fontsize=STYLE["axes.labelsize"])
    bar.ax.tick_params(labelsize=STYLE["ytick.labelsize"])


def _draw_entries(cell: Any, plane: Dict[str, Any]) -> None:
    from matplotlib.colors import ListedColormap

    entry = np.where(plane["entry"] < 0, np.nan, plane["entry"])
    colours = [colour for _, colour in plane["legend"]] or ["#FFFFFF"]
    cell.pcolormesh(
        plane["x"], plane["y"], _cells(plane, entry), cmap=ListedColormap(colours),
        vmin=-0.5, vmax=len(colours) - 0.5, shading="nearest", rasterized=True,
    )
