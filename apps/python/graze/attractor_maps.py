"""graze.map: what the motion settles on over two parameters, or two coordinates of its start."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from .command import command, result_kind
from .result import Result
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("map")
class Map(Result):
    """What the motion settles on in every cell, a list of the cells; tables "map" (a cell a row:
    peak_speed in m/s, exponent in 1/s) and "loci"."""

    main_table = "map"
    asked_by = {"loci": 'locus="all"'}


@command("map")
def map(
    scene: SceneLike,
    *,
    parameter: str,
    from_: float,
    to: float,
    second: str,
    second_from: float,
    second_to: float,
    points: int = 100,
    second_points: int = 100,
    set: Settings = None,
    out: Optional[PathLike] = None,
    threads: int = 0,
    progress: Progress = None,
    periods: int = 1000,
    samples: int = 100,
    exponents: Optional[int] = None,
    amplitudes: bool = False,
    show: str = "attractor",
    at: Optional[str] = None,
    locus: Union[None, str, Sequence[str]] = None,
    slices: int = 8,
    period: int = 1,
    impacts: Optional[int] = None,
    resume: bool = False,
    restart_work: bool = False,
    shard: Optional[str] = None,
    closure_speed: Optional[float] = None,
    max_impacts: int = 10000000,
    max_seconds: float = 3600.0,
) -> Map:
    """Maps the attractors over a plane of two numbers of the scene, "initial.q.1" and the like among
    them.
    """
    raise NotImplementedError  # the decorator does it
