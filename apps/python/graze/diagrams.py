"""graze.diagram: a sweep over a parameter, with the branches of orbits over it."""

from __future__ import annotations

from typing import Optional, Sequence, Union

from .command import command, result_kind
from .entry import Entry
from .result import Result
from .words import PathLike, Progress, SceneLike, Settings


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
    periods: int = 1000,
    samples: int = 100,
    exponents: Optional[int] = None,
    duration: Optional[float] = None,
    branches: Optional[str] = None,
    period: int = 1,
    max_step: Optional[float] = None,
    impacts: Union[None, int, str] = None,
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
