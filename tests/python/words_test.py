"""What the package says: of keywords, of its functions, of how far work is."""

import re
import subprocess
import sys

import graze
import pytest
from options_test import FUNCTIONS


@pytest.mark.parametrize("name", FUNCTIONS)
def test_docstrings_are_in_words_of_python(name):
    told = FUNCTIONS[name].__doc__
    assert "--" not in told and "separated by commas" not in told
    assert not re.search(r"\bgraze (check|merge|view|continue)\b", told)


def test_wrong_keywords_name_the_nearest(oscillator):
    for call, wrong, near in [
        (graze.simulate, "perids", "periods"),
        (graze.continue_, "frm", "from_"),
        (graze.map, "second_pionts", "second_points"),
        (graze.fit, "parameters", "parameter"),
    ]:
        with pytest.raises(TypeError, match=f"no keyword '{wrong}'; did you mean '{near}'"):
            call(oscillator, **{wrong: 3})
    with pytest.raises(TypeError, match=r"graze\.simulate has no keyword 'qqq'$"):
        graze.simulate(oscillator, qqq=3)


def test_a_pipe_gets_no_escape_codes():
    program = (
        "import graze; print(graze.orbit(graze.example('scenes/04_impact_oscillator.toml'), progress=True));"
        "print(repr(graze.simulate(graze.example('scenes/04_impact_oscillator.toml'), periods=2000,"
        " progress=True)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True,
        env={"PYTHONPATH": ":".join(sys.path)},
    )
    assert "\x1b" not in done.stdout + done.stderr and "\r" not in done.stdout + done.stderr
    assert done.stderr.splitlines()[-1] == "simulate 100 %"
