"""The stubs are what stubgen makes of the compiled part, mypy finds no fault with the package, and knows
the keywords of its functions."""

import pathlib
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "apps/python/graze"


@pytest.mark.skipif(shutil.which("stubgen") is None, reason="mypy is not installed")
def test_the_stub_is_up_to_date(program, tmp_path):
    environment = {"PYTHONPATH": str(pathlib.Path(program).parent / "python"), "PATH": "/usr/bin:/bin"}
    subprocess.run(
        ["stubgen", "-m", "graze._core", "-o", str(tmp_path), "-q"], check=True, env=environment,
        cwd=tmp_path,
    )
    assert (tmp_path / "graze/_core.pyi").read_text() == (PACKAGE / "_core.pyi").read_text()


@pytest.mark.skipif(shutil.which("mypy") is None, reason="mypy is not installed")
def test_types_fit(tmp_path):
    done = subprocess.run(
        ["/usr/bin/mypy", "--ignore-missing-imports", "--cache-dir", str(tmp_path), "--python-executable",
         sys.executable, str(PACKAGE)], capture_output=True, text=True,
    )
    assert done.returncode == 0, done.stdout


USE = """import graze

def run(at: str) -> graze.Branches:
    graze.simulate(at, periods=3, record="samples").samples
    graze.fit(at, {"speed": [1.0]}, parameter={"stop.restitution": (0.1, 0.9)}, sigma=0.1)
    return graze.continue_(at, parameter="stop.gap", from_=1, to=2.0, impacts="any", start=["random"])

graze.simulate("scene.toml", perids=3)
graze.simulate("scene.toml", periods="many")
graze.loci("scene.toml", parameter="stop.gap", from_=1.0, to=2.0)
graze.map("scene.toml").events
"""


@pytest.mark.skipif(shutil.which("mypy") is None, reason="mypy is not installed")
def test_keywords_are_known_to_mypy(program, tmp_path):
    (tmp_path / "use.py").write_text(USE)
    done = subprocess.run(
        ["/usr/bin/mypy", "--ignore-missing-imports", "--cache-dir", str(tmp_path), "--python-executable",
         sys.executable, str(tmp_path / "use.py")], capture_output=True, text=True,
        env={"MYPYPATH": str(pathlib.Path(program).parent / "python"), "PATH": "/usr/bin:/bin"},
    )
    found = [line.split(": error: ") for line in done.stdout.splitlines() if ": error: " in line]
    lines = {int(place.rsplit(":", 1)[1]) for place, _ in found}
    assert lines == {8, 9, 10, 11}, done.stdout
