"""Where the program, the package and the scenes are: set by ctest, or guessed from the build folder."""

import os
import pathlib
import sys
import warnings

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("GRAZE_BUILD", ROOT / "build"))
sys.path.insert(0, str(BUILD / "python"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

# Scenes are named as users of the repository name them, wherever the tests are called.
os.chdir(ROOT)

import matplotlib  # noqa: E402

matplotlib.use("Agg")


@pytest.fixture(autouse=True)
def _quiet():
    import graze

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", graze.GrazeWarning)
        yield


@pytest.fixture(scope="session")
def program():
    return str(BUILD / "graze")


@pytest.fixture
def oscillator():
    import graze

    return graze.Scene.load("data/scenes/04_impact_oscillator.toml")
