"""Response of an oscillator with a one-sided spring: x'' + c x' + x + k max(0, x - a) = F cos(W t).

c = 0.05, k = 100, a = 0.1, F = 0.02: the points of the curve that NLvib's shooting method gave (Krack & Gross, Harmonic
Balance for Nonlinear Vibration Problems, Springer 2019; values at
github.com/yannikmadeheim-del/pyhbm, examples/nlFBS_examples/sdof_vibroimpact_validation), in closed form between the
contacts (see one_spring_contact.py); and the curve's folds, grazings and period doublings.
Frequencies are the doubles nearest to the decimals that were published.
"""

from mpmath import mp, mpf

from one_spring_contact import Structure

mp.dps = 30
oscillator = Structure([1], [mpf('0.025')], [mpf('0.02')], [1], 100, mpf('0.1'))

# name, frequency, about how long the contact lasts (s)
POINTS = [
    ('up_at_1.15455826742', 1.15455826742, 0.2945),
    ('up_1', 1.03538889913971, 0.28), ('up_2', 1.21408612430507, 0.298), ('up_3', 1.39079537846301, 0.304),
    ('up_4', 1.5008462945235, 0.306),
    ('down_1', 1.51455860042778, 0.304), ('down_2', 1.40098121893074, 0.297), ('down_3', 1.20353997915032, 0.27),
]
for name, W, tau in POINTS:
    orbit = oscillator.at_frequency(W, mpf(tau))
    print(name + '_reach', mp.nstr(orbit.reach(), 20))
    print(name + '_peak_force', mp.nstr(orbit.peak_force(), 20))
    print(name + '_phase', mp.nstr(orbit.phase, 20))
    print(name + '_duration', mp.nstr(orbit.tau, 20))

# |H(W)| F = a: (1 - W^2)^2 + (c W)^2 = (F/a)^2 = 0.04
for name, low, high in (('grazing_upper', 1.0, 1.2), ('grazing_lower', 0.8, 1.0)):
    print(name, mp.nstr(oscillator.grazing(mpf(low), mpf(high)), 20))
for name, tau, W in (('fold_upper', 0.3057, 1.557), ('fold_lower', 0.006, 1.091972)):
    fold = oscillator.fold(tau, W)
    print(name, mp.nstr(fold.W, 20))
    print(name + '_reach', mp.nstr(fold.reach(), 20))
for name, tau, W in (('doubling_upper', 0.26, 0.95), ('doubling_lower', 0.06, 0.8975)):
    print(name, mp.nstr(oscillator.multiplier_point(tau, W).W, 20))
