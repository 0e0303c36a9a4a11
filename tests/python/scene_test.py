import pathlib
import tomllib

import graze
import numpy as np
import pytest

FILE = "data/scenes/05_wagg_one_mode.toml"


def test_a_file_its_text_and_its_dict_are_one_scene():
    with open(FILE, "rb") as file:
        tables = tomllib.load(file)
    with open(FILE) as file:
        text = file.read()
    loaded = graze.Scene.load(FILE)
    assert graze.Scene.parse(text).to_toml() == loaded.to_toml()
    assert graze.Scene.from_dict(tables).to_toml() == loaded.to_toml()
    assert graze.simulate(tables, periods=3).events.rows == graze.simulate(FILE, periods=3).events.rows


@pytest.mark.parametrize("file", sorted((pathlib.Path(__file__).resolve().parents[2] / "data/scenes").glob("*.toml")), ids=lambda file: file.stem)
def test_every_scene_may_be_a_dict(file):
    with open(file, "rb") as stream:
        tables = tomllib.load(stream)
    assert graze.Scene.from_dict(tables, name=str(file)).to_toml() == graze.Scene.load(file).to_toml()


def test_parameters_are_read_and_changed_by_their_names():
    scene = graze.Scene.load(FILE)
    other = scene.changed({"stop.gap": 2.5e-3, "beam.modes": 2})
    assert other["stop.gap"] == 2.5e-3 and other.modes == 2
    assert scene["stop.gap"] != 2.5e-3 and scene.modes == 1
    assert scene.unit("stop.gap") == "m" and "forcing.frequency" in scene.parameters
    assert graze.Scene.load(FILE, set="stop.gap=2.5e-3")["stop.gap"] == 2.5e-3
    assert graze.Scene.load(FILE, set=["stop.gap=2.5e-3"])["stop.gap"] == 2.5e-3
    assert scene.changed({"stop.gap": np.float64(2.5e-3)})["stop.gap"] == 2.5e-3
    with pytest.raises(KeyError):
        scene["stop.width"]


def test_an_error_says_where(tmp_path):
    file = tmp_path / "bad.toml"
    with open(FILE) as scene:
        lines = scene.read().split("\n")
    line = next(i for i, text in enumerate(lines) if text.startswith("length"))
    lines[line] = "length = -1"
    file.write_text("\n".join(lines))
    with pytest.raises(graze.SceneError) as caught:
        graze.Scene.load(file)
    assert caught.value.file == str(file)
    assert (caught.value.line, caught.value.column) == (line + 1, 1)  # of the key
    assert str(caught.value).startswith(f"{file}:{line + 1}:1: beam.length: ")
    assert isinstance(caught.value, (graze.Error, ValueError))
    with pytest.raises(graze.SceneError) as caught:
        graze.Scene.parse("[beam\n", "typed.toml")
    assert caught.value.file == "typed.toml" and caught.value.line in (1, 2)
    with pytest.raises(graze.FileError):
        graze.Scene.load(tmp_path / "none.toml")
    with pytest.raises(graze.SceneError):
        graze.Scene.load(FILE, set={"stop.gpa": 1.0})


def test_it_shows_itself():
    scene = graze.Scene.load(FILE, set={"title": "<b>&"})
    assert "&lt;b&gt;&amp;" in scene._repr_html_() and "<b>" not in scene._repr_html_()
    assert FILE in repr(scene)
