#!/usr/bin/env bash
# Installs what is missing, builds Graze, runs all tests. From the project's root or anywhere else:
#   bash tests/run.sh            optimised build, all tests; leaves what they measured as build/hard_cases.md
#                                and build/cost.md, which `bash tests/update_pages.sh` puts into docs, and all
#                                of the hard cases as build/hard_cases.csv;
#                                then the program for a minute against scenes, options and journals
#                                that are nearly right (tests/fuzz)
#   bash tests/run.sh --dev      the same with address and undefined-behaviour sanitizers
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
preset=release
case "${1:-}" in
  "") ;;
  --dev) preset=dev ;;
  *) echo "usage: bash tests/run.sh [--dev]" >&2; exit 2 ;;
esac
bash apps/install_packages.sh --tests
cmake --preset "$preset" -DGRAZE_TESTS=ON > /dev/null
cmake --build --preset "$preset"
GRAZE_HARD_CASES=$(mktemp)
GRAZE_COSTS=$(mktemp)
export GRAZE_HARD_CASES GRAZE_COSTS
trap 'rm -f "$GRAZE_HARD_CASES" "$GRAZE_COSTS"' EXIT
ctest --preset "$preset" --label-exclude python --parallel "$(nproc)"
build=$root/build
[ "$preset" = release ] || build=$root/build-dev
rm -rf "$build/fuzz"
"$build/tests/fuzz_program" "$build/graze" "$root/data" "$build/fuzz" 1 60
if [ "$preset" = release ]; then
  bash tests/hard/table.sh "$GRAZE_HARD_CASES" build/hard_cases.md build/hard_cases.csv
  bash tests/cost/table.sh "$GRAZE_COSTS" build/cost.md
fi
