"""graze.cost: what accuracy costs in time, flow by flow."""

from __future__ import annotations

from typing import Optional

from .command import command, result_kind
from .result import Result
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("cost")
class Cost(Result):
    """Errors and times: tables "costs" (a flow and setting a row), "costs_of_modes", .."""

    main_table = "costs"


@command("cost")
def cost(
    scene: SceneLike,
    *,
    set: Settings = None,
    out: Optional[PathLike] = None,
    threads: int = 0,
    progress: Progress = None,
    impacts: int = 20,
    duration: Optional[float] = None,
    closure_speed: Optional[float] = None,
    max_impacts: int = 10000000,
    max_seconds: float = 3600.0,
) -> Cost:
    """Measures what accuracy costs in computing time, flow by flow."""
    raise NotImplementedError  # the decorator does it
