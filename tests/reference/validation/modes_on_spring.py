"""Modes under constant forces, against a linear spring at one place: exact between the instants at which it is met or left.

    q_j'' + w_j^2 q_j = f_j - k b_j y,   y = max(sum b_j q_j - gap, 0),

free in the modes given, in contact in those of diag(w^2) + k b b', whose squared frequencies L solve the secular equation
1 + k sum b_j^2/(w_j^2 - L) = 0 (one between every two neighbours of the w_j^2, and one beyond) and whose shapes are
b_j/(w_j^2 - L), made of length 1.
"""
import math

from mpmath import cos, mp, mpf, sin, sqrt


def flown(square, force, q, v, t):
    """x'' + square x = force from q, v on: x and x' after t."""
    if square == 0:
        return q + v * t + force * t * t / 2, v + force * t
    w = sqrt(square)
    c, s, rest = cos(w * t), sin(w * t), force / square
    return rest + (q - rest) * c + v / w * s, v * c - (q - rest) * w * s


def secular_root(squares, b, k, i):
    """The i-th root, as its distance from squares[i]; solved as a fixed point with the pole beside it taken out."""
    above = squares[i + 1] - squares[i] if i + 1 < len(squares) else k * sum(x * x for x in b) * 2
    low, high = mpf(0), above

    def f(x):
        return 1 + k * sum(b_j * b_j / ((s - squares[i]) - x) for s, b_j in zip(squares, b))

    def slope(x):
        return k * sum(b_j * b_j / ((s - squares[i]) - x) ** 2 for s, b_j in zip(squares, b))

    x = above / 2
    while True:                                                 # f grows from minus infinity: Newton within the bracket
        y = f(x)
        low, high = (x, high) if y < 0 else (low, x)
        new = x - y / slope(x)
        if not low < new < high:
            new = (low + high) / 2
        if abs(new - x) <= abs(x) * mpf(10) ** (4 - mp.dps):
            return new
        x = new


class Contact:
    """The modes with the spring."""

    def __init__(self, squares, b, k):
        self.squares, self.shapes = [], []
        for i in range(len(b)):
            d = secular_root(squares, b, k, i)
            shape = [b_j / ((s - squares[i]) - d) for s, b_j in zip(squares, b)]
            length = sqrt(sum(x * x for x in shape))
            self.squares.append(squares[i] + d)
            self.shapes.append([x / length for x in shape])

    def into(self, q):
        return [sum(x * y for x, y in zip(shape, q)) for shape in self.shapes]

    def back(self, p):
        return [sum(shape[j] * x for shape, x in zip(self.shapes, p)) for j in range(len(p))]


class Part:
    """A piece of the motion in coordinates that do not couple: of all that is asked of it, the place's displacement."""

    def __init__(self, squares, force, row, q, v):
        self.all = list(zip(squares, force, q, v))
        self.row = row
        self.waves = []                                         # of the place, in floats: where to look for a crossing
        for r_j, (square, f, q_j, v_j) in zip(row, self.all):
            w = sqrt(square)
            a, b = (q_j - f / square, v_j / w) if square else (q_j, v_j)
            rest = f / square if square else f / 2
            self.waves.append(tuple(float(x) for x in (w, r_j * a, r_j * b, r_j * rest)))

    def roughly(self, t):
        return sum(c + a * math.cos(w * t) + b * math.sin(w * t) if w else a + b * t + c * t * t
                   for w, a, b, c in self.waves)

    def at(self, t):
        found = [flown(*one, t) for one in self.all]
        return [x for x, _ in found], [y for _, y in found]

    def place(self, t):
        q, v = self.at(t)
        return sum(r * x for r, x in zip(self.row, q)), sum(r * x for r, x in zip(self.row, v))


def motion(squares, b, force, k, gap, q, v, until):
    """q and q' at the instant `until`, and how often the spring was met."""
    contact = Contact(squares, b, k)
    row = contact.into(b)
    pushed = contact.into([f + k * gap * b_j for f, b_j in zip(force, b)])
    step = 1 / (4 * sqrt(contact.squares[-1]))
    t, met, closed = mpf(0), 0, False
    while True:
        if closed:
            part = Part(contact.squares, pushed, row, contact.into(q), contact.into(v))
        else:
            part = Part(squares, force, b, q, v)
        s, ended = step, False                                  # it begins at the gap, and is beyond it a step later
        while not ended and t + s < until:
            if (part.roughly(float(s)) > gap) != closed:
                ended = True
            else:
                s += step
        if not ended:
            s = until - t
        else:
            low, high = s - step, s
            for _ in range(100):                                # Newton's method, and halves where it leaves the bracket
                u, rate = part.place(s)
                low, high = (low, s) if (u > gap) != closed else (s, high)
                new = s - (u - gap) / rate
                new = new if low < new < high else (low + high) / 2
                if abs(new - s) <= step * mpf(10) ** (3 - mp.dps):
                    break
                s = new
        q, v = part.at(s)
        if closed:
            q, v = contact.back(q), contact.back(v)
        t += s
        if not ended:
            return q, v, met
        closed = not closed
        met += closed
