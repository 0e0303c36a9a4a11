"""Bouncing bar of Doyen, Ern and Piperno: an elastic bar falls flat on a rigid floor.

L = 10, E = 900, rho = 1, g = 10, dropped from h = 5; wave speed c = sqrt(E/rho) = 30. It touches at sqrt(2 h/g) with the speed
v = sqrt(2 g h). The floor stops its lower end, and characteristics from the undisturbed bar above carry -(v + g t), so that
the floor presses with rho c (v + g t), t from the contact on, until the wave that the free end reflects is back at 2 L/c. It
brings 2 rho c (v + g (t - 2 L/c)): what is left, rho c (v - 2 g L/c) at that instant, is tension, which the floor does not
bear. The bar leaves at 2 L/c.
"""

from mpmath import mp, mpf

mp.dps = 30
L, E, rho, g, h = (mpf(x) for x in (10, 900, 1, 10, 5))
c, v = mp.sqrt(E / rho), mp.sqrt(2 * g * h)
assert v > 2 * g * L / c
print("contact", mp.nstr(mp.sqrt(2 * h / g), 20))
print("speed", mp.nstr(v, 20))
print("separation", mp.nstr(mp.sqrt(2 * h / g) + 2 * L / c, 20))
