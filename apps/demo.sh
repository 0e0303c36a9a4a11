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

# Runs one command of Graze, shows it, and keeps its text beside its files. A run whose motion comes
# to rest, or that finds no orbit, ends with exit code 3 and says why: that is a result here.
show() {
  local name=$1
  shift
  echo
  echo "\$ graze $*"
  local code=0
  "$graze" "$@" --out "demo/$name" --plot "demo/$name/picture.png" > "demo/$name.txt" || code=$?
  cat "demo/$name.txt"
  [ "$code" -eq 0 ] || [ "$code" -eq 3 ] || exit "$code"
}

beam=data/scenes/05_wagg_one_mode.toml
echo "== The beam with one mode: how it moves, and its periodic impacts =="
show one_mode_motion simulate $beam --periods 40
show one_mode_orbits orbit $beam --set forcing.frequency=40
show one_mode_frequency continue $beam --parameter forcing.frequency --from 15 --to 120
show one_mode_gap continue $beam --set forcing.frequency=40 --parameter stop.gap --from 0 --to 0.02
for modes in 2 4; do
  echo
  echo "== The same with $modes modes =="
  show ${modes}_modes_orbits orbit $beam --set beam.modes=$modes --set forcing.frequency=40
  show ${modes}_modes_frequency continue $beam --set beam.modes=$modes \
    --parameter forcing.frequency --from 15 --to 120
  show ${modes}_modes_gap continue $beam --set beam.modes=$modes --set forcing.frequency=40 \
    --parameter stop.gap --from 0 --to 0.02
done
echo
echo "== The paper's own scene, and the same with the momentum law =="
show paper_motion simulate data/scenes/01_wagg_2004.toml --duration 10
show momentum_motion simulate data/scenes/02_wagg_momentum.toml --duration 10
echo
echo "Pictures and tables are in $root/demo; what they show is told in docs/period_one.md."
