"""Results as lists of what was found, and what is true or false in their tables."""

import graze
import numpy as np
import pandas
import pytest

ONE_MODE = "data/scenes/05_wagg_one_mode.toml"
OVER = dict(parameter="forcing.frequency", from_=15, to=120)


@pytest.fixture(scope="module")
def branches():
    return graze.continue_(ONE_MODE, **OVER)


@pytest.fixture(scope="module")
def orbits():
    return graze.orbit(ONE_MODE, set={"forcing.frequency": 40})


def test_booleans_choose_rows(branches):
    frame = branches.to_pandas()
    for name in ("stable", "admissible", "stuck"):
        assert frame[name].dtype == "boolean" and branches.table("branches")[name].dtype == bool
    stable = frame[frame.stable]
    # One impact a period is stable between its doublings at 20.31 and 59.54 rad/s (docs/python.md).
    assert 0 < len(stable) < len(frame)
    single = stable[stable["impacts"] == 1]["value"]
    assert single.between(20.3101, 59.5374).all()
    assert len(frame[~frame.stable]) + len(stable) == frame.stable.count()


def test_what_is_not_known_is_masked_and_na():
    from graze.table import Table

    table = Table("t", [("x", np.array([1.0, 2.0, 3.0])), ("stable", np.array([1, 0, -1], dtype=np.int8))])
    assert list(table["stable"].mask) == [False, False, True]
    assert list(table["x"][table["stable"]]) == [1.0]
    frame = table.to_pandas()
    assert frame.stable.isna().tolist() == [False, False, True] and frame[frame.stable].x.tolist() == [1.0]
    assert table.row(2)["stable"] is None and table.row(0)["stable"] is True


def test_an_orbit_has_its_numbers_and_complex_multipliers(orbits):
    assert len(orbits) == 1 and orbits
    (orbit,) = orbits
    assert orbit["period"] == orbit.period == 1 and orbit.stable is True
    assert orbit.multipliers.dtype == complex and orbit.multipliers.shape == (2,)
    # Their product is that of the contraction by the flow over a period and by the impact (theory.md):
    # exp(-2 delta T) r^2.
    check = graze.modes(ONE_MODE)
    scene = graze.Scene.load(ONE_MODE)
    period = 2.0 * np.pi / 40.0
    expected = np.exp(-2.0 * check.decay_rates[0] * period) * scene["stop.restitution"] ** 2
    assert np.prod(orbit.multipliers).real == pytest.approx(expected, rel=1e-9)
    assert abs(np.prod(orbit.multipliers).imag) < 1e-12
    assert isinstance(orbit.speeds, np.ndarray) and orbit.speeds[0] == orbits.table("orbits")["speed"][0]
    with pytest.raises(AttributeError, match="speeds"):
        orbit.speed_s
    with pytest.raises(KeyError, match="did you mean 'speeds'"):
        orbit["speedz"]


def test_branches_are_a_list_of_tables(branches):
    assert len(branches) == len(branches.document["branches"])
    assert sum(branch.rows for branch in branches) == branches.table("branches").rows
    first = branches[0]
    assert np.array_equal(first["value"], [p["value"] for p in branches.document["branches"][0]["points"]])
    assert isinstance(first.to_pandas(), pandas.DataFrame)
    assert branches[-1].rows == list(branches)[-1].rows
    with pytest.raises(IndexError):
        branches[len(branches)]


def test_every_result_is_a_list():
    scene = graze.Scene.load("data/scenes/04_impact_oscillator.toml")
    over = dict(parameter="forcing.frequency", from_=2.6, to=2.9)
    plane = dict(second="stop.gap", second_from=0.0, second_to=0.2)
    motion = graze.simulate(scene, periods=10)
    assert len(motion) == motion.events.rows and motion[0].kind == motion.events["kind"][0]
    assert [event.time for event in motion[1:3]] == list(motion.events["time"][1:3])
    diagram = graze.diagram(scene, **over, points=7, branches="none", exponents=200)
    assert [row.value for row in diagram] == pytest.approx(np.linspace(2.6, 2.9, 7))
    assert all(row.exponents.shape == (2,) for row in diagram)
    cells = graze.map(scene, **over, **plane, points=4, second_points=3, periods=100)
    assert len(cells) == 12 and cells[0].x == 2.6 and cells[-1].y == 0.2
    assert len(graze.modes(scene)) == 1 and graze.modes(scene)[0].frequency == 1.0
    assert len(graze.check(scene)) == 0 and graze.check(scene)
    fitted = graze.fit("data/measurements/restitution.toml", "data/measurements/restitution.csv")
    assert [one.parameter for one in fitted] == [f"stop.restitution.{i}" for i in (1, 2, 3)]


def test_names_that_are_not_there_tell_what_is():
    motion = graze.simulate("data/scenes/04_impact_oscillator.toml", periods=5)
    with pytest.raises(KeyError) as raised:
        motion.samples
    assert str(raised.value) == "this result has no table 'samples'; call the function with record=\"samples\""
    assert isinstance(raised.value, graze.NoSuchName) and isinstance(raised.value, graze.Error)
    with pytest.raises(KeyError, match="did you mean 'speed'"):
        motion.events["sped"]
    with pytest.raises(KeyError, match="there is events"):
        motion.table("nothing")
    with pytest.raises(KeyError, match="did you mean 'scenes/05_wagg_one_mode.toml'"):
        graze.example("scenes/05_wag_one_mode.toml")
