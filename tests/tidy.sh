#!/usr/bin/env bash
# Reads the sources of lib and apps with the checks of .clang-tidy; exit 1 where one finds something.
# From the project's root or anywhere else:
#   bash tests/tidy.sh           all of lib and apps: about 12 minutes of computing, divided by the cores
#   bash tests/tidy.sh FILE..    these
# Needs clang-tidy 14 or newer (apt-get install clang-tidy), which nothing else here does.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
files=()
for file in "$@"; do files+=("$(realpath "$file")"); done
cd "$root"
command -v clang-tidy > /dev/null || { echo "clang-tidy is missing: apt-get install clang-tidy" >&2; exit 2; }

# Nothing is built there: it tells how each file is compiled, without the precompiled headers of g++,
# which clang cannot read.
cmake --preset release -B build-tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON > /dev/null
if [ ${#files[@]} -eq 0 ]; then
  mapfile -t files < <(find "$root/lib" "$root/apps" -name '*.cpp' | sort)
fi
if printf '%s\0' "${files[@]}" |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build-tidy --quiet --warnings-as-errors='*' \
        2> >(grep -v ' warnings\? generated\.$' >&2); then
  echo "${#files[@]} files, nothing found"
else
  echo "clang-tidy found something" >&2
  exit 1
fi
