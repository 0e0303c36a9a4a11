"""graze.orbit: periodic orbits at the scene's own parameters."""

from __future__ import annotations

from typing import Optional, Sequence, Union

from .command import command, result_kind
from .entry import Entry
from .result import Result
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("orbits")
class Orbits(Result):
    """Periodic orbits, each with its period, phases (rad), speeds (m/s), multipliers, stable; tables
    "orbits" (an impact a row: phase in rad, speed in m/s), "profiles" (their motions), "stuck",
    "contacts"."""

    main_table = "orbits"

    def _list(self) -> Sequence[Entry]:
        return self._of_document("orbits")


@command("orbit")
def orbit(
    scene: SceneLike,
    *,
    set: Settings = None,
    out: Optional[PathLike] = None,
    threads: int = 0,
    progress: Progress = None,
    period: int = 1,
    virtual: bool = False,
    start: Union[None, str, Sequence[str]] = None,
    random_seed: int = 1,
    impacts: Union[None, int, str] = None,
    closure_speed: Optional[float] = None,
    max_impacts: int = 10000000,
    max_seconds: float = 3600.0,
) -> Orbits:
    """Finds periodic orbits, stable or not. Raises NumericsError where there is none."""
    raise NotImplementedError  # the decorator does it
