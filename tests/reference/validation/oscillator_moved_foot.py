"""Code_Aster SDND102 (V5.01.102): an oscillator on a moved foot against an elastic stop.

m x'' + c (x' - y') + k (x - y) = -K (x - a) while x > a, else the same without the right side; y'' = sin(Omega t) is the
acceleration of the foot, integrated as the source does: y' = -cos(Omega t)/Omega, y = -sin(Omega t)/Omega^2. At t = 0
x - y = 0 and x' - y' = 0. The stop stands still: x is the absolute displacement.

Every phase is solved in closed form, x = real part of S e^(i Omega t) + damped oscillation, S from the equation; its end
is the first zero of x - a, found on a grid (200 steps for a period in contact, 10 in flight, where the motion is thirty
times slower) and refined to the working precision.

The source prints what central differences give with its step of 2.5e-4 s. They are repeated at the end, in double
precision, to show that its numbers differ from the exact ones by the error of that step: the damping force is taken from
the velocity half a step before, and a contact of 2 ms has eight steps.
"""
import math

from mpmath import mp, mpf, cos, exp, expj, findroot, mpc, pi, sin, sqrt

mp.dps = 30

m, k, ratio, K, a = mpf(25), mpf(98696), mpf("0.07"), mpf("5.76e7"), mpf("5e-4")
Omega = 20 * pi
w = sqrt(k / m)
c = 2 * ratio * w * m


class Phase:
    """Motion from (t0, x0, v0) on, in contact or not."""

    def __init__(self, t0, x0, v0, contact):
        self.t0 = t0
        stiffness = k + (K if contact else 0)
        self.rest = K * a / stiffness if contact else mpf(0)
        # k y + c y' = real part of i (k + i Omega c)/Omega^2 e^(i Omega t)
        force = mpc(0, 1) * (k + mpc(0, 1) * Omega * c) / Omega ** 2
        self.S = force / (stiffness - m * Omega ** 2 + mpc(0, 1) * Omega * c)
        self.decay = c / (2 * m)
        self.wd = sqrt(stiffness / m - self.decay ** 2)
        carried = self.S * expj(Omega * t0)
        self.A = x0 - self.rest - carried.real
        self.B = (v0 - (mpc(0, 1) * Omega * carried).real + self.decay * self.A) / self.wd

    def x(self, t):
        s = t - self.t0
        return (self.rest + (self.S * expj(Omega * t)).real
                + exp(-self.decay * s) * (self.A * cos(self.wd * s) + self.B * sin(self.wd * s)))

    def v(self, t):
        s = t - self.t0
        return ((mpc(0, 1) * Omega * self.S * expj(Omega * t)).real
                + exp(-self.decay * s) * ((self.B * self.wd - self.decay * self.A) * cos(self.wd * s)
                                          - (self.A * self.wd + self.decay * self.B) * sin(self.wd * s)))


def refined(f, low, high):
    t = findroot(f, (low, high), solver="anderson", tol=mpf(10) ** -50, verify=False)
    assert low <= t <= high and abs(f(t)) < mpf(10) ** -25
    return t


def crossing(phase, contact, until):
    """First time after the phase's start at which x - a changes to the other sign; None before `until`."""
    step = 2 * pi / sqrt((k + K) / m) / (200 if contact else 10)
    low = phase.t0 + step / 1000
    while low < until:
        high = min(low + step, until)
        if (phase.x(high) < a) == contact:
            return refined(lambda t: phase.x(t) - a, low, high)
        low = high
    return None


times = [mpf(t) for t in ("0.05", "0.156", "0.25", "0.4", "0.5", "0.8", "0.9", "1")]
phase, contact, count = Phase(mpf(0), mpf(0), -1 / Omega, False), False, 0
while True:
    end = crossing(phase, contact, mpf(1))
    for t in times:
        if t >= phase.t0 and (end is None or t < end):
            print(f"displacement_at_{mp.nstr(t, 3)}", mp.nstr(phase.x(t), 20))
    if contact and end is not None:
        peak = refined(phase.v, phase.t0, end)          # the speed falls all the way through a contact
        print(f"peak_force_{count}", mp.nstr(K * (phase.x(peak) - a), 20))
    if end is None:
        break
    if not contact:
        count += 1
        print(f"contact_{count}", mp.nstr(end, 20))
    contact = not contact
    phase = Phase(end, a, phase.v(end), contact)


def central_differences(step, instants):
    """Absolute displacement at the instants, in the relative coordinate u = x - y as the source does."""
    m, k, K, a, Omega = 25.0, 98696.0, 5.76e7, 5e-4, 20 * math.pi
    c = 2 * 0.07 * math.sqrt(k * m)

    def foot(t):
        return -math.sin(Omega * t) / Omega ** 2

    def acceleration(u, velocity, t):
        force = -k * u - c * velocity - m * math.sin(Omega * t)
        return (force - K * max(0.0, u + foot(t) - a)) / m

    u, half, told = 0.0, step / 2 * acceleration(0.0, 0.0, 0.0), []
    for n in range(1, round(max(instants) / step) + 1):
        u += step * half
        if any(abs(n * step - t) < step / 4 for t in instants):
            told.append(u + foot(n * step))
        half += step * acceleration(u, half, n * step)
    return told


instants = [float(t) for t in times]
for t, x in zip(instants, central_differences(2.5e-4, instants)):
    print(f"central_differences_at_{t:.3g}", f"{x:.6g}")
