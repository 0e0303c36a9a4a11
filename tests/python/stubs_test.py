"""The stubs are what stubgen makes of the compiled part, and mypy finds no fault with the package."""

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
