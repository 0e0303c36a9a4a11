#!/usr/bin/env bash
# Writes the result document of every command of commands.txt into a folder, to be held against those of
# another build by compare.mjs:
#   bash tests/results/write.sh build/graze DIR [NAME..]
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
[ $# -ge 2 ] || { echo "usage: bash tests/results/write.sh PROGRAM DIR [NAME..]" >&2; exit 2; }
program=$(realpath "$1")
mkdir -p "$2"
folder=$(realpath "$2")
shift 2
cd "$here/../.."
while IFS='|' read -r name command; do
  name=${name// /}
  case "$name" in '' | '#'*) continue ;; esac
  [ $# -eq 0 ] || [[ " $* " == *" $name "* ]] || continue
  read -ra words <<< "$command"
  words=("${words[@]/#S\//data/scenes/}")
  words=("${words[@]/#M\//data/measurements/}")
  began=$EPOCHREALTIME
  "$program" "${words[@]}" --json --quiet > "$folder/$name.json" 2> "$folder/$name.messages"
  code=$?
  echo "$code" > "$folder/$name.code"
  printf '%-30s exit %d  %6.2f s\n' "$name" "$code" "$(bc -l <<< "$EPOCHREALTIME - $began")"
done < "$here/commands.txt"
