"""Loci of special points, and branches of equations of your own."""

from __future__ import annotations

from typing import Any, Iterator, List, Tuple

import numpy as np

from . import _core
from .picture_style import add_legend, label, line_style, looks, one_axes, unit_for


def plot_loci(result: Any, axes: Any = None) -> Any:
    figure, cell = one_axes(axes)
    draw_loci(cell, result.table("loci"))
    special = result.table("special")
    if special.rows:
        cell.plot(special["value"], special["second"], "o", color="#000000", markersize=3.0)
        for names, place in _named_places(cell, special):
            cell.annotate(names, place, fontsize=6.0, xytext=(2, 2), textcoords="offset points")
    options = result.document["graze"]["options"]
    for which, key in (("x", "parameter"), ("y", "second")):
        name = options[key]
        settle_parameter(cell, which, _core.parameter_title(name), result.scene.unit(name))
    add_legend(figure, axes)
    return figure


def _named_places(cell: Any, special: Any) -> List[Tuple[str, Tuple[float, float]]]:
    """The points with their names; those that stand too close for names of their own have one."""
    spans = np.array([np.ptp(cell.get_xlim()), np.ptp(cell.get_ylim())])
    places: List[Tuple[str, Tuple[float, float]]] = []
    for name, x, y in zip(special["id"], special["value"], special["second"]):
        for i, (names, place) in enumerate(places):
            if np.abs((np.array((x, y)) - place) / spans).max() < 0.03:
                places[i] = (f"{names}, {name}", place)
                break
        else:
            places.append((str(name), (x, y)))
    return places


def draw_loci(cell: Any, loci: Any) -> None:
    """Each kind in its colour and dash, parts that are none of the system grey."""
    labels, admissible = loci["label"], loci["admissible"]
    for part in _runs(loci["locus"], admissible):
        look = looks()["loci"]["virtual" if admissible[part][0] == 0 else labels[part][0]]
        cell.plot(loci["value"][part], loci["second"][part], label=look["title"], **line_style(look))


def plot_equations(branch: Any, unknown: int, axes: Any = None) -> Any:
    figure, cell = one_axes(axes)
    cell.plot(branch.p, branch.u[:, unknown], color=looks()["curves"][0], linewidth=1.2)
    for point in branch.special:
        look = looks()["special"][point.label]
        cell.plot(
            [point.p], [point.u[unknown]], label=look["title"], **line_style(look, with_line=False)
        )
    cell.set_xlabel("p")
    cell.set_ylabel(f"u{unknown + 1}")
    add_legend(figure, axes)
    return figure


def _runs(*lists: Any) -> Iterator[slice]:
    """Parts over which nothing of the lists changes; each ends where the next one begins."""
    count = len(lists[0])
    if count == 0:
        return
    changes = np.zeros(count - 1, dtype=bool)
    for values in lists:
        changes |= values[1:] != values[:-1]
    same_curve = lists[0][1:] == lists[0][:-1]
    start = 0
    for end in np.flatnonzero(changes):
        # A line of one curve goes on to where it looks otherwise.
        yield slice(start, end + 1 + int(same_curve[end]))
        start = end + 1
    yield slice(start, count)


def settle_parameter(cell: Any, which: str, title: str, unit: str) -> None:
    """Of axes on which all is drawn. They stay in SI units; what is written at them is in those that
    read best."""
    from matplotlib.ticker import FuncFormatter

    axis = getattr(cell, f"{which}axis")
    factor, unit = unit_for(unit, np.array(axis.get_view_interval()))
    if factor != 1.0:
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{factor * value:.6g}"))
    axis.set_label_text(label(title, unit))
