"""graze.simulate: the motion from the scene's initial state."""

from __future__ import annotations

from typing import Any, Optional

from .command import command, result_kind
from .result import Result
from .table import Table
from .words import PathLike, Progress, SceneLike, Settings


@result_kind("simulation")
class Simulation(Result):
    """A motion. Table "events": time in s, speed in m/s, phase in rad, energy_change in J, force in N;
    with record="samples" also "samples": q in kg^1/2 m, gap in m, force in N; "section", "forces"."""

    main_table = "events"

    @property
    def events(self) -> Table:
        """Impacts, chatters, sticks, releases, contacts, one a row."""
        return self.table("events")

    @property
    def samples(self) -> Table:
        """The motion at equal times; needs record="samples"."""
        return self.table("samples")

    def plot(self, axes: Any = None) -> Any:
        """The gap of every stop over time with the impacts; or the section, or the forces."""
        from .motion_plot import plot_motion

        return super().plot(axes) if "forces" in self.tables else plot_motion(self, axes)


@command("simulate")
def simulate(
    scene: SceneLike,
    *,
    set: Settings = None,
    out: Optional[PathLike] = None,
    threads: int = 0,
    progress: Progress = None,
    duration: Optional[float] = None,
    periods: Optional[int] = None,
    record: str = "events",
    sample_rate: Optional[float] = None,
    sample_format: str = "csv",
    energy: bool = False,
    amplitudes: bool = False,
    amplitudes_from: Optional[float] = None,
    forces: Optional[int] = None,
    section: Optional[str] = None,
    transient: Optional[int] = None,
    resume: Optional[PathLike] = None,
    closure_speed: Optional[float] = None,
    max_impacts: int = 10000000,
    max_seconds: float = 3600.0,
) -> Simulation:
    """Follows the motion from the scene's initial state, every impact certified.

    Raises NumericsError with what was reached where a budget ended it.
    """
    raise NotImplementedError  # the decorator does it
