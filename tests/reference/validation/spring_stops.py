"""Two modes between two springs with dashpots: periodic motions with two, three and six contacts, and a period doubling.

Rough starts (state at force phase 0, phases of the contacts), then all digits by several_contacts.py. A multiplier -1 is
found over the frequency by the secant method on det(M + I).
"""
from mpmath import findroot

from several_contacts import System, show, mpf, mp, pi

B1 = ['1.0', '0.5521008854238876']
K1, C1 = '1111.5945527702863', '3.794962790783486'


def two_sided(omega='2.2943301996135768'):
    return System(['1.0', '3.54346503537961'], ['0.0656183635401234', '0.09605963396269726'], ['1.0', '1.0'],
                  '1.0', omega, '0', [(B1, '0.18462425629103513', 1, K1, C1), (B1, '0.21391668866603358', -1, K1, C1)])


B2 = ['1.0', '0.47911512314340865']
K2, C2 = '593.3333349792239', '0.3252033578302546'


def one_sided(omega='0.7856911708582921'):
    return System(['1.0', '4.092724841533205'], ['0.11636274130619374', '0.10728349179804704'], ['1.0', '1.0'],
                  '1.0', omega, '0', [(B2, '0.05182716784742317', 1, K2, C2), (B2, '1.4785829102100143', -1, K2, C2)])


def contacts(omega, rows):
    """Beginnings and ends of contacts from rows of (stop, phase, duration)."""
    return [e for stop, phase, time in rows
            for e in (('enter', stop, mpf(phase)), ('leave', stop, mpf(phase) + mpf(time) * omega))]


def tell(name, system, z, periods, rows):
    z, told, turns = system.orbit(z, periods, contacts(system.omega, rows))
    for i in range(0, len(told), 2):
        phase, period, kind, stop, v, time, y = told[i]
        after = told[i + 1]
        show(f'{name}_phase_{i // 2}', phase)
        show(f'{name}_speed_{i // 2}', v)
        show(f'{name}_contact_{i // 2}', after[5] - time)
    for i, m in enumerate(turns):
        show(f'{name}_multiplier_{i}_re', m.real)
        show(f'{name}_multiplier_{i}_im', m.imag)
    return z, told


if __name__ == '__main__':
    tell('two_sided_2', two_sided(), [0.1, 0.051, 0.534, 0.169], 1, [(0, 0.195, 0.081), (1, 3.308, 0.081)])
    tell('two_sided_3', two_sided(), [0.0403, 0.0744, 0.656, 0.237], 1,
         [(0, 0.285, 0.08), (1, 2.993, 0.083), (1, 4.63, 0.077)])
    rows = [(0, 0.504, 0.124), (0, 0.899, 0.128), (0, 5.569, 0.118)]
    tell('one_sided_3', one_sided(), [-0.266, 0.129, 0.075, 0.745], 1, rows)
    tell('one_sided_6', one_sided(), [-0.2396, 0.1507, 0.1418, 0.6475], 2,
         [(0, 0.417, 0.122), (0, 0.823, 0.128), (0, 5.591, 0.118),
          (0, 2 * pi + 0.580, 0.124), (0, 2 * pi + 0.991, 0.125), (0, 2 * pi + 5.539, 0.118)])

    # the three contacts per period double over the frequency
    def flip(omega):
        s = one_sided().at(omega)
        z, told, turns = s.orbit([-0.266, 0.129, 0.075, 0.745], 1, contacts(omega, rows))
        value = mpf(1)
        for m in turns:
            value *= m + 1
        return value.real
    omega = findroot(flip, (mpf('0.790'), mpf('0.7907')), solver='secant', tol=mpf(10) ** -40)
    show('one_sided_doubling_frequency', omega)
    s = one_sided().at(omega)
    z, told, turns = s.orbit([-0.266, 0.129, 0.075, 0.745], 1, contacts(omega, rows))
    show('one_sided_doubling_phase', told[0][0])
    show('one_sided_doubling_speed', told[0][4])
    show('one_sided_doubling_multiplier', turns[0].real)
