"""graze.orbit: periodic orbits at the scene's own parameters."""

from __future__ import annotations

from typing import Sequence

from .entry import Entry
from .result import Result, result_kind


@result_kind("orbits")
class Orbits(Result):
    """Periodic orbits, each with its period, phases (rad), speeds (m/s), multipliers, stable; tables
    "orbits" (an impact a row: phase in rad, speed in m/s), "profiles" (their motions), "stuck",
    "contacts"."""

    main_table = "orbits"

    def _list(self) -> Sequence[Entry]:
        return self._of_document("orbits")
