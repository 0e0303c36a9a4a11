import graze
import numpy as np
import pytest


def circle(u, p):
    return u**2 + p**2 - 1.0


def test_a_circle_closes_and_folds_twice():
    branch = graze.continuation(circle, 0.9, 0.1, from_=-2, to=2)
    assert branch.is_closed
    assert np.allclose(branch.u[:, 0] ** 2 + branch.p**2, 1.0, atol=1e-10)
    folds = sorted(point.p for point in branch.special if point.label == "LP")
    assert folds == pytest.approx([-1.0, 1.0], abs=1e-9)
    assert list(branch.to_pandas().columns) == ["p", "u1"]
    assert "LP" in branch._repr_html_()
    assert branch.plot().axes[0].get_xlabel() == "p"


def test_a_cusp_with_its_jacobian():
    """p = u^3 - 3 u: folds at u = -1, p = 2 and u = 1, p = -2."""
    calls = []

    def slope(u, p):
        calls.append(p)
        return [[3.0 * (u[0] ** 2 - 1.0)]]

    branch = graze.continuation(
        lambda u, p: u**3 - 3.0 * u - p, [2.5], 4.0, from_=-5, to=5, jacobian=slope,
        by_parameter=lambda u, p: [-1.0],
    )
    assert calls and branch.ends == ("parameter_limit", "parameter_limit")
    found = sorted((point.p, point.u[0]) for point in branch.special)
    assert np.allclose(found, [(-2.0, 1.0), (2.0, -1.0)], atol=1e-9)


def test_large_numbers_leave_large_residuals():
    """u^3 - 3e8 u = 1e12 p: folds at u = -1e4, p = 2 and u = 1e4, p = -2."""
    branch = graze.continuation(lambda u, p: u**3 - 3e8 * u - p * 1e12, 2.2e4, 4, from_=-5, to=5)
    assert branch.ends == ("parameter_limit", "parameter_limit")
    found = sorted((point.p, point.u[0]) for point in branch.special)
    assert np.allclose(found, [(-2.0, 1e4), (2.0, -1e4)], rtol=1e-6)


def test_a_pitchfork_is_a_branch_point():
    """u (p - u^2) = 0 along u = 0 passes p = 0."""
    branch = graze.continuation(lambda u, p: u * (p - u**2), 0.0, -0.97, from_=-1, to=1)
    assert [point.label for point in branch.special] == ["BP"]
    assert branch.special[0].p == pytest.approx(0.0, abs=1e-8)


def test_two_unknowns():
    """The Bratu problem on two inner points: v'' + p exp(v) = 0, symmetric, so both are alike."""
    def bratu(u, p):
        h2 = (1.0 / 3.0) ** 2
        return np.array([u[1] - 2 * u[0] + h2 * p * np.exp(u[0]), u[0] - 2 * u[1] + h2 * p * np.exp(u[1])])

    branch = graze.continuation(bratu, [0.0, 0.0], 0.0, from_=0, to=10)
    # u = h2 p exp(u) has its fold at u = 1, p = 9/e.
    folds = [point for point in branch.special if point.label == "LP"]
    assert folds[0].p == pytest.approx(9.0 / np.e, rel=1e-8)
    assert folds[0].u == pytest.approx([1.0, 1.0], rel=1e-6)


def test_what_the_function_raises_comes_back():
    def fails(u, p):
        if p > 0.3:
            raise ZeroDivisionError("here")
        return u - p

    with pytest.raises(ZeroDivisionError, match="here"):
        graze.continuation(fails, 0.0, 0.0, from_=-1, to=1)


def test_where_it_cannot_be_evaluated_the_branch_ends():
    branch = graze.continuation(
        lambda u, p: u - p if p < 0.5 else None, 0.0, 0.0, from_=-1, to=1
    )
    assert branch.p.max() < 0.5 and "not_converged" in branch.ends


@pytest.mark.parametrize("wrong", [
    dict(u0=[]), dict(u0=[[1.0]]), dict(u0=[np.nan]), dict(p0=3.0), dict(from_=2.0), dict(to=np.inf),
    dict(max_points=0), dict(max_step=-1.0), dict(max_seconds=0.0), dict(residual_tolerance=0.0),
])
def test_wrong_numbers_are_option_errors(wrong):
    with pytest.raises(graze.OptionError):
        graze.continuation(**{**dict(F=circle, u0=0.9, p0=0.1, from_=-2, to=2), **wrong})


def test_wrong_functions_are_errors():
    with pytest.raises(TypeError):
        graze.continuation(3, 0.9, 0.1, from_=-2, to=2)
    with pytest.raises(ValueError, match="F must return 1"):
        graze.continuation(lambda u, p: [1.0, 2.0], 0.9, 0.1, from_=-2, to=2)
    with pytest.raises(ValueError):
        graze.continuation(lambda u, p: "words", 0.9, 0.1, from_=-2, to=2)
    with pytest.raises(graze.NumericsError):
        graze.continuation(lambda u, p: u**2 + 1.0, 0.9, 0.1, from_=-2, to=2)
