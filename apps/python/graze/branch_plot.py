"""Branches, loci and diagrams."""

from __future__ import annotations

from typing import Any, Iterator, List, Tuple

import numpy as np

from . import _core
from .picture_style import add_legend, label, line_style, looks, one_axes, unit_for


def plot_branches(result: Any, axes: Any = None) -> Any:
    figure, cell = one_axes(axes)
    _draw_branches(cell, result)
    _label_parameter(cell, result, result.document["parameter"], "x")
    add_legend(figure, axes)
    return figure


def plot_diagram(result: Any, axes: Any = None) -> Any:
    figure, cell = one_axes(axes)
    sweep = result.table("sweep")
    name, title, unit = shown_column(result, sweep)
    has_branches = name != "speed" or bool(np.any(np.isfinite(sweep["speed"])))
    if not has_branches:
        name, title, unit = "displacement", "displacement", "m"
    factor, unit = unit_for(unit, sweep[name])
    repeats = np.isfinite(np.asarray(sweep["period"], dtype=float))
    for which, dots in ((repeats, "periodic"), (~repeats, "wild")):
        if which.any():
            look = looks()["dots"][dots]
            style = line_style(look, with_line=False)
            cell.plot(
                sweep["value"][which], factor * sweep[name][which], label=look["title"],
                **{**style, "markersize": 1.5},
            )
    if has_branches and result.table("branches").rows:
        _draw_branches(cell, result)
    cell.set_ylabel(label(title, unit))
    _label_parameter(cell, result, result.document["parameter"], "x")
    add_legend(figure, axes)
    return figure


def plot_loci(result: Any, axes: Any = None) -> Any:
    figure, cell = one_axes(axes)
    draw_loci(cell, result.table("loci"))
    special = result.table("special")
    if special.rows:
        cell.plot(special["value"], special["second"], "o", color="#000000", markersize=3.0)
        for names, place in _named_places(cell, special):
            cell.annotate(names, place, fontsize=6.0, xytext=(2, 2), textcoords="offset points")
    options = result.document["graze"]["options"]
    _label_parameter(cell, result, options["parameter"], "x")
    _label_parameter(cell, result, options["second"], "y")
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


def shown_column(result: Any, table: Any) -> Tuple[str, str, str]:
    """(column, title, unit) of what `show` named; of impacts where it named nothing."""
    shown = result._found.shown()
    if shown is None:
        return "speed", "impact speed", "m/s"
    options = result.document["graze"]["options"]
    ending = "_" + options["show"].replace("-", "_")
    place = options.get("at", "").replace(".", "_")
    columns = [name for name in table.columns if name.startswith(place) and name.endswith(ending)]
    return min(columns, key=len), shown[0], shown[1]


def _draw_branches(cell: Any, result: Any) -> None:
    branches, special = result.table("branches"), result.table("special")
    column, title, unit = shown_column(result, branches)
    factor, unit = unit_for(unit, branches[column])
    stable = np.asarray(branches["stable"], dtype=float)
    kinds = np.where(np.isnan(stable), "open", np.where(stable == 1.0, "stable", "unstable"))
    kinds = np.where(branches["admissible"] == 0, "virtual", kinds)
    for part in _runs(branches["branch"], kinds):
        look = looks()["lines"][str(kinds[part][0])]
        x, y = branches["value"][part], factor * branches[column][part]
        cell.plot(x, y, label=look["title"], **line_style(look))
    known = looks()["special"]
    # What is measured is known at the points of the branches alone.
    for name in np.unique(special["label"].astype(str)) if special.rows and column == "speed" else ():
        of = special["label"] == name
        look = known.get(name, known["LP"])
        cell.plot(
            special["value"][of], factor * special["speed"][of], label=look["title"],
            **line_style(look, with_line=False),
        )
    cell.set_ylabel(label(title, unit))


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


def _label_parameter(cell: Any, result: Any, name: str, which: str) -> None:
    """Of axes on which all is drawn. They stay in SI units; what is written at them is in those that
    read best."""
    from matplotlib.ticker import FuncFormatter

    axis = getattr(cell, f"{which}axis")
    factor, unit = unit_for(result.scene.unit(name), np.array(axis.get_view_interval()))
    if factor != 1.0:
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{factor * value:.6g}"))
    axis.set_label_text(label(_core.parameter_title(name), unit))


def label_plane(cell: Any, result: Any, names: Tuple[str, str]) -> None:
    """Both axes by the numbers of the scene that they are."""
    for which, name in zip("xy", names):
        _label_parameter(cell, result, name, which)
