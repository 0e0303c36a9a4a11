"""Two modes against one rigid stop: a period doubling within 3e-6 of a grazing, a fold within 2e-5 of one, and the points
in the plane of frequency and gap where their curves meet, all from the closed form of motions with one impact
(one_impact.py).

With E the flow over a period, J the impact, d = b/(b.b) its direction in velocity: where the impact speed V tends to 0,
V times det(E S -+ I) tends to a multiple of (b, 0) (E J -+ I)^-1 E (0, d). The fold (-) and the doubling (+) end on the curve of
grazing where this vanishes; it depends on the frequency alone. The gap is then the amplitude of the forced motion.
"""
from mpmath import mp, mpf, matrix, eye, det, lu_solve, findroot

from one_impact import OneImpact, number, show

W = [number('1.0'), number('5.038982107768481')]
ZETA = [number('0.2945623192021044'), number('0.18715916382755424')]
F = [number('1.0'), number('0.2995833008697377')]
B = [number('1.0'), number('-0.19389917574482163')]
R, OMEGA, GAP = number('0.5230813333303654'), number('0.638860173981165'), number('1.1130563755319858')


def system(omega):
    return OneImpact(W, [z * w for z, w in zip(ZETA, W)], F, B, omega, R)


def grazing_gap(s):
    return abs(sum(B[j] * s.forced[j] for j in range(2)))


def end(omega, sign):
    s = system(omega)
    d = matrix([0, 0] + B)
    return sum(B[j] * x for j, x in enumerate(lu_solve(s.E * s.J + sign * eye(4), s.E * d)[:2]))


if __name__ == '__main__':
    s = system(OMEGA)
    show('grazing_A', GAP / grazing_gap(s))
    phi = s.doubling(mpf('0.566'), GAP)
    A = s.amplitude(phi, GAP)
    assert s.speed(phi, A) > 0 and s.clearance(phi, A, GAP) > 0
    show('doubling_A', A)
    show('doubling_speed', s.speed(phi, A))
    show('doubling_gap', GAP / A)                 # the same point over the gap, at the amplitude 1
    show('doubling_gap_speed', s.speed(phi, A) / A)
    show('grazing_gap', grazing_gap(s))
    phi, t = s.touch((mpf('5.86'), mpf('3.5')), GAP)
    assert 0 < t < s.period
    show('touch_A', s.amplitude(phi, GAP))

    phi = max(s.phases(mpf(1), GAP), key=lambda p: s.speed(p, 1))
    show('orbit_phase', phi % (2 * mp.pi))
    show('orbit_speed', s.speed(phi, mpf(1)))

    for name, start in (('first', '0.3586'), ('last', '1.2748')):
        omega = findroot(lambda o: abs(system(o).kappa) - GAP, mpf(start))
        x = system(omega)
        show(f'{name}_fold_frequency', omega)
        show(f'{name}_fold_speed', x.speed(x.fold(), mpf(1)))
    for name, start in (('first', '0.3587'), ('last', '1.236')):
        show(f'{name}_grazing_frequency', findroot(lambda o: grazing_gap(system(o)) - GAP, mpf(start)))

    for name, sign, starts in (('fold', -1, ('0.637', '0.9556')), ('doubling', 1, ('0.637', '0.9557', '1.911'))):
        for i, start in enumerate(starts):
            omega = findroot(lambda o: end(o, sign), mpf(start))
            show(f'{name}_ends_{i}_frequency', omega)
            show(f'{name}_ends_{i}_gap', grazing_gap(system(omega)))

    # both multipliers at once: 1 and -1
    for i, start in enumerate(('0.955647', '1.91163')):
        start = mpf(start)
        omega = findroot(lambda o: det(system(o).map(system(o).fold(), mpf(1)) + eye(4)), (start, start + mpf(10) ** -6))
        x = system(omega)
        show(f'fold_and_doubling_{i}_frequency', omega)
        show(f'fold_and_doubling_{i}_gap', abs(x.kappa))
        show(f'fold_and_doubling_{i}_speed', x.speed(x.fold(), mpf(1)))
