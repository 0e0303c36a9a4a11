import graze
import matplotlib.pyplot as pyplot
import numpy as np
import pytest


@pytest.fixture(scope="module")
def results():
    scene = graze.Scene.load("data/scenes/04_impact_oscillator.toml")
    over = dict(parameter="forcing.frequency", from_=2.6, to=2.9)
    plane = dict(second="stop.gap", second_from=0.0, second_to=0.2)
    hub = "data/scenes/20_yigit_sensitivity.toml"
    damping = dict(parameter="stop.spring.damping.coefficient", from_=0.0, to=1000.0)
    return {
        "simulate": graze.simulate(scene, periods=30, record="samples"),
        "section": graze.simulate(scene, periods=60, section="impact"),
        "forces": graze.simulate(scene, periods=60, forces=20),
        "statistics": graze.simulate(scene, periods=90, statistics=True, amplitudes_from=10.0),
        "orbit": graze.orbit(scene, impacts=1),
        "continue_": graze.continue_(scene, **over),
        "loci": graze.loci(scene, **over, **plane, slices=1, locus=["PD", "GR"]),
        "diagram": graze.diagram(scene, **over, points=20),
        "run_diagram": graze.diagram(hub, **damping, points=3, duration=0.05),
        "map": graze.map(scene, **over, **plane, points=4, second_points=3, periods=200),
        "compare": graze.compare(scene, against={"stop.restitution": 0.5}),
        "compare_map": graze.compare(
            scene, against={"stop.restitution": 0.5}, **over, **plane, points=3, second_points=3
        ),
        "sensitivity": graze.compare(hub, sensitivity=True, **damping, points=3, duration=0.05),
        "fit": graze.fit("data/measurements/restitution.toml", "data/measurements/restitution.csv"),
        "cost": graze.cost("data/scenes/06_bouncing_ball.toml", duration=0.5, impacts=3),
        "modes": graze.modes("data/scenes/24_frame_from_matrices.toml"),
        "check": graze.check(scene),
    }


KINDS = [
    "simulate", "section", "forces", "statistics", "orbit", "continue_", "loci", "diagram",
    "run_diagram", "map", "compare", "compare_map", "sensitivity", "fit", "cost", "modes", "check",
]


@pytest.mark.parametrize("kind", KINDS)
def test_it_is_drawn_with_labels(results, kind):
    figure = results[kind].plot()
    axes = [one for one in figure.axes if one.axison]
    assert axes and all(one.get_xlabel() or one.get_ylabel() or one.get_title() for one in axes)
    assert any(len(one.lines) + len(one.collections) + len(one.patches) > 0 for one in axes)
    figure.canvas.draw()
    pyplot.close(figure)


@pytest.mark.parametrize("kind", KINDS)
def test_it_shows_itself_as_words_and_html(results, kind):
    result = results[kind]
    assert result._repr_html_().startswith(("<table>", "<pre>"))
    assert len(str(result)) > 50 and type(result).__name__ in repr(result)
    assert result.document["outcome"] == result.outcome


@pytest.mark.parametrize("kind", KINDS)
def test_tables_reach_pandas(results, kind):
    result = results[kind]
    for name in result.tables:
        table, frame = result.table(name), result.to_pandas(name)
        assert list(frame.columns) == table.columns and len(frame) == table.rows
        for column in table.columns:
            values = table[column]
            if values.dtype == bool:
                told = frame[column].to_numpy(dtype=float, na_value=np.nan)
                known = np.ma.filled(np.ma.MaskedArray(values, dtype=float), np.nan)
                assert frame[column].dtype == "boolean" and np.array_equal(told, known, equal_nan=True)
            elif values.dtype != object:
                assert not values.flags.writeable
                assert np.array_equal(frame[column].to_numpy(), values, equal_nan=True)
            else:
                assert [str(v) if v == v else "" for v in frame[column]] == list(values)
    with pytest.raises(KeyError):
        result.table("nothing")


def test_what_show_names_is_drawn():
    over = dict(parameter="forcing.frequency", from_=2.6, to=2.9)
    plane = dict(second="stop.gap", second_from=0.0, second_to=0.2, points=4, second_points=3)
    scene = "data/scenes/04_impact_oscillator.toml"
    for result, words in [
        (graze.continue_(scene, **over, show="amplitude"), "amplitude"),
        (graze.diagram(scene, **over, points=5, show="peak-velocity"), "velocity"),
    ]:
        (axes,) = result.plot().axes
        assert words in axes.get_ylabel() and len(axes.lines) > 0
    for show in ("speed", "stuck", "impacts", "rms"):
        figure = graze.map(scene, **over, **plane, periods=100, show=show).plot()
        assert len(figure.axes) == 2 and figure.axes[1].get_ylabel()
    figure = graze.compare(scene, against="stop.restitution=0.5", **over, **plane, show="velocity").plot()
    assert len(figure.axes) == 2
    pyplot.close("all")


def test_columns_of_samples_share_one_memory(results):
    samples = results["simulate"].samples
    first, second = samples["time"], samples["q1"]
    assert first.strides == second.strides == (8 * len(samples.columns),)
    assert second.__array_interface__["data"][0] - first.__array_interface__["data"][0] == 8
    assert first.base is not None


def test_arrays_outlive_their_result():
    scene = graze.Scene.load("data/scenes/04_impact_oscillator.toml")
    result = graze.simulate(scene, periods=50, record="samples")
    kept, copy = result.samples["q1"], result.samples["q1"].copy()
    speed, speeds = result.events["speed"], result.events["speed"].copy()
    del result
    for _ in range(20):
        graze.simulate(scene, periods=50, record="samples")
    assert np.array_equal(kept, copy) and np.array_equal(speed, speeds, equal_nan=True)


def test_pages_and_pictures_are_the_programs(results, tmp_path):
    results["orbit"].save_picture(tmp_path / "orbit.html")
    assert (tmp_path / "orbit.html").stat().st_size > 10_000
    with pytest.raises(ValueError, match="out="):
        results["simulate"].save_picture(tmp_path / "motion.svg")
    with pytest.raises(graze.OptionError, match="ends in .svg"):
        results["orbit"].save_picture(tmp_path / "orbit.bmp")


def test_parameters_stand_at_axes_in_units_that_read_well():
    over = dict(parameter="forcing.frequency", from_=40, to=80)
    plane = dict(second="stop.gap", second_from=0.5e-3, second_to=2e-3)
    loci = graze.loci("data/scenes/05_wagg_one_mode.toml", **over, **plane, locus="PD", slices=2)
    (axes,) = loci.plot().axes
    assert axes.get_xlabel() == "forcing frequency Ω (rad/s)" and axes.get_ylabel() == "gap (mm)"
    assert np.allclose(axes.get_ylim(), (0.5, 2.0)) and axes.get_xlim() == (40.0, 80.0)
    pyplot.close("all")


def test_every_colour_of_a_map_is_named():
    over = dict(parameter="forcing.frequency", from_=2.4, to=3.0, points=24)
    plane = dict(second="stop.gap", second_from=0.0, second_to=0.3, second_points=16)
    figure = graze.map("data/scenes/04_impact_oscillator.toml", **over, **plane).plot()
    mesh = figure.axes[0].collections[0]
    drawn = {tuple(mesh.to_rgba(value)) for value in mesh.get_array().compressed()}
    named = {patch.get_facecolor() for patch in figure.legends[0].get_patches()}
    assert len(drawn) > 9 and drawn == named
    pyplot.close("all")


def test_a_run_has_its_statistics_as_a_dict_and_as_tables(results):
    motion = results["statistics"]
    told = motion.statistics
    place, stop = told["places"][0], told["stops"][0]
    assert motion.table("statistics")["rms"][0] == place["rms"]
    assert motion.table("stop_statistics")["work_rate"][0] == stop["work_rate"]
    assert np.array_equal(motion.table("exceedance")["stop_1"], place["levels"])
    spectrum = motion.table("psd")
    assert np.array_equal(spectrum["stop_1"], place["psd"])
    # Parseval, over segments that do not cover the time evenly.
    power = spectrum["stop_1"].sum() * spectrum["frequency"][1]
    assert power == pytest.approx(place["standard_deviation"] ** 2, rel=0.1)
    impacts = np.isin(motion.events["kind"], ["impact"]) & (motion.events["time"] >= 10.0)
    assert impacts.sum() == stop["impacts"] == sum(stop["speeds"]["counts"])
    assert motion.events["speed"][impacts].mean() == pytest.approx(stop["mean_speed"], rel=1e-12)
    assert motion.plot(show="psd").axes[0].get_yscale() == "log"
    with pytest.raises(graze.NoSuchName, match="statistics=True"):
        results["simulate"].statistics
