"""Measurements that are in no file, as the text of a table."""

from __future__ import annotations

import csv
import io
import os
from typing import Any, Dict, List, Mapping, Sequence, Union

import numpy as np

#: A file (CSV), a DataFrame, or columns by their names: a dict of arrays, a Table, a structured array.
MeasuredLike = Union[str, "os.PathLike[str]", Mapping[str, Sequence[Any]], Any]


def table_text(data: Any) -> str:
    """Comma-separated, a row of names first, numbers with all their digits."""
    columns = _columns_of(data)
    lengths = {name: len(cells) for name, cells in columns.items()}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{name} has {length}" for name, length in lengths.items())
        raise ValueError(f"data: columns are equally long, but {told} values")
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(zip(*columns.values()))
    return text.getvalue()


def _columns_of(data: Any) -> Dict[str, List[Any]]:
    if hasattr(data, "reset_index") and hasattr(data, "columns"):  # a DataFrame
        frame = data.reset_index() if data.index.name is not None else data
        return {str(name): _cells(frame[name].to_numpy(dtype=object)) for name in frame.columns}
    if isinstance(data, Mapping):
        return {str(name): _cells(data[name]) for name in data}
    names = getattr(getattr(data, "dtype", None), "names", None)
    if names:
        return {name: _cells(data[name]) for name in names}
    raise TypeError(
        "data: a file, a DataFrame or a dict of arrays such as {'time': t, 'force1': f} is wanted, "
        f"not {type(data).__name__}"
    )


def _cells(values: Any) -> List[Any]:
    """Words and numbers; nothing where there is none."""
    listed = np.ma.MaskedArray(values).tolist() if hasattr(values, "tolist") else list(values)
    return ["" if value is None or value != value else _cell(value) for value in listed]


def _cell(value: Any) -> Any:
    if isinstance(value, (bool, np.bool_)):
        return int(value)
    return repr(float(value)) if isinstance(value, (float, np.floating)) else value
