"""Pictures by matplotlib show what those of the program show."""

import graze
import matplotlib.pyplot as pyplot
import numpy as np
import pytest

OSCILLATOR = "data/scenes/04_impact_oscillator.toml"
PURE = "data/scenes/21_elastic_stop_pure_numbers.toml"
OVER = dict(parameter="forcing.frequency", from_=2.4, to=3.2)
PLANE = dict(second="stop.gap", second_from=0.0, second_to=0.2, points=4, second_points=3, periods=200)


@pytest.fixture(autouse=True)
def _closed():
    yield
    pyplot.close("all")


def test_a_diagram_has_its_exponents_and_the_range_of_the_sweep():
    diagram = graze.diagram(OSCILLATOR, **OVER, points=9, exponents=200)
    speeds, exponents = diagram.plot().axes
    assert speeds.get_ylabel() == "impact speed (m/s)"
    assert exponents.get_ylabel() == "Lyapunov exponents (1/s)"
    for axes in (speeds, exponents):
        assert axes.get_xlim() == (2.4, 3.2)
    assert speeds.get_xlabel() == "" and exponents.get_xlabel() == "forcing frequency Ω (rad/s)"
    largest = next(line for line in exponents.lines if line.get_label() == "largest exponent")
    table = diagram.table("exponents")
    cut = next(line for line in exponents.lines if line.get_label() == "exponents, cut off")
    drawn = dict(zip(largest.get_xdata(), largest.get_ydata()))
    lowest = exponents.get_ylim()[0]
    for value, exponent in zip(table["value"], table["exponent_1"]):
        assert drawn.get(value) == (exponent if value in drawn else None)
        assert value in drawn or (value in cut.get_xdata() and exponent < 0.9 * lowest)
    assert len(drawn) > len(table["value"]) / 2
    periodic = next(line for line in speeds.lines if line.get_label() == "sweep: periodic")
    sweep = diagram.table("sweep")
    known = np.isfinite(np.asarray(sweep["period"], dtype=float)) & np.isfinite(sweep["speed"])
    assert sorted(periodic.get_ydata()) == sorted(sweep["speed"][known])


def test_a_scene_without_units_has_none_at_its_axes():
    over = dict(parameter="forcing.frequency", from_=0.8, to=0.96)
    plane = dict(second="stop.gap", second_from=1.0, second_to=1.3, points=3, second_points=2, periods=50)
    pictures = [
        graze.diagram(PURE, **over, points=5, exponents=20, branches="none"),
        graze.diagram(PURE, **over, points=3, section="stroboscopic", branches="none"),
        graze.continue_(PURE, **over, max_seconds=20),
        graze.simulate(PURE, periods=5),
        graze.simulate(PURE, periods=5, record="samples"),
        graze.simulate(PURE, periods=50, section="impact"),
        graze.map(PURE, **over, **plane, show="speed"),
        graze.map(PURE, **over, **plane, show="rms"),
    ]
    for result in pictures:
        for axes in result.plot().axes:
            assert "(m" not in axes.get_xlabel() + axes.get_ylabel(), axes.get_ylabel()
            assert "(s)" not in axes.get_xlabel() and "rad" not in axes.get_xlabel()


def test_what_is_shown_is_chosen_after_the_run():
    branches = graze.continue_(OSCILLATOR, **OVER, amplitudes=True)
    assert branches.plot().axes[0].get_ylabel() == "impact speed (m/s)"
    (axes,) = branches.plot(show="rms", at="stop.1").axes
    again = graze.continue_(OSCILLATOR, **OVER, show="rms", at="stop.1").plot().axes[0]
    assert axes.get_ylabel() == again.get_ylabel() != "impact speed (m/s)"
    for one, other in zip(axes.lines, again.lines):
        assert np.array_equal(one.get_ydata(), other.get_ydata(), equal_nan=True)
    diagram = graze.diagram(OSCILLATOR, **OVER, points=5, amplitudes=True)
    assert "largest velocity" in diagram.plot(show="peak-velocity").axes[0].get_ylabel()
    cells = graze.map(OSCILLATOR, **OVER, **PLANE, exponents=20, amplitudes=True)
    labels = [cells.plot(show=show).axes[1].get_ylabel() for show in ("speed", "stuck", "exponent", "rms")]
    assert len(set(labels)) == 4 and labels[0].endswith("(m/s)")
    assert len(cells.plot().axes) == 1
    motion = graze.simulate(OSCILLATOR, periods=60, section="impact", forces=20)
    assert "force" in motion.plot().axes[0].get_ylabel()
    assert motion.plot(show="section").axes[0].get_xlabel() == "forcing phase at the impact (rad)"
    assert motion.plot(show="motion").axes[0].get_xlabel() == "time (s)"
    assert len(motion.plot(show="returns").axes) == 2


def test_pictures_of_the_program_are_chosen_too(tmp_path):
    cells = graze.map(OSCILLATOR, **OVER, **PLANE)
    cells.save_picture(tmp_path / "speed.svg", show="speed")
    assert "speed of the fastest impact" in (tmp_path / "speed.gp").read_text()
    with pytest.raises(graze.OptionError, match="run it again with amplitudes"):
        cells.plot(show="rms")


def test_what_a_result_does_not_show_is_told():
    for result, show, words in [
        (graze.orbit(OSCILLATOR), "speed", "nothing to choose"),
        (graze.continue_(OSCILLATOR, **OVER), "rms", "did not measure its motions"),
        (graze.map(OSCILLATOR, **OVER, **PLANE), "colour", "give one of attractor, impacts"),
        (graze.simulate(OSCILLATOR, periods=5), "returns", "kept no impacts"),
        (graze.simulate(OSCILLATOR, periods=5), "forces", "kept no forces"),
    ]:
        with pytest.raises(graze.OptionError, match=words):
            result.plot(show=show)
    with pytest.raises(graze.OptionError, match="at: it needs show"):
        graze.continue_(OSCILLATOR, **OVER).plot(at="stop.1")


def test_panels_go_into_axes_that_are_given():
    diagram = graze.diagram(OSCILLATOR, **OVER, points=5, exponents=50)
    figure, axes = pyplot.subplots(2)
    assert diagram.plot(axes) is figure and all(one.lines for one in axes)
    with pytest.raises(ValueError, match="2 panels"):
        diagram.plot(axes[0])
