"""graze.loci: loci of special points over two parameters."""

from __future__ import annotations

from typing import Sequence

from .result import Result, result_kind
from .table import Table


@result_kind("loci")
class Loci(Result):
    """Loci, each a table of its points; all of them in the table "loci", points of codimension two in
    "special" (value, second in the parameters' units), and "regions"."""

    main_table = "loci"
    asked_by = {"regions": "regions=100"}

    def _list(self) -> Sequence[Table]:
        return self._by("locus")
