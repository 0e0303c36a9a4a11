#!/usr/bin/env python3
"""Frequencies of the unit cantilever pinned at one point, within its first N modes; writes constrained_frequencies.csv.

Unit length, mass and bending stiffness: w_j = b_j^2. Pinned at x the N modes keep N - 1 frequencies, the roots of

    sum over j of  phi_j(x)^2 / (w_j^2 - w^2) = 0,

one between each two neighbours w_j. For N without end and the pin at the tip they become b^2 with tan b = tanh b.
"""
import csv
import pathlib
import sys

from mpmath import mp, mpf

from modal_system import dot, mode_shape, real, wave_number

HERE = pathlib.Path(__file__).resolve().parent
DIGITS = 25
LISTED = 6


def roots(squares, weights, count):
    """The first `count` roots w^2 of  sum weights/(squares - w^2), which grows between any two of the squares."""
    found = []
    for lo, hi in zip(squares[:count], squares[1:]):
        left, right = lo, hi
        while right - left > mp.eps * 4 * hi:
            mid = (left + right) / 2
            if sum(c / (s - mid) for c, s in zip(weights, squares)) < 0:
                left = mid
            else:
                right = mid
        found.append((left + right) / 2)
    return found


def by_projection(squares, row):
    """The same as eigenvalues of the stiffness in an orthonormal basis of the constraint (Householder)."""
    n = len(row)
    size = mp.sqrt(dot(row, row))
    mirror = [x / size for x in row]                          # I - 2 m m^T sends row to a multiple of the first axis
    mirror[0] += mp.sign(mirror[0])
    norm = mp.sqrt(dot(mirror, mirror))
    mirror = [x / norm for x in mirror]
    turn = [[(mpf(1) if i == j else mpf(0)) - 2 * mirror[i] * mirror[j] for j in range(n)] for i in range(n)]
    stiffness = mp.matrix(n - 1)
    for i in range(1, n):
        for j in range(1, n):
            stiffness[i - 1, j - 1] = sum(turn[i][k] * squares[k] * turn[j][k] for k in range(n))
    return sorted(mp.eigsy(stiffness, eigvals_only=True))


def clamped_pinned(k):
    """k-th positive root of tan b = tanh b."""
    b = (4 * k + 1) * mp.pi / 4
    return mp.findroot(lambda x: mp.sin(x) - mp.tanh(x) * mp.cos(x), b)


def main():
    mp.dps = 50
    rows = []
    exact = [clamped_pinned(k) for k in range(1, LISTED + 1)]
    # Known digits, and the errors of truncation known for the first root b.
    good = abs(exact[0] - mpf('3.92660231204791878')) < mpf('5e-18')
    truncation = {5: '7.836e-4', 10: '9.931e-5', 20: '1.246e-5'}
    for position, count in (('1', 5), ('1', 10), ('1', 20), ('0.7', 6)):
        squares = [wave_number(j) ** 4 for j in range(1, count + 1)]
        row = [mode_shape(j, real(position))[0] for j in range(1, count + 1)]
        found = roots(squares, [x ** 2 for x in row], LISTED)
        error = max(abs(x / y - 1) for x, y in zip(found, by_projection(squares, row)))
        print(f"pin at {position}, N = {count}: {len(found)} roots; eigenvalues differ by {mp.nstr(error, 2)}")
        good &= error < mpf('1e-35')
        rows += [(position, count, k, mp.sqrt(x)) for k, x in enumerate(found, 1)]
        if position == '1':
            excess = mp.root(found[0], 4) / exact[0] - 1
            print(f"   first b above its limit by {mp.nstr(excess, 5)}")
            good &= abs(excess / mpf(truncation[count]) - 1) < mpf('5e-4')
    rows += [('1', 'inf', k, b ** 2) for k, b in enumerate(exact, 1)]
    if not good:
        sys.exit("a check failed")
    with open(HERE / 'constrained_frequencies.csv', 'w', newline='') as file:
        writer = csv.writer(file, lineterminator='\n')
        writer.writerow(['position', 'N', 'k', 'frequency'])
        writer.writerows((position, n, k, mp.nstr(w, DIGITS)) for position, n, k, w in rows)


if __name__ == '__main__':
    main()
