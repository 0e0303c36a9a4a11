#!/usr/bin/env python3
"""Periodic motions under several harmonics: data/validation/two_harmonics.toml and half_order_spring.toml.

Rough starts (state at phase 0 of the common period, phases of the contacts), then all digits by several_contacts.py.

    python3 several_harmonics.py
"""
from several_contacts import System, mpf, show

NONE = ['0', '0']


def scaled(amplitude, shape):
    return [mpf(amplitude) * mpf(x) for x in shape]


def two_harmonics():
    return System(['1.0', '3.7'], ['0.04', '0.11'], NONE, '0', '1.7', '0.3', [(['1.0', '0.55'], '0.08', 1, '0.7')],
                  [(1, scaled('1.0', ['1.0', '0.4']), '0.3'), (3, scaled('2.2', ['0.3', '1.0']), '-0.9')])


def half_order_spring():
    shape = ['1.0', '0.5']
    return System(['1.0', '3.2'], ['0.05', '0.09'], NONE, '0', '1.05', '0',
                  [(shape, '0.1', 1, '300.0', '2.0'), (shape, '0.14', -1, '500.0', '1.2')],
                  [(2, scaled('1.0', shape), '0'), (1, scaled('0.5', ['0.8', '-0.6']), '1.3')])


def tell(name, system, z, events):
    z, told, turns = system.orbit(z, 1, events)
    for i, (phase, _, kind, _, v, _, _) in enumerate(event for event in told if event[2] != 'leave'):
        show(f'{name}_phase_{i}', phase)
        show(f'{name}_speed_{i}', v)
    for i, m in enumerate(turns):
        show(f'{name}_multiplier_{i}_re', m.real)
        show(f'{name}_multiplier_{i}_im', m.imag)


if __name__ == '__main__':
    tell('two_harmonics', two_harmonics(), [-0.885, 0.114, 1.712, -1.389], [('impact', 0, mpf('0.851'))])
    rows = [(0, 0.1221, 0.1743), (1, 1.4405, 0.1311), (1, 2.3179, 0.1238), (0, 2.9909, 0.1645), (0, 4.1476, 0.1365),
            (1, 4.9527, 0.1241), (0, 5.6417, 0.1624)]
    tell('half_order_spring', half_order_spring(), [0.08876120001798721, -0.049991913043805535, 0.22238579735161124,
                                                    0.014662992186731012],
         [e for stop, phase, time in rows
          for e in (('enter', stop, mpf(phase)), ('leave', stop, mpf(phase) + mpf(time) * mpf('1.05')))])
