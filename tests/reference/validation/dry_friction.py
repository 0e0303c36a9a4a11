"""Motions with dry friction, in closed form piece by piece.

Den Hartog's oscillator x'' + x = cos(b t) -+ F: without stops x_max^2 = V^2 - F^2 U^2 with V = 1/(1 - b^2) and
U = sin(pi/b)/(b (1 + cos(pi/b))), and the velocity is zero where cos(b t) = -U F/x_max.. by the half period; with one
stop per half period the pieces are repeated until they no longer change.

SDND106: masses m and m, a spring k between them; the first sticks up to 3000 N and slides against 2000 N; the second
is loaded by 3000 N, which falls to nothing between 0.2 s and 0.200001 s. While the first slides the centre c and the
distance d move as 2 m c'' = f - R, m d'' = -2 k d + f + R.

A mass 1 on a spring 1 on a belt of speed v, static friction S and sliding friction R: 2 (pi - atan((S - R)/v)) of slip,
2 (S - R)/v of stick.
"""
from mpmath import mp, mpf, pi, cos, sin, acos, atan, sqrt, findroot

from one_impact import number, show


def unstopped(b, force):
    V = 1 / (1 - b ** 2)
    U = sin(pi / b) / (b * (1 + cos(pi / b)))
    return sqrt(V ** 2 - force ** 2 * U ** 2)


def first_after(start, holds, step):
    low, high = start, start + step
    while not holds(high):
        low, high = high, high + step
    for _ in range(110):
        middle = (low + high) / 2
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high


def stopping(b, force, periods):
    """Phases at which it slips forward and comes to rest after that, and where, after so many periods."""
    t, x, last = mpf(0), mpf(0), None
    while t < 2 * pi * periods / b:
        push = lambda s: cos(b * s) - x
        if abs(push(t)) <= force:
            t = first_after(t, lambda s: abs(push(s)) > force, mpf('.05'))
        sign = 1 if push(t) > 0 else -1
        c, rest, t0 = 1 / (1 - b ** 2), -sign * force, t
        A, B = x - rest - c * cos(b * t0), c * b * sin(b * t0)
        speed = lambda s: -A * sin(s - t0) + B * cos(s - t0) - c * b * sin(b * s)
        t = first_after(t0, lambda s: sign * speed(s) <= 0, mpf('.05'))
        x = rest + A * cos(t - t0) + B * sin(t - t0) + c * cos(b * t)
        if sign > 0:
            last = (b * t0) % (2 * pi), (b * t) % (2 * pi), x
    return last


def sdnd106(end):
    m, k, R = mpf(5), mpf(10000), mpf(2000)
    w, w1 = sqrt(2 * k / m), sqrt(k / m)
    slip = acos(1 - mpf(3000) / 3000) / w1
    state = (slip, mpf(0), mpf(3000) / k * (1 - cos(w1 * slip)), mpf(0), mpf(3000) / k * w1 * sin(w1 * slip))

    def later(state, f, rate, t):
        """Under a load f + rate (t - t0), from t0, x1, x2, v1, v2."""
        t0, x1, x2, v1, v2 = state
        s = t - t0
        c0, vc, d0, vd = (x1 + x2) / 2, (v1 + v2) / 2, x2 - x1, v2 - v1
        c = c0 + vc * s + (f - R) / (4 * m) * s ** 2 + rate / (12 * m) * s ** 3
        vc += (f - R) / (2 * m) * s + rate / (4 * m) * s ** 2
        p, q = (f + R) / (2 * k), rate / (2 * k)
        A, B = d0 - p, (vd - q) / w
        d = p + q * s + A * cos(w * s) + B * sin(w * s)
        vd = q - A * w * sin(w * s) + B * w * cos(w * s)
        return t, c - d / 2, c + d / 2, vc - vd / 2, vc + vd / 2

    if end < number('0.2'):
        return slip, None, later(state, 3000, 0, end)
    state = later(state, 3000, 0, number('0.2'))
    fall = number('0.200001') - number('0.2')
    state = later(state, 3000, -3000 / fall, number('0.200001'))
    stick = findroot(lambda t: later(state, 0, 0, t)[3], mpf('0.315'))
    state = later(state, 0, 0, stick)
    t, x1, x2, v1, v2 = state
    s = end - stick
    return slip, stick, (end, x1, x1 + (x2 - x1) * cos(w1 * s) + v2 / w1 * sin(w1 * s), mpf(0), mpf(0))


if __name__ == '__main__':
    for b, force in (('0.7', '0.3'), ('1.6', '0.4'), ('0.45', '0.2')):
        show(f'b{b}_F{force}_highest', unstopped(number(b), number(force)))
    for b, force in (('0.7', '0.8'), ('0.5', '0.5')):
        slips, rests, x = stopping(number(b), number(force), 40)
        show(f'b{b}_F{force}_slips', slips)
        show(f'b{b}_F{force}_rests', rests)
        show(f'b{b}_F{force}_highest', x)
    slip, _, early = sdnd106(number('0.15'))
    show('sdnd106_slip', slip)
    show('sdnd106_first_at_0.15', early[1])
    show('sdnd106_second_at_0.15', early[2])
    _, stick, late = sdnd106(number('0.339965'))
    show('sdnd106_stick', stick)
    show('sdnd106_first_at_0.339965', late[1])
    show('sdnd106_second_at_0.339965', late[2])
    for v in ('0.2', '0.5'):
        show(f'belt_period_{v}', 2 * (pi - atan(number('0.5') / number(v))) + 2 * number('0.5') / number(v))
