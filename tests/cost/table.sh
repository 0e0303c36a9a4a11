#!/usr/bin/env bash
# Writes the page docs/cost.md from what the tests of tests/cost noted (tests/cost/noted_cost.hpp):
#   bash tests/cost/table.sh NOTES PAGE
set -euo pipefail
notes=$1
page=$2
temporary=$(mktemp "$page.XXXXXX")
trap 'rm -f "$temporary"' EXIT
rows() {
  awk -F'\t' -v kind="$1" '$1 == kind { printf "| %s | %.0f | %.0f | %.3f |\n", $2, $3, $4, $4 / $3 }' "$notes"
}
{
  cat <<'HEAD'
# What absence costs

A scene that does not name an effect does not pay for it. The tests of `tests/cost` hold Graze to that, and
`bash tests/run.sh` counts this page's numbers anew, `bash tests/update_pages.sh` puts them here. Instructions are counted by valgrind's callgrind (of one
processor's code path, so another machine may differ by some percent); they do not depend on what else the machine does.

- **Evaluations.** A scene with an effect of no size (gravity of 0, a restitution polynomial that is constant, damping ratios
  of 0) evaluates its gaps exactly as often as the scene without, and gives the same bits. Listening (samples, the energy
  book) changes neither.
- **Memory.** Once a run has begun, its arcs, impacts and samples ask for none.
- **Without a stop** nothing is looked for: no gap is evaluated.
- **Derivatives, contact forces, impacts shared among stops** are not called where nothing asks for them.

## Effects of the linear structure

They are folded into the modes when the scene is assembled. Four modes that meet no stop, 20 samples a forcing period;
instructions per forcing period (allowed: 1 % more).

| effect | without | with | ratio |
|---|---|---|---|
HEAD
  rows linear
  cat <<'MIDDLE'

## Effects that are there

The beam of `data/scenes/02_wagg_momentum.toml` with a gap of 5 mm; instructions per forcing period. Other effects make another
motion with more or fewer impacts, which is part of what they cost.

| effect | without | with | ratio |
|---|---|---|---|
MIDDLE
  rows present
} > "$temporary"
chmod 644 "$temporary"
mv "$temporary" "$page"
