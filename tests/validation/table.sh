#!/usr/bin/env bash
# Writes the page docs/validation.md from what the cases of tests/validation reached (GRAZE_VALIDATION):
#   bash tests/validation/table.sh NOTES PAGE
set -euo pipefail
notes=$1
page=$2
temporary=$(mktemp "$page.XXXXXX")
trap 'rm -f "$temporary"' EXIT
{
  cat <<'HEADER'
# Graze against published numbers

Nobody who writes a simulator should choose what it is checked against. The cases on this page were published by others:
reference files and manuals of other programs, tables of papers, closed forms. Some sources print numbers; others give a
formula, or the system alone, and then the number is computed apart, in a script of `tests/reference/validation` that does
not use Graze. The last cases, of hard motions, are not published at all and say so.

The scenes are in `data/validation`, the numbers with their sources in `data/validation/published.toml`.
`bash tests/validation.sh` runs every case, compares and writes this page anew; the same comparison is part of
`bash tests/run.sh`.

How close is close enough:

- A printed number counts as exact to one unit of its last digit, and one with all the digits of a double to 1e-13 of
  its size.
- Where a printed number is less exact than that, the number computed apart stands beside it. Graze then has to agree
  with that to 1e-10, relative, and the remark says who errs.
- Where a source prints no number, Graze has to agree with the number computed apart to the same 1e-10. The column of
  published numbers has the source's formula or a dash.
- Where a tolerance is another, the remark says why.

Two papers that such a page is expected to have print no number of a motion that could stand here: A. B. Nordmark, J. Sound
Vib. 145 (1991) 279, and W. Chin, E. Ott, H. E. Nusse and C. Grebogi, Phys. Rev. E 50 (1994) 4427. They derive what becomes of
a motion beside a grazing; the hard cases G of `tests/hard` follow orbits into theirs, against closed forms.

Deviations are |Graze - published|/|published|, of a published 0 |Graze|.

HEADER
  LC_ALL=C sort -u "$notes" | awk -F'\t' '
    function size(x) { return x < 0 ? -x : x }
    function part(a, b) { return b == 0 ? size(a) : size(a/b) }
    function anchor(text) {
      text = tolower(text); gsub(/[^a-z0-9 _-]/, "", text); gsub(/ /, "-", text); return text
    }
    substr($1, 4, 1) == "a" {
      ++cases; name = $2; sub(/ \(commit.*/, "", name); sub(/: .*/, "", name)
      if (!(name in first)) { first[name] = cases; names[++sources] = name }
      of[cases] = name; source[cases] = $3 == "" ? $2 : "[" $2 "](" $3 ")"; title[cases] = $4; scene[cases] = $5; command[cases] = $6
    }
    # what, published, Graze, Graze - published, published, off what it is held to, allowed, independent, script,
    # because, "printed"
    substr($1, 4, 1) == "b" {
      ++count[cases]
      off = part($5, $6); held = part($7, $9 == "" ? $6 : $9)
      if ($12 != "") { ++printed[cases]; if (off > worst[cases]) worst[cases] = off }
      if ($9 != "") { ++apart[cases]; if (held > beside[cases]) beside[cases] = held }
      if ($8 > 0 && $7/$8 > most[cases]) most[cases] = $7/$8
      remark = $9 == "" ? $11 : "Computed apart: " $9 (held == 0 ? "" : sprintf(", Graze %.0e off", held)) "." ($11 == "" ? "" : " " $11)
      rows[cases] = rows[cases] sprintf("| %s | %s | %s | %s | %s |\n", $2, $3, $4, $12 == "" ? "-" : off == 0 ? "0" : sprintf("%.1e", off), remark)
    }
    END {
      for (i = 1; i <= cases; ++i) {
        n = of[i]; ++how[n]; numbers[n] += count[i]; sum_printed[n] += printed[i]; sum_apart[n] += apart[i]
        if (worst[i] > source_worst[n]) source_worst[n] = worst[i]
        if (beside[i] > source_beside[n]) source_beside[n] = beside[i]
      }
      print "## The sources\n"
      print "The link goes to the first case of a source.\n"
      print "| source | cases | numbers | printed by the source, largest deviation | computed apart, largest deviation |"
      print "|---|---|---|---|---|"
      for (i = 1; i <= sources; ++i) {
        n = names[i]
        printf "| [%s](#%s) | %d | %d | %s | %s |\n", n, anchor(title[first[n]]), how[n], numbers[n],
          sum_printed[n] ? sprintf("%d, %.0e", sum_printed[n], source_worst[n]) : "-",
          sum_apart[n] ? sprintf("%d, %.0e", sum_apart[n], source_beside[n]) : "-"
      }
      print "\n## The cases\n"
      print "The last column has the largest deviation of a case as a share of what is allowed.\n"
      print "| case | numbers | printed by the source, largest deviation | computed apart, largest deviation | share of what is allowed |"
      print "|---|---|---|---|---|"
      for (i = 1; i <= cases; ++i)
        printf "| [%s](#%s) | %d | %s | %s | %.0f %% |\n", title[i], anchor(title[i]), count[i],
          printed[i] ? sprintf("%d, %.0e", printed[i], worst[i]) : "-", apart[i] ? sprintf("%d, %.0e", apart[i], beside[i]) : "-", 100*most[i]
      for (i = 1; i <= cases; ++i) {
        printf "\n## %s\n\nSource: %s. Scene: [%s](../data/validation/%s).\nCommand: `graze %s`.\n\n", title[i], source[i], scene[i], scene[i], command[i]
        print "| what | published | Graze | relative deviation | remark |"
        print "|---|---|---|---|---|"
        printf "%s", rows[i]
      }
    }'
} > "$temporary"
chmod 644 "$temporary"
mv "$temporary" "$page"
