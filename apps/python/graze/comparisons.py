"""graze.compare: motions of a scene and the same with another choice, side by side."""

from __future__ import annotations

from .result import Result, result_kind


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
