"""graze.diagram: a sweep over a parameter, with the branches of orbits over it."""

from __future__ import annotations

from typing import Sequence

from .entry import Entry
from .result import Result, result_kind


@result_kind("diagram")
class Diagram(Result):
    """A bifurcation diagram, a list of its values with what the motion settles on at each; tables "sweep"
    (a sample a row: phase in rad, speed in m/s, displacement in m), "branches", "special", "exponents"
    (1/s)."""

    main_table = "sweep"
    asked_by = {"exponents": "exponents=1000"}

    def _list(self) -> Sequence[Entry]:
        return self._of_document("sweep", "rows")


@result_kind("run_diagram")
class RunDiagram(Result):
    """One run at each value, of a motion that no forcing repeats, a list of them; tables "sweep" (impacts:
    time in s, speed in m/s) and "runs" (what the probes saw)."""

    main_table = "sweep"

    def _list(self) -> Sequence[Entry]:
        return self._of_document("runs")
