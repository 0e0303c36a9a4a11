#!/usr/bin/env bash
# Runs the commands of README.md and docs that take too long for every test run (those that
# tests/docs/exceptions.txt calls long) and compares what they print with the pages. From anywhere:
#   bash tests/docs/long.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
cmake --preset release -DGRAZE_TESTS=ON > /dev/null
cmake --build --preset release --target test_docs
GRAZE_LONG_BLOCKS=1 build/tests/test_docs --gtest_filter='*Pages*'
