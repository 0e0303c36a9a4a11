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
FEW_DIGITS = 8
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
        lines = run.stdout.splitlines()
        for name, value in values:
            number = decimal.Decimal(value["independent"])
            label = value.get("printed_as")
            if label is None and len(number.normalize().as_tuple().digits) < FEW_DIGITS:
                missing += 1
                print(f"{name}: {number} may be any number; say by printed_as which line of {script} it is")
            shown = [line[len(label):] if label else line for line in lines if not label or line.split()[:1] == [label]]
            printed = {decimal.Decimal(text) for line in shown for text in NUMBER.findall(line)}
            if not any(abs(number - other) <= max(last_digit(number), last_digit(other)) and
                       abs(number - other) <= abs(number) * decimal.Decimal("1e-12") for other in printed):
                missing += 1
                print(f"{name}: {script} does not print {number} ({value['what']})")
        print(f"{script}: {len(values)} numbers")
    sys.exit(1 if missing else 0)


main()
