"""graze.continue_: branches of orbits over a parameter."""

from __future__ import annotations

from typing import Sequence

from .result import Result, result_kind
from .table import Table


@result_kind("branches")
class Branches(Result):
    """Branches of orbits, each a table of its points; all of them in the table "branches" (value in the
    parameter's unit, phase in rad, speed in m/s), special points in "special"."""

    main_table = "branches"

    def _list(self) -> Sequence[Table]:
        return self._by("branch")
