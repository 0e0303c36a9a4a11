#!/usr/bin/env bash
# Runs Graze against the published numbers of data/validation and writes docs/validation.md, which says how
# far Graze is from them, and docs/validation.csv with each of them. From the project's root or anywhere else:
#   bash tests/validation.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
cmake --preset release -DGRAZE_TESTS=ON > /dev/null
cmake --build --preset release --target test_validation
GRAZE_VALIDATION=$(mktemp)
export GRAZE_VALIDATION
trap 'rm -f "$GRAZE_VALIDATION"' EXIT
build/tests/test_validation --gtest_brief=1 --gtest_filter="Cases/*"
bash tests/validation/table.sh "$GRAZE_VALIDATION" docs/validation.md docs/validation.csv
echo "docs/validation.md and docs/validation.csv are written"
