#!/usr/bin/env bash
# Puts the tables that the last `bash tests/run.sh` measured, build/hard_cases.md and build/cost.md, into
# docs/accuracy.md, copies docs/commands.md, which the build writes, and puts into docs/results.md the rows of
# what results are described to hold. From the project's root or
# anywhere else:
#   bash tests/update_pages.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
for part in hard_cases cost; do
  [ -f "build/$part.md" ] || { echo "update_pages: build/$part.md is not there; bash tests/run.sh makes it" >&2; exit 2; }
done
# Each between its two comments.
for part in hard_cases cost; do
  awk -v part="$part" '
    $0 == "<!-- end of " part " -->" { ++ends; inside = 0 }
    !inside { print }
    $0 == "<!-- " part ": written by tests/update_pages.sh -->" {
      ++begins; inside = 1
      print ""
      while ((getline line < ("build/" part ".md")) > 0) print line
      print ""
    }
    END { exit !(begins == 1 && ends == 1 && !inside) }' docs/accuracy.md > build/accuracy.md ||
    { echo "update_pages: docs/accuracy.md has not the two comments of $part" >&2; exit 2; }
  mv build/accuracy.md docs/accuracy.md
done
cp build/shell/commands.md docs/
# Below each head of a table its rows, in place of those up to the next empty line.
GRAZE_RESULTS=build/results.md build/tests/test_report --gtest_filter=ResultsReference.* > /dev/null || true
awk -v reference=build/results.md '
  BEGIN {
    while ((getline line < reference) > 0) rows[line ~ /\.csv`\|/] = rows[line ~ /\.csv`\|/] line "\n"
  }
  skipped && $0 != "" { next }
  { skipped = 0; print }
  /^\|command\|key\|meaning\|/ || /^\|file\|a row for each of\|/ {
    tables = /^\|file/
    getline; print; printf "%s", rows[tables]; skipped = 1
  }' docs/results.md > build/new_results.md
mv build/new_results.md docs/results.md
