"""Folds and period doublings of u'' + 0.04 u' + u = A cos(w t), u <= 1, r = 0.9, one impact in two forcing periods.

The published loci (VIVID, files pp2_omega0.8_*.csv) were found by bisection over the impact speed until the critical
multiplier is within 1e-5 of 1 or -1, each motion by Newton's method to a residual of 1e-10. Here they come from the closed
form, at the printed frequencies; for the doublings also each printed motion itself (A and w as printed, not exactly at
the doubling), with its impact speed and multipliers. `.._off` is the printed number over the one computed here, less 1.
"""
from mpmath import mp, mpf, findroot, sqrt

from one_impact import oscillator, number, show

# printed w, A, impact speed, multipliers (the larger one first)
DOUBLINGS = [
    ('0.8100000000000001', '0.3475333988945534', '0.0653039882953620', '-0.9999966562546645', '-0.4354918489543720'),
    ('0.8007900000000011', '0.3601817820562527', '0.0060385158832541', '-1.0000094902480596', '-0.4323891872918429'),
    ('0.9099099999999890', '0.3678193309399836', '0.8420547207169098', '-1.0000056210925024', '-0.4661959560517870'),
    ('0.9997099999999791', '0.0404135959558108', '0.0184502285318571', '-1.0000026325259079', '-0.4899145452195165'),
]
FOLDS = [('0.7990000000000000', '0.3628362019762544'), ('0.7881379999999892', '0.3506941722911653'),
         ('0.7988379999999999', '0.3630206039749963'), ('0.7997509999999967', '0.3618133826225846')]
GAP = mpf(1)


def system(w):
    return oscillator(number('0.02'), number(w), number('0.9'), 2)


if __name__ == '__main__':
    for w, A, v, *multipliers in DOUBLINGS:
        s, name = system(w), f'PD_{w[:7]}'
        phi = min(s.phases(number(A), GAP), key=lambda p: abs(s.speed(p, number(A)) - mpf(v)))
        at = s.doubling(phi, GAP)
        value = s.amplitude(at, GAP)
        assert s.speed(at, value) > 0 and s.clearance(at, value, GAP) > 0
        show(name + '_A', value)
        print(name + '_A_off', mp.nstr(mpf(A) / value - 1, 2))
        show(name + '_speed', s.speed(at, value))
        show(name + '_motion_speed', s.speed(phi, number(A)))
        print(name + '_motion_speed_off', mp.nstr(mpf(v) / s.speed(phi, number(A)) - 1, 2))
        for i, (z, printed) in enumerate(zip(s.multipliers(phi, number(A)), multipliers)):
            show(f'{name}_motion_multiplier_{i}', z.real)
            print(f'{name}_motion_multiplier_{i}_off', mp.nstr(mpf(printed) / z.real - 1, 2))
    for w, A in FOLDS:
        s, name = system(w), f'LP_{w[:8]}'
        at = s.fold()
        value = s.amplitude(at, GAP)
        assert s.speed(at, value) > 0 and s.clearance(at, value, GAP) > 0
        show(name + '_A', value)
        print(name + '_A_off', mp.nstr(mpf(A) / value - 1, 2))
        show(name + '_speed', s.speed(at, value))

    # Both loci leave the curve of grazing A = sqrt((1 - w^2)^2 + (0.04 w)^2) where two forcing periods take a whole number
    # m of damped half periods of the oscillator: w = 4 xi/m, xi = sqrt(1 - 0.02^2), here m = 5; that of the doubling comes
    # back to it at m = 4.
    for m in (5, 4):
        w = 4 * sqrt(1 - number('0.02') ** 2) / m
        show(f'resonance{m}_w', w)
        show(f'resonance{m}_A', sqrt((1 - w ** 2) ** 2 + (2 * number('0.02') * w) ** 2))

    # The fold ends where its motion also touches the stop half way: unknowns w and the time of the touch.
    def touch(w, t):
        s = oscillator(number('0.02'), w, number('0.9'), 2)
        x, v = s.displacement(s.fold(), s.amplitude(s.fold(), GAP), t)
        return [x - GAP, v]
    w, t = findroot(touch, (mpf('0.7881'), mpf('10.44')))
    s = oscillator(number('0.02'), w, number('0.9'), 2)
    assert 0 < t < s.period
    show('fold_touches_w', w)
    show('fold_touches_A', s.amplitude(s.fold(), GAP))
