"""The first zero of a polynomial, in extended precision.

By bisection with a bound on the second derivative: no interval is left before it is proved free of zeros.
"""
from mpmath import mp, mpf


def value(poly, s):
    total = mpf(0)
    for c in reversed(poly):
        total = total * s + c
    return total


def value_and_rate(poly, s):
    total = rate = mpf(0)
    for c in reversed(poly):
        rate = rate * s + total
        total = total * s + c
    return total, rate


def first_zero(poly, h):
    """Smallest zero in (0, h] of a polynomial that is positive at 0; None if there is provably none."""
    if not poly[0] > 0:
        raise ArithmeticError("the search must start at a positive value")
    bound, power = mpf(0), mpf(1)
    for n in range(2, len(poly)):
        bound += n * (n - 1) * abs(poly[n]) * power
        power *= h
    return search(poly, bound, mpf(0), (poly[0], poly[1] if len(poly) > 1 else mpf(0)), h, value_and_rate(poly, h), 0)


def search(poly, bound, lo, at_lo, hi, at_hi, depth):
    h = hi - lo
    if at_hi[0] > 0 and min(at_lo[0], at_hi[0]) > bound * h ** 2 / 8:
        return None                                           # a chord cannot be undercut further than this
    if abs(at_lo[1]) > bound * h:                             # monotone
        return None if at_hi[0] > 0 else polish(poly, lo, hi)
    if depth > 150:
        raise ArithmeticError(f"grazing: undecided near s = {mp.nstr(lo, 15)}")
    mid = (lo + hi) / 2
    at_mid = value_and_rate(poly, mid)
    zero = search(poly, bound, lo, at_lo, mid, at_mid, depth + 1)
    if zero is None and at_mid[0] > 0:
        zero = search(poly, bound, mid, at_mid, hi, at_hi, depth + 1)
    return zero


def polish(poly, lo, hi):
    """The zero of a polynomial that falls all the way from lo (positive) to hi: Newton, safeguarded by bisection."""
    s = (lo + hi) / 2
    for _ in range(400):
        f, rate = value_and_rate(poly, s)
        if f > 0:
            lo = s
        else:
            hi = s
        step = -f / rate
        if abs(step) <= s * mpf(10) ** (5 - mp.dps):
            return s + step
        s = s + step if lo < s + step < hi else (lo + hi) / 2
    raise ArithmeticError("zero did not converge")
