#!/usr/bin/env bash
# Draws the pictures of docs/gallery.md by the commands that stand there:
#   bash docs/gallery.sh FOLDER          all of them
#   bash docs/gallery.sh FOLDER NAME     one, basins.png
set -euo pipefail
[ $# -ge 1 ] || { echo "usage: bash docs/gallery.sh FOLDER [NAME]" >&2; exit 2; }
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
cd "$root"
[ -x build/graze ] || { echo "gallery: build/graze is not there; bash apps/demo.sh builds it" >&2; exit 2; }
found=no
while IFS= read -r line; do
  name=${line##*--plot }
  [ $# -lt 2 ] || [ "$name" = "$2" ] || continue
  found=yes
  echo "\$ $line"
  code=0
  # Quotes in the commands are the shell's.
  eval "${line%--plot *} --quiet --plot \"\$folder/$name\"" > /dev/null || code=$?
  # 3: the numerics say what they left open; the picture shows the rest.
  [ "$code" -eq 0 ] || [ "$code" -eq 3 ] || exit "$code"
done < <(sed -n 's/^    build\/graze /build\/graze /p' docs/gallery.md)
[ "$found" = yes ] || { echo "gallery: docs/gallery.md has no picture '$2'" >&2; exit 2; }
