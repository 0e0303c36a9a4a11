#!/usr/bin/env bash
# Copies the tables that the last `bash tests/run.sh` measured, build/hard_cases.md and build/cost.md, into
# docs. From the project's root or anywhere else:
#   bash tests/update_pages.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
for page in hard_cases.md cost.md; do
  [ -f "build/$page" ] || { echo "update_pages: build/$page is not there; bash tests/run.sh makes it" >&2; exit 2; }
done
cp build/hard_cases.md build/cost.md docs/
