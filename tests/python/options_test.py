"""Keywords are the options of the program, with its defaults."""

import inspect

import graze
import pytest

#: Of what is printed and drawn, which a result is asked for afterwards.
ELSEWHERE = {
    "json", "quiet", "wide", "verbose", "plot", "title", "style", "labels", "x_range", "y_range",
    "x_scale", "y_scale", "multipliers", "size", "font",
    "parameters",  # of a scene: Scene.parameters
}
#: Which need --plot in the program.
OF_PICTURES = {"simulate": {"show", "shapes_at"}, "loci": {"show", "at"}}
OF_LOCI = {"locus", "second", "second_from", "second_to", "slices", "regions"}
OF_BRANCHES = {"amplitudes", "switch"}

FUNCTIONS = {
    "check": graze.check, "modes": graze.modes, "simulate": graze.simulate, "orbit": graze.orbit,
    "continue": graze.continue_, "diagram": graze.diagram, "map": graze.map, "fit": graze.fit,
    "compare": graze.compare, "cost": graze.cost, "loci": graze.loci,
}


def as_keyword(option):
    return "from_" if option == "from" else option


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_option_is_a_keyword(name):
    command = "continue" if name == "loci" else name
    without = {"continue": OF_LOCI, "loci": OF_BRANCHES}.get(name, set())
    options = {option["name"] for option in graze._core.options(command)} - ELSEWHERE - without
    options -= OF_PICTURES.get(name, set())
    keywords = set(inspect.signature(FUNCTIONS[name]).parameters) - {"scene", "data", "progress"}
    assert keywords == {as_keyword(option) for option in options}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_defaults_are_those_of_the_program(name):
    parameters = inspect.signature(FUNCTIONS[name]).parameters
    compared = 0
    for option in graze._core.options("continue" if name == "loci" else name):
        parameter, default = parameters.get(as_keyword(option["name"])), option["default"]
        if parameter is None or option["kind"] == "flag" or not default:
            continue
        compared += 1
        written = parameter.default
        assert type(written)(default) == written, option
    assert compared > 0 or name in ("check", "modes")


@pytest.mark.parametrize("name", FUNCTIONS)
def test_docstrings_tell_every_keyword(name):
    told = FUNCTIONS[name].__doc__
    for keyword in inspect.signature(FUNCTIONS[name]).parameters:
        if keyword not in ("scene", "data", "progress"):
            assert f"    {keyword}: " in told, keyword


def test_unknown_keywords_and_missing_ones_are_type_errors(oscillator):
    with pytest.raises(TypeError, match="perids"):
        graze.simulate(oscillator, perids=3)
    with pytest.raises(TypeError, match="parameter"):
        graze.continue_(oscillator, from_=1, to=2)
    with pytest.raises(TypeError):
        graze.simulate()
    with pytest.raises(TypeError, match="data"):
        graze.fit(oscillator)
