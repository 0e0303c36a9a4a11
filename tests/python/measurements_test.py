"""Measurements that are in no file fit as those of the file do."""

import csv

import graze
import numpy as np
import pandas
import pytest

FOLDER = "data/measurements/"
STIFFNESS = dict(parameter={"stop.spring.stiffness": (1e6, 1e9)})


def columns_of(file):
    with open(file) as text:
        rows = list(csv.reader(line for line in text if line.strip() and not line.startswith("#")))
    return {name: np.array([float(row[i]) for row in rows[1:]]) for i, name in enumerate(rows[0])}


@pytest.mark.parametrize("name, options", [("restitution", {}), ("contact", STIFFNESS)])
def test_frames_and_arrays_fit_as_their_file(name, options):
    scene, file = f"{FOLDER}{name}.toml", f"{FOLDER}{name}.csv"
    columns = columns_of(file)
    records = np.zeros(len(next(iter(columns.values()))), dtype=[(column, float) for column in columns])
    for column, values in columns.items():
        records[column] = values
    expected = graze.fit(scene, file, **options).table("parameters")
    for data in (columns, pandas.DataFrame(columns), records, {k: list(v) for k, v in columns.items()}):
        found = graze.fit(scene, data, **options).table("parameters")
        for column in ("value", "uncertainty"):
            assert np.array_equal(found[column], expected[column], equal_nan=True)


def test_a_frame_may_have_the_time_for_its_index():
    columns = columns_of(FOLDER + "contact.csv")
    frame = pandas.DataFrame(columns).set_index("time")
    found = graze.fit(FOLDER + "contact.toml", frame, **STIFFNESS)
    assert found[0].value == graze.fit(FOLDER + "contact.toml", columns, **STIFFNESS)[0].value


def test_events_of_a_run_are_measurements():
    scene = graze.Scene.load("data/scenes/04_impact_oscillator.toml")
    events = graze.simulate(scene, periods=6).events
    start = scene.changed({"stop.restitution": 0.7})
    found = graze.fit(start, events, parameter={"stop.restitution": (0.5, 1.0)})
    assert found[0].value == pytest.approx(scene["stop.restitution"], abs=1e-6)


def test_what_is_wrong_with_measurements_is_told(oscillator):
    with pytest.raises(graze.SceneError, match=r"measurements:3:\d+: "):
        graze.fit(oscillator, {"time": [0.1, None, 0.3], "gap1": [1.0, 2.0, 3.0]})
    with pytest.raises(ValueError, match="time has 2, gap1 has 1 values"):
        graze.fit(oscillator, {"time": [0.1, 0.2], "gap1": [1.0]})
    with pytest.raises(TypeError, match="a DataFrame or a dict of arrays"):
        graze.fit(oscillator, [0.1, 0.2])
