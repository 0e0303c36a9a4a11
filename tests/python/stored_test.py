"""Results that are read from folders are those that were written into them."""

import graze
import matplotlib.pyplot as pyplot
import numpy as np
import pytest

FILE = "data/scenes/04_impact_oscillator.toml"
OVER = dict(parameter="forcing.frequency", from_=2.6, to=2.9)
PLANE = dict(second="stop.gap", second_from=0.0, second_to=0.2)


def same(one, other):
    assert type(one) is type(other) and one.outcome == other.outcome
    assert one.tables == other.tables
    for name in one.tables:
        a, b = one.table(name), other.table(name)
        assert a.columns == b.columns and a.rows == b.rows
        for column in a.columns:
            if a[column].dtype.kind == "f":
                assert np.array_equal(a[column], b[column], equal_nan=True), (name, column)
            else:
                assert list(a[column]) == list(b[column]), (name, column)


CALLS = {
    "orbit": lambda **to: graze.orbit(FILE, impacts=1, **to),
    "branches": lambda **to: graze.continue_(FILE, **OVER, **to),
    "loci": lambda **to: graze.loci(FILE, **OVER, **PLANE, locus="PD", slices=1, **to),
    "diagram": lambda **to: graze.diagram(FILE, **OVER, points=12, **to),
    "map": lambda **to: graze.map(FILE, **OVER, **PLANE, points=4, second_points=3, **to),
    "compare": lambda **to: graze.compare(FILE, against={"stop.restitution": 0.5}, **to),
    "fit": lambda **to: graze.fit(
        "data/measurements/restitution.toml", "data/measurements/restitution.csv", **to
    ),
}


@pytest.mark.parametrize("kind", CALLS)
def test_a_result_is_read_again(kind, tmp_path):
    result = CALLS[kind](out=tmp_path)
    seen = graze.view(tmp_path)
    same(seen, result)
    assert seen.to_json() == (tmp_path / "result.json").read_text() == result.to_json()
    assert str(seen) == str(result) and seen.scene.parameters == result.scene.parameters
    assert seen.plot().axes
    pyplot.close("all")


def test_a_run_is_read_with_its_document_and_picture(tmp_path):
    result = graze.simulate(FILE, periods=20, forces=10, record="samples", out=tmp_path / "run")
    seen = graze.view(tmp_path / "run")
    assert seen.to_json() == result.to_json() and seen.tables == ["forces"]
    with pytest.raises(KeyError):
        seen.events
    seen.save_picture(tmp_path / "motion.html")
    assert (tmp_path / "motion.html").stat().st_size > 10_000
    graze.simulate(FILE, periods=20, out=tmp_path / "bare")
    with pytest.raises(ValueError, match="save_picture"):
        graze.view(tmp_path / "bare").plot()


def test_a_result_that_was_cut_is_read_without_an_error(tmp_path):
    with pytest.raises(graze.NumericsError):
        graze.simulate(FILE, periods=1000, max_impacts=50, out=tmp_path)
    assert graze.view(tmp_path).outcome == "event_budget"


def test_shares_are_joined_to_the_whole(tmp_path):
    for share in ("1/3", "2/3", "3/3"):
        assert CALLS["diagram"](out=tmp_path / "shares", shard=share) is None
        assert CALLS["map"](out=tmp_path / share[0], shard=share) is None
    same(graze.merge(tmp_path / "shares", out=tmp_path / "diagram"), CALLS["diagram"]())
    joined = graze.merge(*(tmp_path / k for k in "123"), out=tmp_path / "map")
    same(joined, CALLS["map"]())
    same(graze.view(tmp_path / "map"), joined)
    with pytest.raises(graze.OptionError, match="run shard 3/3 again"):
        graze.merge(tmp_path / "1", tmp_path / "2", out=tmp_path / "part")


def test_what_is_no_result_is_refused(tmp_path):
    with pytest.raises(graze.FileError):
        graze.view(tmp_path / "missing")
    with pytest.raises(graze.OptionError, match="no journal"):
        graze.merge(tmp_path, out=tmp_path / "whole")
