"""What the functions of graze return, a class for each kind of result."""

from __future__ import annotations

from typing import Any, Dict, Optional, Sequence

import numpy as np

from .entry import Entry
from .result import Result, result_kind
from .table import Table


@result_kind("simulation")
class Simulation(Result):
    """A motion, a list of its events. Table "events": time in s, speed in m/s, phase in rad, energy_change
    in J, force in N; with record="samples" also "samples": q in kg^1/2 m, gap in m, force in N; with
    section= "section", with forces= "forces", with statistics=True "statistics" (a place a row),
    "stop_statistics", "exceedance" (levels over shares of time), "psd" (unit^2/Hz over Hz) and
    "histograms"."""

    main_table = "events"
    asked_by = {
        "samples": 'record="samples"',
        "section": 'section="impact"',
        "forces": "forces=100",
        "statistics": "statistics=True",
        "stop_statistics": "statistics=True",
        "exceedance": "statistics=True",
        "psd": "statistics=True",
        "histograms": "statistics=True",
    }

    @property
    def events(self) -> Table:
        """Impacts, chatters, sticks, releases, contacts, one a row."""
        return self.table("events")

    @property
    def samples(self) -> Table:
        """The motion at equal times. Raises NoSuchName unless the call had record="samples"."""
        return self.table("samples")

    @property
    def statistics(self) -> Dict[str, Any]:
        """Statistics of the run: "places" (mean, rms, standard_deviation, levels, psd, ..) and "stops"
        (impacts, work_rate in W, ..), with "shares" of time and "frequencies" in Hz. Raises NoSuchName
        unless the call had statistics=True."""
        if "statistics" not in self.document:
            raise self._without("statistics")
        return self.document["statistics"]

    def _list(self) -> Sequence[Any]:
        # A run that was read has left its events in a table of its folder.
        return super()._list() if "events" in self.tables else self._of_document("events")

    def plot(self, axes: Any = None, *, show: Optional[str] = None, at: Optional[str] = None) -> Any:
        """The gap of every stop over time with the impacts, or their speeds; or the section, or the forces.
        `show` chooses: "motion", "section", "returns" (each impact over the one before), "forces" or "psd"."""
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


@result_kind("modes")
class Modes(Result):
    """Natural modes, a list of them: `frequencies` in rad/s, `decay_rates` in 1/s; document["directions"]
    holds effective masses in kg."""

    main_table = ""

    def _list(self) -> Sequence[Entry]:
        return self._of_document("modes")

    @property
    def frequencies(self) -> np.ndarray:
        """Angular frequencies, rad/s."""
        return np.array([mode["frequency"] for mode in self.document["modes"]], dtype=float)

    @property
    def decay_rates(self) -> np.ndarray:
        """Decay rates, 1/s; NaN where there is none."""
        return np.array([mode["decay_rate"] for mode in self.document["modes"]], dtype=float)

    def to_pandas(self, table: str = "") -> Any:
        import pandas

        return pandas.DataFrame(self.document["modes"])

    def _repr_html_(self) -> str:
        from .table import html_rows

        rows = list(zip(range(1, 1 + len(self.frequencies)), self.frequencies, self.decay_rates))
        return html_rows("natural modes", ("mode", "rad/s", "1/s"), rows)


@result_kind("check")
class Check(Result):
    """What a scene simulates; `print` it."""

    main_table = ""


@result_kind("orbits")
class Orbits(Result):
    """Periodic orbits, each with its period, phases (rad), speeds (m/s), multipliers, stable; tables
    "orbits" (an impact a row: phase in rad, speed in m/s), "profiles" (their motions), "stuck",
    "contacts"."""

    main_table = "orbits"

    def _list(self) -> Sequence[Entry]:
        return self._of_document("orbits")


@result_kind("branches")
class Branches(Result):
    """Branches of orbits, each a table of its points; all of them in the table "branches" (value in the
    parameter's unit, phase in rad, speed in m/s), special points in "special"."""

    main_table = "branches"

    def _list(self) -> Sequence[Table]:
        return self._by("branch")


@result_kind("loci")
class Loci(Result):
    """Loci, each a table of its points; all of them in the table "loci", points of codimension two in
    "special" (value, second in the parameters' units), and "regions"."""

    main_table = "loci"
    asked_by = {"regions": "regions=100"}

    def _list(self) -> Sequence[Table]:
        return self._by("locus")


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


@result_kind("map")
class Map(Result):
    """What the motion settles on in every cell, a list of the cells; tables "map" (a cell a row:
    peak_speed in m/s, exponent in 1/s) and "loci"."""

    main_table = "map"
    asked_by = {"loci": 'locus="all"'}


@result_kind("comparison")
class Comparison(Result):
    """Motions side by side: tables "comparison" and "first_impacts" (time in s, speed in m/s)."""

    main_table = "comparison"


@result_kind("comparison_map")
class ComparisonMap(Result):
    """Two motions over a plane of two parameters: table "comparison"."""

    main_table = "comparison"


@result_kind("sensitivity")
class Sensitivity(Result):
    """s1 and s2 of the probes over a parameter: table "sensitivity"."""

    main_table = "sensitivity"


@result_kind("cost")
class Cost(Result):
    """Errors and times: tables "costs" (a flow and setting a row), "costs_of_modes", .."""

    main_table = "costs"


@result_kind("fit")
class Fit(Result):
    """Fitted parameters, a list of them; tables "parameters" and "fit" (a measured value a row, SI
    units)."""

    main_table = "parameters"
