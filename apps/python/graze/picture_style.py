"""How things look: the looks of the program's pictures, for matplotlib."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, Dict, Sequence, Tuple

import numpy as np

from . import _core

#: Sizes for the column of a page, as the program's --style paper.
STYLE = {
    "font.family": "sans-serif",
    "font.size": 8.0,
    "axes.linewidth": 0.6,
    "axes.labelsize": 8.0,
    "xtick.labelsize": 7.0,
    "ytick.labelsize": 7.0,
    "legend.fontsize": 7.0,
    "legend.frameon": False,
    "savefig.bbox": "tight",
}
CENTIMETRE = 1.0 / 2.54


@lru_cache(maxsize=None)
def looks() -> Dict[str, Any]:
    """Looks by their groups and ids, as docs/gallery.md lists them."""
    return _core.looks()


def line_style(look: Dict[str, Any], with_line: bool = True, with_marks: bool = True) -> Dict[str, Any]:
    """Keywords of Axes.plot for a look."""
    style: Dict[str, Any] = {"color": look["colour"], "linewidth": 0.6 * max(look["width"], 0.5)}
    dashes = look["dashes"]
    style["linestyle"] = (0, tuple(dashes)) if dashes else "-"
    if not with_line:
        style["linestyle"] = "none"
    if with_marks and look["mark"]:
        style["marker"] = look["mark"]
        style["markersize"] = 5.5 * look["size"]
        style["markeredgewidth"] = 0.8
        if look["open"]:
            style["markerfacecolor"] = "white"
    return style


def unit_for(unit: str, values: Any) -> Tuple[float, str]:
    """(factor, unit) in which these SI values are read best."""
    finite = np.abs(values[np.isfinite(values)]) if len(values) else np.array([])
    return _core.axis_unit(unit, float(finite.max()) if finite.size else 1.0)


def label(name: str, unit: str) -> str:
    return f"{name} ({unit})" if unit else name


def new_figure(rows: int, columns: int, heights: Any = None, width: float = 12.0) -> Any:
    """(figure, axes as a grid)."""
    import matplotlib
    import matplotlib.pyplot as pyplot

    heights = heights or [5.0] * rows
    with pyplot.rc_context(STYLE):
        made = pyplot.subplots(
            rows,
            columns,
            squeeze=False,
            figsize=(width * CENTIMETRE, (sum(heights) + 1.8 * rows + 1.0) * CENTIMETRE),
            gridspec_kw={"height_ratios": heights},
            constrained_layout=True,
        )
        is_interactive = matplotlib.is_interactive()
    # The first figure of a notebook makes it one that shows figures; that is no part of the style.
    matplotlib.interactive(is_interactive)
    return made


def one_axes(axes: Any, height: float = 7.0) -> Any:
    """(figure, axes), new ones unless some are given."""
    if axes is not None:
        return axes.figure, axes
    figure, grid = new_figure(1, 1, [height])
    return figure, grid[0][0]


def add_legend(
    figure: Any, given: Any, more: Sequence[Any] = (), order: Sequence[str] = ()
) -> None:
    """Every title once: at the head of a figure of the package's own, within axes that were given.
    `more`: patches that stand in no axes. `order`: of the titles; others come first."""
    cells = figure.axes if given is None else [given]
    unique = {patch.get_label(): patch for patch in more}
    for cell in cells:
        handles, titles = cell.get_legend_handles_labels()
        unique.update({title: handle for title, handle in zip(titles, handles) if title not in unique})
    if not unique:
        return
    places = {title: place for place, title in enumerate(order)}
    unique = dict(sorted(unique.items(), key=lambda entry: places.get(entry[0], -1)))
    style = {"fontsize": 7.0, "frameon": False, "handlelength": 2.2}
    if given is not None:
        given.legend(unique.values(), unique.keys(), **style)
        return
    rows = -(-len(unique) // 3)
    figure.legend(unique.values(), unique.keys(), loc="upper left", ncol=3, **style)
    taken = (0.42 * rows + 0.2) * CENTIMETRE / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0.0, 0.0, 1.0, 1.0 - taken))
