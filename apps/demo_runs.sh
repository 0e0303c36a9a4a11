#!/usr/bin/env bash
# The runs of the demo, from the project's root, and a closing table of what they found:
#   bash apps/demo_runs.sh PROGRAM FOLDER
# PROGRAM is graze; FOLDER is made where it is not there and gets text, tables and pictures.
set -euo pipefail
graze=$1 folder=$2
mkdir -p "$folder"

# Runs one command of Graze and keeps its text, tables and picture. A motion that comes to rest and a
# search without an orbit end with exit code 3 and say why: here those are results.
run() {
  local name=$1 lines=$2
  shift 2
  echo
  echo "\$ graze $*"
  local code=0
  "$graze" "$@" --out "$folder/$name" --plot "$folder/$name/picture.png" > "$folder/$name.txt" || code=$?
  head -n "$lines" "$folder/$name.txt"
  [ "$(wc -l < "$folder/$name.txt")" -le "$lines" ] || echo "  .. (all of it in $folder/$name.txt)"
  [ "$code" -eq 0 ] || [ "$code" -eq 3 ] || exit "$code"
}

# How much of the parameter's range has a stable orbit: union of the steps between stable points.
# Columns are known by their names in the first line; a table that lacks one of them ends the demo.
stable_length() {
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i
                     if (column["branch"] && column["value"] && column["stable"]) next
                     print FILENAME ": no column branch, value or stable" > "/dev/stderr"; exit 1 }
           { branch = $column["branch"]; value = $column["value"]; stable = $column["stable"]
             if (branch == last_branch && stable == 1 && last_stable == 1)
               print (value < last_value ? value "," last_value : last_value "," value)
             last_branch = branch; last_value = value; last_stable = stable }' "$1" | sort -g |
    awk -F, 'NR == 1 || $1 > high { total += high - low; low = $1; high = $2; next }
             $2 > high { high = $2 } END { printf "%.4g", total + high - low }'
}

beam=data/scenes/05_wagg_one_mode.toml
echo "== The beam of the paper with one mode: motion and periodic impacts =="
run one_mode_motion 12 simulate $beam --periods 40
run one_mode_orbits 99 orbit $beam --set forcing.frequency=40
run one_mode_frequency 99 continue $beam --parameter forcing.frequency --from 15 --to 120 --max-step 0.2
run one_mode_gap 99 continue $beam --set forcing.frequency=40 \
  --parameter stop.gap --from 0 --to 0.02
for modes in 2 4; do
  echo
  echo "== The same with $modes modes =="
  run ${modes}_modes_orbits 12 orbit $beam --set beam.modes=$modes --set forcing.frequency=40
  run ${modes}_modes_frequency 12 continue $beam --set beam.modes=$modes \
    --parameter forcing.frequency --from 15 --to 120 --max-step 0.2
  run ${modes}_modes_gap 12 continue $beam --set beam.modes=$modes --set forcing.frequency=40 \
    --parameter stop.gap --from 0 --to 0.02
done
echo
echo "== The paper's own scene, and the same with the momentum law =="
run paper_motion 12 simulate data/scenes/01_wagg_2004.toml --duration 10
run momentum_motion 12 simulate data/scenes/02_wagg_momentum.toml --duration 10

echo
echo "What is left of the stable period-1 impact, of 105 rad/s and of 20 mm:"
echo "  modes   over frequency (rad/s)   over gap at 40 rad/s (m)"
for modes in one_mode 2_modes 4_modes; do
  printf '  %-8s %21s   %24s\n' "${modes%%_*}" \
    "$(stable_length $folder/${modes}_frequency/branches.csv)" \
    "$(stable_length $folder/${modes}_gap/branches.csv)"
done
echo
echo "Pictures and tables are in $(realpath "$folder"); docs/period_one.md tells what they show."
