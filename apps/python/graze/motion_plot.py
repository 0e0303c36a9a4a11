"""Motions over time."""

from __future__ import annotations

from typing import Any

import numpy as np

from .picture_style import add_legend, label, looks, new_figure, one_axes, unit_for


def plot_motion(result: Any, axes: Any = None) -> Any:
    if "samples" in result.tables and result.scene.stops > 0:
        return _plot_gaps(result, axes)
    if "events" not in result.tables:
        raise ValueError("a run that was read has its events in its folder; save_picture() draws it")
    return _plot_speeds(result, axes)


def _plot_gaps(result: Any, axes: Any) -> Any:
    samples, events = result.samples, result.events
    count = result.scene.stops
    if axes is not None:
        figure, grid = axes.figure, [[axes]]
        count = 1
    else:
        figure, grid = new_figure(min(count, 4), 1, [3.5] * min(count, 4))
    impacts = np.isin(events["kind"], ["impact", "contact"])
    for stop, (cell,) in enumerate(grid, start=1):
        gap = samples[f"gap{stop}"]
        factor, unit = unit_for(result._found.unit("m"), gap)
        cell.plot(samples["time"], factor * gap, color=looks()["curves"][0], linewidth=0.9)
        at = events["time"][impacts & (events["stop"] == stop)]
        cell.plot(
            at, np.zeros(len(at)), ".", color=looks()["curves"][1], markersize=3.0, label="impacts"
        )
        cell.axhline(0.0, color="#999999", linewidth=0.6)
        cell.set_ylabel(label(f"gap {stop}" if result.scene.stops > 1 else "gap", unit))
    grid[-1][0].set_xlabel(label("time", result._found.unit("s")))
    add_legend(figure, axes)
    return figure


def _plot_speeds(result: Any, axes: Any) -> Any:
    figure, cell = one_axes(axes)
    events = result.events
    impacts = np.isin(events["kind"], ["impact", "contact"])
    speed = events["speed"][impacts]
    factor, unit = unit_for(result._found.unit("m/s"), speed)
    stops = events["stop"][impacts]
    for stop in range(1, result.scene.stops + 1):
        of = stops == stop
        colour = looks()["curves"][(stop - 1) % len(looks()["curves"])]
        cell.plot(
            events["time"][impacts][of], factor * speed[of], ".", color=colour, markersize=3.0,
            label=f"stop {stop}",
        )
    cell.set_xlabel(label("time", result._found.unit("s")))
    cell.set_ylabel(label("impact speed", unit))
    add_legend(figure, axes)
    return figure
