"""Response of a rod against an elastic obstacle at its tip, forced there with F cos(W t).

Vadcard, Batailly & Thouverez, J. Sound Vib. 531 (2022) 116950, table 1 and figure 17: L = 0.13 m, E = 210 GPa,
rho = 7800 kg/m^3, A = 15.6 cm^2, clamped at one end, n = 20 linear elements with consistent masses, damping ratio 0.0075
in every mode, F = 25 kN, gap 0.2 mm, obstacle of kappa E A/L with kappa = 0.4 and 4. With theta = (2 j - 1) pi/(2 n) and
element length l = L/n the modes are sin(i theta) at node i,

    w_j^2 = (6 E/(rho l^2)) (1 - cos theta)/(2 + cos theta),    modal mass rho A l n (2 + cos theta)/6.

The motion is closed form between the contacts (see one_spring_contact.py). Frequencies are the doubles nearest to the decimals
of NLvib's curves at github.com/yannikmadeheim-del/pyhbm, examples/rod_example.
"""

from mpmath import mp, mpf

from one_spring_contact import Structure

mp.dps = 30
N, L, E, RHO, A = 20, mpf('0.13'), mpf('210e9'), mpf(7800), mpf('15.6e-4')


def rod(kappa):
    w, tip = [], []
    length = L / N
    for j in range(1, N + 1):
        theta = (2 * j - 1) * mp.pi / (2 * N)
        w.append(mp.sqrt(6 * E / (RHO * length ** 2) * (1 - mp.cos(theta)) / (2 + mp.cos(theta))))
        tip.append(mp.sin(N * theta) / mp.sqrt(RHO * A * length * N * (2 + mp.cos(theta)) / 6))
    delta = [mpf('0.0075') * x for x in w]
    return Structure(w, delta, [25000 * x for x in tip], tip, mpf(kappa) * E * A / L, mpf('2e-4'))


# kappa, name, frequency, about how long the contact lasts (s)
POINTS = [
    ('0.4', 'up_1', 62746.8349781904, 2.565e-5), ('0.4', 'up_2', 63863.0585478515, 2.67e-5),
    ('0.4', 'up_3', 64555.8073588275, 2.9e-5), ('0.4', 'down_1', 64558.402022453, 2.8e-5),
    ('4', 'up_1', 62748.3433698932, 1.95e-5), ('4', 'up_2', 66009.5615955707, 1.3e-5),
    ('4', 'up_3', 68794.4908921848, 1.9e-5), ('4', 'down_1', 67775.1052840776, 1.6e-5),
]

for kappa in ('0.4', '4'):
    structure = rod(kappa)
    for of, name, W, tau in POINTS:
        if of != kappa:
            continue
        orbit = structure.at_frequency(W, mpf(tau))
        print(f'rod_{kappa}_{name}_phase', mp.nstr(orbit.phase, 20))
        print(f'rod_{kappa}_{name}_duration', mp.nstr(orbit.tau, 20))
        print(f'rod_{kappa}_{name}_reach', mp.nstr(orbit.reach(), 20))
        print(f'rod_{kappa}_{name}_peak_force', mp.nstr(orbit.peak_force(), 20))
