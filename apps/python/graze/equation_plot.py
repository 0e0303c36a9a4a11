"""Branches of equations of your own."""

from __future__ import annotations

from typing import Any

from .picture_style import add_legend, line_style, looks, one_axes


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
