#!/usr/bin/env bash
# What the tests of tests/hard noted (tests/support/reached.hpp): the hard cases of docs/accuracy.md, a row for
# each with the quantity that is nearest to its bound, and a file of all quantities:
#   bash tests/hard/table.sh NOTES PART ALL
set -euo pipefail
notes=$1
part=$2
all=$3
temporary=$(mktemp "$part.XXXXXX")
quantities=$(mktemp "$all.XXXXXX")
trap 'rm -f "$temporary" "$quantities"' EXIT
# A case that is not named here is told by its tag alone.
cases='Z1 ball dropped, until it rests
Z2 chatter, sticking, release
Z3 impact soon after a release
Z4 1000 ever weaker impacts, no rest
Z5 restitution 0
Z6 preloaded stop
Z7 beam held by its stop
G1 shallow contact
G2 branches into a grazing
P2 published doubling and fold
P3 fold beside a grazing
E1 energy of both impact laws
E2 elastic impacts
E3 motion reversed
E4 several stops at once
E5 contact at the start
M1 mode shapes
M2 collocation points
M3 sums over modes
M4 chatter of 32 modes
M5 resonance, critical damping
M7 long times
S1 compliant: Hertz
S2 compliant: spring and dashpot
S3 compliant: Hunt and Crossley
S4 order of steps across a contact
S5 sphere on a beam
Beam Wagg (2004), thousands of chatters'
{
  cat <<'HEAD'
Motions on which simulators of impacts go wrong without a word. Each is a test in `tests/hard`, named by its tag, against closed forms or extended precision. Shown is the quantity nearest to its bound, the worst over all parameter values; `bash tests/run.sh` leaves the others in `build/hard_cases.csv`.

|case|quantity|demanded|reached|
|---|---|---|---|
HEAD
  # The worst of all test programs; tags in the order Z G P E M S B.
  LC_ALL=C sort "$notes" | cases=$cases awk -F'\t' -v all="$quantities" '
    function digit(value) { return value == 0 ? "0" : sprintf("%.0e", value) }
    {
      key = $1 "\t" $2
      if (!(key in reached)) order[++count] = key
      if (!(key in reached) || $4 * allowed[key] > reached[key] * $3) { reached[key] = $4; allowed[key] = $3 }
    }
    END {
      lines = split(ENVIRON["cases"], line, "\n")
      for (i = 1; i <= lines; ++i) { at = index(line[i], " "); name[substr(line[i], 1, at - 1)] = substr(line[i], at) }
      print "case,quantity,demanded,reached" > all
      for (i = 1; i <= count; ++i) {
        key = order[i]
        split(key, words, "\t")
        printf "%s,\"%s\",%.2g,%s\n", words[1], words[2], allowed[key], digit(reached[key]) > all
        share = allowed[key] == 0 ? 0 : reached[key] / allowed[key]
        if (!(words[1] in nearest) || share > most[words[1]]) { nearest[words[1]] = key; most[words[1]] = share }
      }
      for (tag in nearest) {
        key = nearest[tag]
        split(key, words, "\t")
        gsub(/\|/, "\\|", words[2])
        printf "%d%s\t|%s%s|%s|%.2g|%s|\n", index("ZGPEMSB", substr(tag, 1, 1)), tag, tag, name[tag], words[2],
          allowed[key], digit(reached[key])
      }
    }' | LC_ALL=C sort | cut -f 2-
} > "$temporary"
chmod 644 "$temporary" "$quantities"
mv "$quantities" "$all"
mv "$temporary" "$part"
