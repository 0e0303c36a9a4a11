#!/usr/bin/env bash
# Writes the page docs/validation.md, and all its numbers beside it, from what the cases of tests/validation
# reached (GRAZE_VALIDATION):
#   bash tests/validation/table.sh NOTES PAGE CSV
set -euo pipefail
notes=$1
page=$2
numbers=$3
temporary=$(mktemp "$page.XXXXXX")
table=$(mktemp "$numbers.XXXXXX")
trap 'rm -f "$temporary" "$table"' EXIT
{
  cat <<'HEADER'
# Graze against published numbers

These cases were published by others: reference files and manuals of other programs, tables of papers, closed forms. Where a source gives a formula or the system alone, the number is computed apart, in a script of `tests/reference/validation` that does not use Graze. A few hard motions, with parameters drawn at random, are not published and say so.

Scenes are in `data/validation`, numbers and sources in `data/validation/published.toml`. `bash tests/validation.sh` runs every case and writes this page; `bash tests/run.sh` compares too. [validation.csv](validation.csv) has every number with its command, its full source, and a remark that says who errs.

- A printed number counts as exact to one unit of its last digit, one with all the digits of a double to 1e-13 of its size.
- Where it is less exact, or none is printed, Graze has to agree with the number computed apart to 1e-10, relative.
- Where a tolerance is another, the remark says why.

A. B. Nordmark, J. Sound Vib. 145 (1991) 279, and W. Chin, E. Ott, H. E. Nusse and C. Grebogi, Phys. Rev. E 50 (1994) 4427, print no number of a motion beside a grazing that could stand here; [hard cases](accuracy.md#hard-cases-demanded-and-reached) G follow orbits into theirs.

Columns: how many numbers the source prints and how many are computed apart, with the largest deviation of Graze from either, relative (of a 0 absolute); and the largest share used of what is allowed, in per cent. Where a printed number is off by more than its last digit, the number computed apart shows how far Graze is off, and the remark says who errs.

HEADER
  LC_ALL=C sort -u "$notes" | awk -F'\t' -v table="$table" '
    function size(x) { return x < 0 ? -x : x }
    function part(a, b) { return b == 0 ? size(a) : size(a/b) }
    function cell(text) { gsub(/"/, "\"\"", text); return "\"" text "\"" }
    BEGIN {
      print "case,source,link,scene,command,number,published,graze,relative_deviation,computed_apart,script,relative_deviation_from_it,share_of_allowed,remark" > table
    }
    substr($1, 4, 1) == "a" {
      title = $4; source = $2; link = $3; scene = $5; command = $6
      name = scene SUBSEP source
      if (!(name in of)) {
        of[name] = ++rows
        what[rows] = title; sub(/(: .*|, at .*| at [0-9.]+ s|, [0-9]+ ms after)$/, "", what[rows])
        by = source; sub(/( \(commit|: |; ).*/, "", by); from[rows] = link == "" ? by : "[" by "](" link ")"; file[rows] = scene
      }
      row = of[name]; ++cases[row]
    }
    # what, published, Graze, Graze - published, published, off what it is held to, allowed, independent, script,
    # because, "printed"
    substr($1, 4, 1) == "b" {
      off = part($5, $6); held = part($7, $9 == "" ? $6 : $9); share = $8 > 0 ? $7/$8 : 0
      if ($12 != "") { ++printed[row]; if (off > worst[row]) worst[row] = off }
      if ($9 != "") { ++apart[row]; if (held > beside[row]) beside[row] = held }
      if (share > most[row]) most[row] = share
      printf "%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%.3g,%s\n", cell(title), cell(source), cell(link), scene, cell("graze " command), cell($2),
        cell($3), $4, $12 == "" ? "" : sprintf("%.1e", off), $9, $10, $9 == "" ? "" : sprintf("%.1e", held), share, cell($11) > table
    }
    END {
      print "| what | source | printed | apart | % of allowed |"
      print "|---|---|---|---|---|"
      for (i = 1; i <= rows; ++i)
        printf "| [%s](../data/validation/%s) | %s | %s | %s | %.0f |\n", what[i], file[i], from[i],
          printed[i] ? sprintf("%d, %.0e", printed[i], worst[i]) : "-", apart[i] ? sprintf("%d, %.0e", apart[i], beside[i]) : "-", 100*most[i]
    }'
} > "$temporary"
chmod 644 "$temporary" "$table"
mv "$table" "$numbers"
mv "$temporary" "$page"
