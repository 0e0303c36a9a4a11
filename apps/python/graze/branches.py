"""graze.continue_: branches of orbits over a parameter."""

from __future__ import annotations

from typing import Optional, Sequence, Union

from .command import command, result_kind
from .result import Result
from .table import Table
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("branches")
class Branches(Result):
    """Branches of orbits, each a table of its points; all of them in the table "branches" (value in the
    parameter's unit, phase in rad, speed in m/s), special points in "special"."""

    main_table = "branches"

    def _list(self) -> Sequence[Table]:
        return self._by("branch")


@command("continue")
def continue_(
    scene: SceneLike,
    *,
    parameter: str,
    from_: float,
    to: float,
    set: Settings = None,
    out: Optional[PathLike] = None,
    threads: int = 0,
    progress: Progress = None,
    period: int = 1,
    virtual: bool = False,
    start: Union[None, str, Sequence[str]] = None,
    random_seed: int = 1,
    max_step: Optional[float] = None,
    impacts: Union[None, int, str] = None,
    follow: str = "none",
    depth: int = 2,
    amplitudes: bool = False,
    show: Optional[str] = None,
    at: Optional[str] = None,
    restart: Optional[PathLike] = None,
    label: Optional[str] = None,
    switch: bool = False,
    closure_speed: Optional[float] = None,
    max_impacts: int = 10000000,
    max_seconds: float = 3600.0,
) -> Branches:
    """Traces branches of periodic orbits over a parameter of the scene, from `from_` to `to` in the unit
    of that parameter.
    """
    raise NotImplementedError  # the decorator does it
