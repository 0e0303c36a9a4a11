#!/usr/bin/env python3
"""Runs the scripts that the independent numbers of data/validation/published.toml are from, and looks for each number in
what its script prints, to the digits of the shorter of the two:
    python3 tests/validation/check_scripts.py
Needs mpmath. Exit 1 when a number is not printed."""

import decimal
import pathlib
import re
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def last_digit(number):
    return decimal.Decimal(1).scaleb(number.as_tuple().exponent)


def main():
    table = tomllib.loads((ROOT / "data/validation/published.toml").read_text())
    wanted = {}
    for case in table["case"]:
        for value in case["value"]:
            if "independent" in value:
                wanted.setdefault(value["script"], []).append((case["name"], value))
    missing = 0
    for script, values in sorted(wanted.items()):
        run = subprocess.run([sys.executable, ROOT / script], capture_output=True, text=True, check=True)
        printed = sorted({decimal.Decimal(number) for number in NUMBER.findall(run.stdout)})
        for name, value in values:
            number = decimal.Decimal(value["independent"])
            if not any(abs(number - other) <= max(last_digit(number), last_digit(other)) and
                       abs(number - other) <= abs(number) * decimal.Decimal("1e-12") for other in printed):
                missing += 1
                print(f"{name}: {script} does not print {number} ({value['what']})")
        print(f"{script}: {len(values)} numbers")
    sys.exit(1 if missing else 0)


main()
