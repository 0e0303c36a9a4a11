#!/usr/bin/env python3
"""Clamped-free mode shapes at unit length and mass: roots, values, slopes and curvatures to 25 and 20 digits.

phi_j(xi) = cosh(b xi) - cos(b xi) - s (sinh(b xi) - sin(b xi)),  s = (cosh b + cos b)/(sinh b + sin b),  |phi_j(1)| = 2.
The textbook form cancels exp(b) against exp(b); it is evaluated here with as many more digits as that costs.

    python3 mode_shapes.py        writes mode_shapes.csv
"""
import csv
import pathlib

from mpmath import mp, mpf

from modal_system import mode_shape, wave_number

HERE = pathlib.Path(__file__).resolve().parent
PLACES = {'1': mpf(1), '1/2': mpf(0.5), '2/3': mpf(2.0 / 3)}      # 2/3: the double nearest
MODES = (1, 2, 5, 13, 50, 400)


def main():
    rows = []
    for j in MODES:
        b = wave_number(j)
        row = [str(j), mp.nstr(b, 25, strip_zeros=False)]
        for xi in PLACES.values():
            phi, slope, curvature = mode_shape(j, xi)
            if abs(curvature) < mpf('1e-35'):                    # at the free end
                curvature = mpf(0)
            row += [mp.nstr(value, 20) for value in (phi, slope, curvature)]
        tip = mode_shape(j, mpf(1))[0]
        if abs(tip - 2 * (-1) ** (j + 1)) > mpf('1e-40') or abs(mp.cos(b) + mp.sech(b)) > mpf('1e-40') * b:
            raise ArithmeticError(f"mode {j}: phi(1) = {mp.nstr(tip, 20)}")
        rows.append(row)
        print(f"mode {j:3}: b = {row[1]}, phi(1) = {row[2]}, phi(1/2) = {row[5]}, phi(2/3) = {row[8]}")
    header = ['j', 'b'] + [f'{what}_{place}' for place in ('1', '0.5', '0.6667') for what in ('phi', 'slope', 'curvature')]
    with open(HERE / 'mode_shapes.csv', 'w', newline='') as file:
        csv.writer(file, lineterminator='\n').writerows([header] + rows)


if __name__ == '__main__':
    main()
