"""graze.simulate: the motion from the scene's initial state."""

from __future__ import annotations

from typing import Any, Optional, Sequence

from .result import Result, result_kind
from .table import Table


@result_kind("simulation")
class Simulation(Result):
    """A motion, a list of its events. Table "events": time in s, speed in m/s, phase in rad, energy_change
    in J, force in N; with record="samples" also "samples": q in kg^1/2 m, gap in m, force in N; with
    section= "section", with forces= "forces"."""

    main_table = "events"
    asked_by = {
        "samples": 'record="samples"',
        "section": 'section="impact"',
        "forces": "forces=100",
    }

    @property
    def events(self) -> Table:
        """Impacts, chatters, sticks, releases, contacts, one a row."""
        return self.table("events")

    @property
    def samples(self) -> Table:
        """The motion at equal times. Raises NoSuchName unless the call had record="samples"."""
        return self.table("samples")

    def _list(self) -> Sequence[Any]:
        # A run that was read has left its events in a table of its folder.
        return super()._list() if "events" in self.tables else self._of_document("events")

    def plot(self, axes: Any = None, *, show: Optional[str] = None, at: Optional[str] = None) -> Any:
        """The gap of every stop over time with the impacts, or their speeds; or the section, or the forces.
        `show` chooses: "motion", "section", "returns" (each impact over the one before) or "forces"."""
        from .motion_plot import plot_motion

        if show is None and at is None:
            show = next((kind for kind in ("forces", "section") if kind in self.tables), "motion")
        if show == "motion" and at is None:
            return plot_motion(self, axes)
        if show == "section" and at is None:
            if "section" not in self.tables:
                raise self._without("section")
            show = None
        return super().plot(axes, show=show, at=at)
