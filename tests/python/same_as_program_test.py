"""What the package returns is what the program prints, to the last digit. GRAZE_LONG=1 runs every
command of tests/results/commands.txt, else those that take no longer than seconds."""

import json
import os
import subprocess

import graze
import numpy as np
import pytest
from program_words import battery, call, is_slow

#: Of those that take longer, one of each kind.
CHOSEN = {
    "branch_gap", "loci_one_mode", "diagram_one_mode", "map_one_mode", "compare_methods",
    "compare_modes", "sensitivity",
}

SCENES = sorted(name for name in os.listdir("data/scenes") if name.endswith(".toml"))


def printed(program, words):
    done = subprocess.run([program, *words, "--json", "--quiet"], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def reached(words):
    """(exit code, document, sentence) as the program would tell them."""
    try:
        return 0, call(words).to_json(), ""
    except graze.NumericsError as error:
        return 3, error.result.to_json(), str(error)
    except (graze.SceneError, graze.OptionError) as error:
        return 2, "", str(error)


def compared(program, words):
    code, document, sentence = printed(program, words)
    found_code, found, found_sentence = reached(words)
    assert found_code == code, (words, sentence, found_sentence)
    assert found == document
    if code == 2:
        said = sentence.strip().removeprefix("graze: ").split(" (see graze")[0]
        assert found_sentence == str(graze.OptionError(said))


@pytest.mark.parametrize("name, words", battery(), ids=[name for name, _ in battery()])
def test_battery(program, name, words):
    if is_slow(words) and name not in CHOSEN:
        pytest.skip("takes long; GRAZE_LONG=1 runs it")
    compared(program, words)


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("command", ["check", "modes"])
def test_every_scene(program, command, scene):
    compared(program, [command, f"data/scenes/{scene}"])


@pytest.mark.parametrize("scene", SCENES)
def test_every_scene_moves(program, scene):
    """Few impacts, so that every scene takes part in every test run."""
    path = f"data/scenes/{scene}"
    time = ["--duration", "0.05"] if not graze.Scene.load(path).is_forced else ["--periods", "5"]
    compared(program, ["simulate", path, *time, "--max-impacts", "300", "--amplitudes"])


@pytest.mark.parametrize("measured", ["restitution", "impacts"])
def test_fits(program, measured):
    compared(program, ["fit", f"data/measurements/{measured}.toml", f"data/measurements/{measured}.csv"])


def without_times(text):
    """Of cost, whose times differ from run to run, what was counted."""
    document = json.loads(text)
    return document["graze"], document["outcome"], sorted(document)


def test_cost(program):
    words = ["cost", "data/scenes/06_bouncing_ball.toml", "--duration", "0.5", "--impacts", "3"]
    code, document, _ = printed(program, words)
    found_code, found, _ = reached(words)
    assert code == found_code and without_times(found) == without_times(document)


def test_tables_are_those_of_the_program(program, tmp_path):
    """The files of --out, cell by cell."""
    words = ["simulate", "data/scenes/05_wagg_one_mode.toml", "--periods", "20", "--record", "samples",
             "--energy"]
    subprocess.run([program, *words, "--out", str(tmp_path), "--quiet"], check=True, capture_output=True)
    result = call(words)
    for name in ("events", "samples"):
        lines = (tmp_path / f"{name}.csv").read_text().splitlines()
        table = result.table(name)
        assert lines[0].split(",") == table.columns
        assert len(lines) - 1 == table.rows > 0
        for column, cells in zip(table.columns, zip(*(line.split(",") for line in lines[1:]))):
            values = table[column]
            if column == "kind":
                assert list(values) == list(cells)
                continue
            for value, cell in zip(values, cells):
                assert value == float(cell) if cell else value != value


def test_arrays_of_a_folder_are_those_of_the_result(program, tmp_path):
    words = ["simulate", "data/scenes/16_strain_gauge.toml", "--periods", "20", "--record", "samples",
             "--energy"]
    wanted = [*words, "--sample-format", "npz", "--out", str(tmp_path)]
    subprocess.run([program, *wanted, "--quiet"], check=True, capture_output=True)
    samples = call(words).samples
    with np.load(tmp_path / "samples.npz", allow_pickle=False) as arrays:
        assert arrays.files == samples.columns
        for name in samples.columns:
            assert arrays[name].dtype == np.float64
            assert np.array_equal(arrays[name], samples[name], equal_nan=True)


def test_out_writes_what_the_program_writes(program, tmp_path):
    words = ["orbit", "data/scenes/04_impact_oscillator.toml", "--impacts", "1"]
    subprocess.run([program, *words, "--out", str(tmp_path / "a"), "--quiet"], check=True, capture_output=True)
    call([*words, "--out", str(tmp_path / "b")])
    names = sorted(os.listdir(tmp_path / "a"))
    assert names == sorted(os.listdir(tmp_path / "b"))
    for name in set(names) - {"record.json"}:  # which tells the arguments
        assert (tmp_path / "a" / name).read_text() == (tmp_path / "b" / name).read_text(), name
