"""graze.map: what the motion settles on over two parameters, or two coordinates of its start."""

from __future__ import annotations

from .result import Result, result_kind


@result_kind("map")
class Map(Result):
    """What the motion settles on in every cell, a list of the cells; tables "map" (a cell a row:
    peak_speed in m/s, exponent in 1/s) and "loci"."""

    main_table = "map"
    asked_by = {"loci": 'locus="all"'}
