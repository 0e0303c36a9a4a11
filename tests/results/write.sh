#!/usr/bin/env bash
# Writes all that every command of commands.txt tells into a folder, to be held against that of another build
# by compare_results.mjs: NAME.json, the document; NAME/, the tables, pictures' scripts for gnuplot and the
# data of the page:
#   bash tests/results/write.sh build/graze DIR [NAME..]
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
[ $# -ge 2 ] || { echo "usage: bash tests/results/write.sh PROGRAM DIR [NAME..]" >&2; exit 2; }
program=$(realpath "$1")
mkdir -p "$2"
folder=$(realpath "$2")
shift 2
cd "$here/../.."
# In place of gnuplot: its script is what is compared, and stands beside the picture.
tools=$(mktemp -d)
trap 'rm -rf "$tools"' EXIT
printf '#!/bin/sh\necho drawn\n' > "$tools/gnuplot"
chmod +x "$tools/gnuplot"
while IFS='|' read -r name command; do
  name=${name// /}
  case "$name" in '' | '#'*) continue ;; esac
  [ $# -eq 0 ] || [[ " $* " == *" $name "* ]] || continue
  read -ra words <<< "$command"
  words=("${words[@]/#S\//data/scenes/}")
  words=("${words[@]/#M\//data/measurements/}")
  began=$EPOCHREALTIME
  rm -rf "$folder/$name"
  PATH=$tools:$PATH "$program" "${words[@]}" --json --quiet \
    --out "$folder/$name" --plot "$folder/$name/picture.svg" > "$folder/$name.json" 2> "$folder/$name.messages"
  code=$?
  [ $code -ne 2 ] || sed 's/^/    /' "$folder/$name.messages"
  echo "$code" > "$folder/$name.code"
  if [ -d "$folder/$name" ]; then
    "$program" view "$folder/$name" --plot "$folder/$name/page.html" > "$folder/$name/printed.txt" 2> /dev/null
    # Of the page its data, a line each, wherever it was made; nothing of the files that only repeat others.
    [ ! -f "$folder/$name/page.html" ] || grep -a '^<script type="application/json"' "$folder/$name/page.html" |
      sed "s#$folder/##g" > "$folder/$name/page.data"
    rm -f "$folder/$name"/{page.html,result.json,record.json,scene.toml,picture.svg,*.journal}
  fi
  printf '%-30s exit %d  %6.2f s\n' "$name" "$code" "$(bc -l <<< "$EPOCHREALTIME - $began")"
done < "$here/commands.txt"
