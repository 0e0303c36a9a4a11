"""graze.diagram: a sweep over a parameter, with the branches of orbits over it."""

from __future__ import annotations

from typing import Any, Optional, Union

from .command import command, result_kind
from .result import Result
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("diagram")
class Diagram(Result):
    """A bifurcation diagram: tables "sweep" (a sample a row: phase in rad, speed in m/s, displacement in
    m), "branches", "special", "exponents" (1/s)."""

    main_table = "sweep"

    def plot(self, axes: Any = None) -> Any:
        """Every sample over the parameter, with the branches."""
        from .branch_plot import plot_diagram

        return plot_diagram(self, axes)


@result_kind("run_diagram")
class RunDiagram(Result):
    """One run at each value, of a motion that no forcing repeats: tables "sweep" (impacts: time in s,
    speed in m/s) and "runs" (what the probes saw)."""

    main_table = "sweep"


@command("diagram")
def diagram(
    scene: SceneLike,
    *,
    parameter: str,
    from_: float,
    to: float,
    points: int = 400,
    direction: str = "up",
    section: str = "impact",
    set: Settings = None,
    out: Optional[PathLike] = None,
    threads: int = 0,
    progress: Progress = None,
    periods: Optional[int] = None,
    samples: int = 100,
    exponents: Optional[int] = None,
    duration: Optional[float] = None,
    branches: str = "all",
    period: int = 1,
    max_step: Optional[float] = None,
    impacts: Optional[int] = None,
    follow: str = "none",
    depth: int = 2,
    amplitudes: bool = False,
    show: Optional[str] = None,
    at: Optional[str] = None,
    resume: bool = False,
    restart_work: bool = False,
    shard: Optional[str] = None,
    closure_speed: Optional[float] = None,
    max_impacts: int = 10000000,
    max_seconds: float = 3600.0,
) -> Union[Diagram, RunDiagram]:
    """Sweeps a parameter and traces the branches over it. Without forcing, one run of `duration` s at
    each value.
    """
    raise NotImplementedError  # the decorator does it
