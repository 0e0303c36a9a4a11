"""Writes graze/functions.pyi, the functions with all their keywords for editors and for mypy, from what
the compiled part says of the program's options: python3 write_stub.py BUILD/python"""

import inspect
import pathlib
import re
import sys
from unittest import mock

try:
    import numpy  # noqa: F401
except ImportError:  # it takes no part in what is written, and builds need not have it
    sys.modules["numpy"] = mock.MagicMock()


def stub(name, signature):
    """`def simulate(..) -> Simulation: ...`, a keyword a line."""
    returns = re.sub(r"<class '(.*)'>", r"\1", str(signature.return_annotation))
    lines = [f"def {name}("]
    for parameter in signature.parameters.values():
        if parameter.kind is parameter.KEYWORD_ONLY and "    *," not in lines:
            lines.append("    *,")
        default = "" if parameter.default is parameter.empty else f" = {parameter.default!r}"
        lines.append(f"    {parameter.name}: {parameter.annotation}{default},")
    return "\n".join([*lines, ") -> " + re.sub(r"\b(graze|typing)\.(\w+\.)*", "", returns) + ": ...\n"])


sys.path.insert(0, sys.argv[1])
from graze import functions  # noqa: E402

made = vars(functions).items()
head = ["import os", "from typing import Any, Mapping, Optional, Sequence, Tuple, Union", ""]
head += [f"from .{one.__module__[6:]} import {name}" for name, one in made if inspect.isclass(one)]
head += ["from .measurements import MeasuredLike", "from .words import Progress, SceneLike, Settings", ""]
stubs = [stub(name, one.__signature__) for name, one in made if hasattr(one, "__signature__")]
pathlib.Path(sys.argv[1], "graze/functions.pyi").write_text("\n".join(head + stubs))
