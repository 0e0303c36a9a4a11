#!/usr/bin/env bash
# Writes what effects cost for docs/accuracy.md from what the tests of tests/cost noted (tests/cost/noted_cost.hpp):
#   bash tests/cost/table.sh NOTES PART
set -euo pipefail
notes=$1
part=$2
temporary=$(mktemp "$part.XXXXXX")
trap 'rm -f "$temporary"' EXIT
rows() {
  awk -F'\t' -v kind="$1" -v of="$2" '$1 == kind { printf "|%s%s|%.0f|%.0f|%.3f|\n", of, $2, $3, $4, $4 / $3 }' "$notes"
}
{
  cat <<'HEAD'
An effect of no size (gravity of 0, damping ratios of 0, a constant restitution polynomial) takes exactly the evaluations of a scene without it and gives the same bits; samples and the energy book change neither. Arcs, impacts and samples allocate no memory once a run has begun. Without a stop no gap is evaluated. Derivatives, contact forces and impacts shared among stops are not computed where nothing asks for them.

`tests/cost` counts instructions per forcing period by valgrind's callgrind, of one processor's code path (others differ by some percent): of four modes that meet no stop (1 % more is allowed), and of the beam of scene 02 with a gap of 5 mm, whose number of impacts an effect may change too.

|effect|without|with|ratio|
|---|---|---|---|
HEAD
  rows linear "no stop, "
  rows present "beam, "
} > "$temporary"
chmod 644 "$temporary"
mv "$temporary" "$part"
