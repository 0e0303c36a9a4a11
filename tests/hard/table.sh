#!/usr/bin/env bash
# Writes the page docs/hard_cases.md from what the tests of tests/hard noted (tests/support/reached.hpp):
#   bash tests/hard/table.sh NOTES PAGE
set -euo pipefail
notes=$1
page=$2
temporary=$(mktemp "$page.XXXXXX")
trap 'rm -f "$temporary"' EXIT
{
  cat <<'HEAD'
# Hard cases: reached against demanded

Motions on which simulators of impacts go wrong without a word: they miss a shallow contact, fall through a stop at the end
of a chatter, take slow impacts for rest, leave a stop and find it again at once. Each row is a test in `tests/hard`, named by
its tag; the expected values are closed forms or computed apart in extended precision (stated at each test).
`bash tests/run.sh` measures this table anew in the optimised build, `bash tests/update_pages.sh` puts it here. "reached" is the worst over all parameter
values of the row.

Z: chatter, sticking, release. G: grazing. P: periodic orbits. E: energy, several stops, contact at the start. M: modes and long times.
S: stops that give way. Beam: the
cantilever of D. J. Wagg, J. Sound Vib. 276 (2004), through thousands of chatters, under both impulse laws.

| tag | case | demanded | reached |
|---|---|---|---|
HEAD
  # One line a row: the worst of all test programs; tags in the order above.
  awk -F'\t' '{
      key = $1 "\t" $2
      if (!(key in reached) || $4 * allowed[key] > reached[key] * $3) { reached[key] = $4; allowed[key] = $3 }
    }
    END {
      for (key in reached) {
        split(key, part, "\t")
        gsub(/\|/, "\\|", part[2])
        worst = reached[key] == 0 ? "0" : sprintf("%.0e", reached[key])
        printf "%d%s\t| %s | %s | %.2g | %s |\n", index("ZGPEMSB", substr(key, 1, 1)), part[1] part[2], part[1], part[2], allowed[key], worst
      }
    }' "$notes" | LC_ALL=C sort | cut -f 2-
} > "$temporary"
chmod 644 "$temporary"
mv "$temporary" "$page"
