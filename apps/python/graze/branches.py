"""graze.continue_: branches of orbits over a parameter."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from .command import command, result_kind
from .result import Result
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("branches")
class Branches(Result):
    """Branches of orbits: tables "branches" (value in the parameter's unit, phase in rad, speed in m/s)
    and "special"."""

    main_table = "branches"

    def plot(self, axes: Any = None) -> Any:
        """Speed of the first impact, or what `show` named, over the parameter, with stability and
        special points."""
        from .branch_plot import plot_branches

        return plot_branches(self, axes)


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
    impacts: Optional[int] = None,
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
