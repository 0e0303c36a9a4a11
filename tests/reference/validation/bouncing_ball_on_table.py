"""A ball on a table P cos t, g = 1, restitution r.

One impact in n periods, T = 2 pi n: the ball takes T between impacts at the same height, so it leaves with T/2 and comes
with -T/2. With the table's speed s' = -P sin p at the impact, r V + s' = T/2 and -V + s' = -T/2 give
    V = T/(1 + r),   -P sin p = n pi (1 - r)/(1 + r).
The linearised map has determinant r^2 and trace -2 r + T (1 + r) (1 - P cos p)/V (the load towards the table is
1 - P cos p), so that the period doubles at  P cos p = 2 (1 + r^2)/(1 + r)^2.

Without restitution (r = 0) the ball leaves where P cos p = 1 and lies again where its height above the table,
    h = -P cos(p + d) + P cos p - P sin p d - d^2/2,
is back at 0.
"""
from mpmath import mp, mpf, pi, sqrt, cos, sin, acos, atan2, findroot

from one_impact import number, show


def motions(P, r, n):
    s = n * pi * (1 - r) / (1 + r)
    for c in (sqrt(P ** 2 - s ** 2), -sqrt(P ** 2 - s ** 2)):
        V = 2 * pi * n / (1 + r)
        half = -r + pi * n * (1 + r) * (1 - c) / V
        root = sqrt(mp.mpc(half ** 2 - r ** 2))
        yield atan2(-s, c) % (2 * pi), V, sorted([half + root, half - root], key=lambda z: -abs(z))


if __name__ == '__main__':
    for r, n in (('0.8', 1), ('0.8', 2), ('0.5', 1), ('0.5', 3)):
        name, r = f'r{r}_n{n}', number(r)
        s = n * pi * (1 - r) / (1 + r)
        show(name + '_fold_P', s)
        P = sqrt(s ** 2 + (2 * (1 + r ** 2) / (1 + r) ** 2) ** 2)
        show(name + '_doubling_P', P)
        show(name + '_doubling_phase', atan2(-s, 2 * (1 + r ** 2) / (1 + r) ** 2) % (2 * pi))
        show(name + '_speed', 2 * pi * n / (1 + r))
    P, r = number('0.6'), number('0.8')
    for i, (p, V, m) in enumerate(sorted(motions(P, r, 1))):
        show(f'P0.6_{i}_phase', p)
        show(f'P0.6_{i}_multiplier_re', m[0].real)
        show(f'P0.6_{i}_multiplier_im', abs(m[0].imag))

    # the end of the branch r = 0.8, n = 1: the flight comes down to the table and up again before its end
    s = pi * (1 - r) / (1 + r)
    v = r * 2 * pi / (1 + r)                       # relative speed after the impact
    def height(p, d):
        P = -s / sin(p)
        return v * d - d ** 2 / 2 - P * (cos(p + d) - cos(p) + sin(p) * d), v - d + P * (sin(p + d) - sin(p))
    p, d = findroot(lambda p, d: list(height(p, d)), (mpf('3.3'), mpf('3.0')))
    show('r0.8_n1_touch_P', -s / sin(p))
    show('r0.8_n1_touch_phase', p)
    show('r0.8_n1_touch_after', d)

    P = mpf(2)
    p = 2 * pi - acos(1 / P)                       # leaves while the table still rises
    d = findroot(lambda d: P * cos(p) - P * cos(p + d) - P * sin(p) * d - d ** 2 / 2, mpf('4.6'))
    show('r0_P2_leaves_phase', p)
    show('r0_P2_lands_phase', (p + d) % (2 * pi))
    show('r0_P2_lands_speed', -(P * sin(p + d) - P * sin(p) - d))
    show('r0_P2_rest', 2 * pi - d)
    show('r0_P2_force', 1 - P * cos(p + d))
