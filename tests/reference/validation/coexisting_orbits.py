"""Stable motions that coexist in a system of two modes between two rigid stops: one with two impacts per forcing period and
two with four, found by simulation from several starts and then to all digits (several_contacts.py)."""
from several_contacts import System, show

STOP = ['1.0', '-0.6455774821228346']
SYSTEM = System(['1.0', '4.868488556304991'], ['0.09704789201894763', '0.015315246975930048'],
                ['1.0', '0.16892174155688267'], '1.0', '1.4954596219803933', '2.1660531651199495',
                [(STOP, '0.7580137672626773', 1, '0.8189853113753269'),
                 (STOP, '0.7909521325478488', -1, '0.8189853113753269')])

# state at force phase 0 and phases of the impacts, rough: stop 0 is the one above
STARTS = {
    'two': ([0.67843, -0.01434, -0.49225, 0.90822], [('impact', 1, 3.9157), ('impact', 0, 6.1853)]),
    'four_a': ([0.7166, 0.1096, 1.1865, 0.6395],
               [('impact', 0, 0.187), ('impact', 0, 0.883), ('impact', 1, 3.118), ('impact', 1, 3.776)]),
    'four_b': ([0.80941, 0.10139, 0.12378, 1.25691],
               [('impact', 0, 0.6447), ('impact', 1, 3.3311), ('impact', 1, 4.0340), ('impact', 0, 6.2533)]),
}

if __name__ == '__main__':
    for name, (z, events) in STARTS.items():
        z, told, turns = SYSTEM.orbit(z, 1, events)
        for i, (phase, period, kind, stop, v, time, y) in enumerate(told):
            show(f'{name}_phase_{i}', phase)
            show(f'{name}_speed_{i}', v)
        for i, m in enumerate(turns):
            show(f'{name}_multiplier_{i}_re', m.real)
            show(f'{name}_multiplier_{i}_im', m.imag)
