"""Eigenvalues of products of matrices, computed with mpmath from the formed product at 120 digits;
writes product_eigenvalues.csv.

Entries are exact doubles from a generator that the test repeats: x -> 6364136223846793005 x +
1442695040888963407 mod 2^64, entry = (x >> 11) 2^-52 - 1, column by column, factor by factor, and
each factor times the power of two 2^e, e from the list of its case, taken in turn."""

import csv
import sys

from mpmath import eig, fabs, ldexp, matrix, mp, mpf, nstr

mp.dps = 120

# case, n, k, seed, exponents
CASES = [
    ("random_2_2", 2, 2, 1, [0]),
    ("random_4_3", 4, 3, 2, [0]),
    ("random_8_8", 8, 8, 3, [0]),
    ("random_4_40", 4, 40, 4, [0]),
    ("random_16_2", 16, 2, 5, [0]),
    ("sizes_4_6", 4, 6, 6, [27, -27]),
    ("sizes_8_9", 8, 9, 7, [27, 0, -27]),
]


def factors(n, k, seed, exponents):
    x = seed
    for i in range(k):
        a = matrix(n, n)
        for column in range(n):
            for row in range(n):
                x = (6364136223846793005 * x + 1442695040888963407) % 2**64
                a[row, column] = ldexp(mpf(x >> 11) * mpf(2) ** -52 - 1, exponents[i % len(exponents)])
        yield a


def eigenvalues(n, k, seed, exponents):
    product = matrix(n, n)
    for i in range(n):
        product[i, i] = 1
    for factor in factors(n, k, seed, exponents):
        product = factor * product
    values, vectors = eig(product)
    for i, value in enumerate(values):
        x = vectors[:, i]
        defect = max(fabs(e) for e in product * x - value * x)
        if defect > mpf(10) ** -40 * fabs(value) * max(fabs(e) for e in x):
            sys.exit(f"not an eigenvalue: n = {n}, k = {k}, {nstr(value, 20)}")
    return sorted(values, key=lambda v: (-fabs(v), v.imag))


def main():
    rows = []
    for case, n, k, seed, exponents in CASES:
        for value in eigenvalues(n, k, seed, exponents):
            imaginary = value.imag if fabs(value.imag) > mpf(10) ** -60 * fabs(value) else mpf(0)
            rows.append([case, n, k, seed, " ".join(map(str, exponents)),
                         nstr(value.real, 20), nstr(imaginary, 20)])
    with open("product_eigenvalues.csv", "w", newline="", encoding="ascii") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["case", "n", "k", "seed", "exponents", "re", "im"])
        writer.writerows(rows)


if __name__ == "__main__":
    main()
