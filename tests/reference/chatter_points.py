"""Where a chatter completes at the very instant of its release: the CH points of an oscillator with one stop.

    x'' + 2 zeta x' + x = cos(W t),   x <= s,   v+ = -r v-

Held on its stop it is pushed with cos(W t) - s and released where that falls to zero, at rest: every orbit that sticks
starts there. It comes back, chatters, and either comes to rest before the push has gone again or does not. One of the
parameters r, s, W is bisected between the two; writes chatter_points.csv.

A flight is the closed form of the damped oscillator; its end is found with a bound |x''| <= K over the next step: from
a gap g that falls at rate v, contact is no nearer than the root of g - v h - K h^2/2, and Newton's method finishes. K is
|x''| + J h with |x'''| <= J, for the longest step h that is asked for. After an impact
that leaves at speed u against a push a, falling at rate c, hops shrink like u/a while a falls by c in their time: the
rest completes for certain once 2 u/(a (1 - r)) is less than 1e-3 of the time a/c left, and it is lost once a hop does not
come back before the push has changed sign.
"""

import csv
from pathlib import Path

from mpmath import mp, mpf

HERE = Path(__file__).resolve().parent
mp.dps = 60

# name: (zeta, W, s, r) as doubles; the parameter that moves; a value at which it sticks, one at which it does not
CASES = {
    'Z2a_r': ((0.0, 0.3, 0.1, 0.8), 'r', 0.8, 0.83),
    'Z2b_r': ((0.0, 0.5, 0.2, 0.2), 'r', 0.2, 0.6),
    'Z2b_gap': ((0.0, 0.5, 0.2, 0.2), 's', 0.2, 0.75),
    'Z2b_frequency': ((0.0, 0.5, 0.2, 0.2), 'W', 0.5, 0.96),
    'damped_r': ((0.05, 0.4, 0.15, 0.5), 'r', 0.5, 0.8),
    'damped_frequency': ((0.05, 0.4, 0.15, 0.5), 'W', 0.4, 0.62),
}


class Oscillator:
    def __init__(self, zeta, W, s, r):
        self.zeta, self.W, self.s, self.r = zeta, W, s, r
        self.root = mp.sqrt(1 - zeta ** 2)
        self.forced = 1 / mp.mpc(1 - W ** 2, 2 * zeta * W)
        self.release = mp.acos(s) / W

    def start(self, t0, v0):
        """The arc from the stop at speed v0: its free amplitude, about the forced response."""
        turn = mp.expj(self.W * t0)
        q = self.s - (self.forced * turn).real
        p = v0 - (mp.mpc(0, self.W) * self.forced * turn).real
        return t0, q, (p + self.zeta * q) / self.root

    def state(self, arc, t):
        t0, a, b = arc
        h = t - t0
        decay, c, n = mp.exp(-self.zeta * h), mp.cos(self.root * h), mp.sin(self.root * h)
        x = decay * (a * c + b * n)
        v = -self.zeta * x + decay * self.root * (b * c - a * n)
        turn = mp.expj(self.W * t)
        return x + (self.forced * turn).real, v + (mp.mpc(0, self.W) * self.forced * turn).real

    def contact(self, arc, clear, reach):
        """The first contact after `clear`, up to which the gap is known to be positive, and the speed there.

        `reach`: the longest step.
        """
        _, a, b = arc
        jerk = mp.sqrt(a * a + b * b) * (1 + 4 * self.zeta) + abs(self.forced) * self.W ** 3
        t = clear
        while True:
            x, v = self.state(arc, t)
            gap = self.s - x
            bound = abs(mp.cos(self.W * t) - 2 * self.zeta * v - x) + jerk * reach
            if v > 0 and 2 * gap < v * reach and 4 * bound * gap < v * v:
                break
            t += min((mp.sqrt(v * v + 2 * bound * gap) - v) / bound, reach)
        for _ in range(7):
            x, v = self.state(arc, t)
            t += (self.s - x) / v
        return t, self.state(arc, t)[1]

    def sticks(self):
        """Whether the motion from its release comes to rest before the next one."""
        end = self.release + 2 * mp.pi / self.W
        # After a release the gap grows as (W sin(W t)) h^3/6 and, |x''''| < 4, stays clear for some time.
        clear = self.release + self.W * mp.sin(self.W * self.release) / 4
        t, v = self.contact(self.start(self.release, mpf(0)), clear, mpf('0.2'))
        while t < end:
            u = self.r * v
            a = mp.cos(self.W * t) - self.s
            left = end - t
            if a > 0 and 2 * u / (a * (1 - self.r)) < left / 1000 and a > self.W * left * mpf('1e-3'):
                return True
            # Against a push a - c h the gap u h - a h^2/2 + c h^3/6 stays open for good where u > 3 a^2/(8 c).
            if left < mpf('1e-4') and (a < 0 or u * self.W * mp.sin(self.W * t) > mpf('0.3755') * a * a):
                return False
            arc = self.start(t, -u)
            # Leaving at u against an acceleration of at most K the gap stays open for 2 u/K.
            t, v = self.contact(arc, t + u / 3, min(mpf('0.2'), u / abs(a)))
        return False


def critical(name):
    values, parameter, inside, outside = CASES[name]
    numbers = dict(zip(('zeta', 'W', 's', 'r'), map(mpf, values)))

    def sticks(value):
        return Oscillator(**{**numbers, parameter: value}).sticks()

    low, high = mpf(inside), mpf(outside)
    assert sticks(low) and not sticks(high), name
    while abs(high - low) > mpf('1e-17'):
        middle = (low + high) / 2
        low, high = (middle, high) if sticks(middle) else (low, middle)
    return low


def main():
    with open(HERE / 'chatter_points.csv', 'w', newline='') as file:
        writer = csv.writer(file, lineterminator='\n')
        writer.writerow(['case', 'zeta', 'frequency', 'gap', 'restitution', 'parameter', 'critical'])
        for name, (values, parameter, _, _) in CASES.items():
            value = critical(name)
            print(name, mp.nstr(value, 16), flush=True)
            writer.writerow([name, *values, {'r': 'stop.restitution', 's': 'stop.gap', 'W': 'forcing.frequency'}[parameter],
                             mp.nstr(value, 16)])


if __name__ == '__main__':
    main()
