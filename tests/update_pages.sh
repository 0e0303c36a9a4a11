#!/usr/bin/env bash
# Copies the tables that the last `bash tests/run.sh` measured, build/hard_cases.md and build/cost.md, into
# docs, with docs/commands.md, which the build writes, and into docs/scenes.md the rows of what results are
# described to hold. From the project's root or
# anywhere else:
#   bash tests/update_pages.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
for page in hard_cases.md cost.md; do
  [ -f "build/$page" ] || { echo "update_pages: build/$page is not there; bash tests/run.sh makes it" >&2; exit 2; }
done
cp build/hard_cases.md build/cost.md build/shell/commands.md docs/
# Below each head of a table its rows, in place of those up to the next empty line.
GRAZE_RESULTS=build/results.md build/tests/test_report --gtest_filter=ResultsReference.* > /dev/null || true
awk -v reference=build/results.md '
  BEGIN {
    while ((getline line < reference) > 0) rows[line ~ /\.csv` \|/] = rows[line ~ /\.csv` \|/] line "\n"
  }
  skipped && $0 != "" { next }
  { skipped = 0; print }
  /^\| command \| key \| meaning \|/ || /^\| file \| a row for each of \|/ {
    tables = /^\| file/
    getline; print; printf "%s", rows[tables]; skipped = 1
  }' docs/scenes.md > build/scenes.md
mv build/scenes.md docs/scenes.md
