"""x'' + 0.1 x' + x = A cos t, x <= 1, r = 0.8, one impact per period: orbit at A = 1, grazing and fold over A.

Grazing: the forced motion without impacts just reaches the stop, A = sqrt((1 - w^2)^2 + (0.1 w)^2) = 0.1.
"""
from mpmath import mp, mpf, sqrt

from one_impact import oscillator, number, show

if __name__ == '__main__':
    s = oscillator(number('0.05'), mpf(1), number('0.8'))
    gap, A = mpf(1), mpf(1)
    phi = max(s.phases(A, gap), key=lambda x: s.speed(x, A))
    show('A1_phase', phi)
    show('A1_speed', s.speed(phi, A))
    show('A1_speed_after', s.speed(phi, A) * number('0.8'))
    show('A1_clearance', s.clearance(phi, A, gap))
    m = s.multipliers(phi, A)
    show('A1_multiplier_re', m[0].real)
    show('A1_multiplier_im', abs(m[0].imag))
    # where the demo starts, half a turn of the force after phase 0
    x, v = s.displacement(phi, A, mp.pi - phi)
    show('A1_displacement_at_pi', x)
    show('A1_velocity_at_pi', v)
    phi = s.fold()
    A = s.amplitude(phi, gap)
    show('fold_A', A)
    show('fold_phase', phi)
    show('fold_speed', s.speed(phi, A))
    for text in ('0.5', '1.0', '1.2', '1.4'):
        w = number(text)
        show(f'grazing_w{text}_A', sqrt((1 - w ** 2) ** 2 + (2 * number('0.05') * w) ** 2))
        s = oscillator(number('0.05'), w, number('0.8'))
        A = s.amplitude(s.fold(), gap)
        if s.speed(s.fold(), A) > 0:
            show(f'fold_w{text}_A', A)
            show(f'fold_w{text}_speed', s.speed(s.fold(), A))
