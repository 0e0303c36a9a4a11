"""Chatter of x'' + x = cos(w t + p), x <= s, v -> -r v, from a release: w t + p = acos(s) at t = 0, x = s, v = 0.

Between impacts x = G cos(w t + p) + C cos(t - t0) + D sin(t - t0), G = 1/(1 - w^2). The next impact is the first zero of
x - s: short steps until it changes sign, then Newton's method; close to an impact the trivial zero is divided out. The
chatter is followed until its speeds are below 1e-22; what remains is 2 r v/(a (1 - r)), a the acceleration into the stop.
The mass then sticks until the force is gone again, one period after the start.
"""
from mpmath import mp, mpf, pi, cos, sin, acos, findroot

from one_impact import number, show

mp.dps = 50


class Flight:
    """Free motion from the stop at t0 with the speed v (away from it: negative)."""

    def __init__(self, w, p, s, t0, v):
        self.w, self.p, self.t0 = w, p, t0
        self.G = 1 / (1 - w ** 2)
        self.C = s - self.G * cos(w * t0 + p)
        self.D = v + self.G * w * sin(w * t0 + p)
        self.s = s

    def over(self, h):
        """Overlap x - s, h after the start."""
        return (self.G * cos(self.w * (self.t0 + h) + self.p) + self.C * cos(h) + self.D * sin(h)) - self.s

    def speed(self, h):
        return -self.G * self.w * sin(self.w * (self.t0 + h) + self.p) - self.C * sin(h) + self.D * cos(h)


def chatter(w, s, r, steps=200, smallest=mpf(10) ** -22):
    p = acos(s)
    t, v, events = mpf(0), mpf(0), []
    while True:
        flight = Flight(w, p, s, t, v)
        push = cos(w * t + p) - s
        if events and push > 0 and -v < smallest:
            return events, t - 2 * v / (push * (1 - r)), 2 * pi / w
        # within a chatter a flight takes about 2 |v|/push; the first one leaves the stop slowly, as the cube of time
        step = mpf(1) / steps
        if events and push > 0:
            step = min(step, -v / push / 4)
        h = step / 4 if events else mpf(1) / 4
        while flight.over(h) < 0:
            h += step
        low, high = h - step, h
        h = findroot(flight.over, (low, high), solver='anderson', tol=mpf(10) ** -90)
        t, v = t + h, flight.speed(h)
        events.append((t, v))
        v = -r * v


if __name__ == '__main__':
    for w, s, r in (('0.3', '0.5', '0.5'), ('0.35', '0.1', '0.8'), ('0.5', '0', '0.5'), ('0.25', '0.3', '0.7')):
        events, end, release = chatter(number(w), number(s), number(r))
        name = f'w{w}_s{s}_r{r}'
        for i in (0, 1, 2, 9):
            show(f'{name}_impact{i + 1}_time', events[i][0])
            show(f'{name}_impact{i + 1}_speed', events[i][1])
        show(name + '_chatter_ends', end)
        show(name + '_force_at_end', cos(number(w) * end + acos(number(s))) - number(s))
        show(name + '_release', release)
