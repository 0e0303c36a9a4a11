"""Free vibration of Timoshenko's beam, for the scripts beside this one.

    kappa G A (v'' - th') + rho A w^2 v = 0,   E I th'' + kappa G A (v' - th) + rho I w^2 th = 0

v the deflection, th the rotation of the section. Below the frequency at which shear waves set in the solutions are cos a x,
sin a x with th'/v' in the ratio of p to a, and cosh b x, sinh b x with s to b.
"""

from mpmath import sqrt


def waves(w, E, rho, A, I, shear):
    """a, b, p, s at the frequency w; shear: kappa G."""
    stretch, slide = rho * w ** 2 / E, rho * w ** 2 / shear
    half = (stretch + slide) / 2
    root = sqrt(half ** 2 - stretch * slide + rho * A * w ** 2 / (E * I))
    a, b = sqrt(half + root), sqrt(root - half)
    return a, b, (a ** 2 - slide) / a, (b ** 2 + slide) / b
