#!/usr/bin/env bash
# Installs what is missing, builds Graze, runs the main job on the beam of Wagg (2004) and leaves
# pictures and tables in demo/. From the project's root or anywhere else.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
bash apps/install_packages.sh
cmake --preset release > /dev/null
cmake --build --preset release --target graze_program
graze=build/graze
mkdir -p demo

# Runs one command of Graze and keeps its text, tables and picture. A motion that comes to rest and a
# search without an orbit end with exit code 3 and say why: here those are results.
run() {
  local name=$1 lines=$2
  shift 2
  echo
  echo "\$ graze $*"
  local code=0
  "$graze" "$@" --out "demo/$name" --plot "demo/$name/picture.png" > "demo/$name.txt" || code=$?
  head -n "$lines" "demo/$name.txt"
  [ "$(wc -l < "demo/$name.txt")" -le "$lines" ] || echo "  .. (all of it in demo/$name.txt)"
  [ "$code" -eq 0 ] || [ "$code" -eq 3 ] || exit "$code"
}

# How much of the parameter's range has a stable orbit: union of the steps between stable points.
stable_length() {
  awk -F, 'NR > 1 { if ($1 == branch && $6 == 1 && stable == 1)
                      print ($3 < value ? $3 "," value : value "," $3)
                    branch = $1; value = $3; stable = $6 }' "$1" | sort -g |
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
    "$(stable_length demo/${modes}_frequency/branches.csv)" \
    "$(stable_length demo/${modes}_gap/branches.csv)"
done
echo
echo "Pictures and tables are in $root/demo; docs/period_one.md tells what they show."
