#!/usr/bin/env bash
# Builds the Debian packages of Graze into a folder, from a release build, of which nothing is compiled again
# that is there:
#   bash apps/packaging/make_debs.sh [BUILD [FOLDER]]     default: build, build/packages
# Their maintainer is GRAZE_CONTACT, "Name <address>", where that is set.
# Needs the packages of `bash apps/install_packages.sh --python --deb`.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(realpath -m "${1:-$root/build}")
folder=$(realpath -m "${2:-$build/packages}")
cache=$build/CMakeCache.txt
if [ -e "$cache" ]; then
  kind=$(sed -n 's/^CMAKE_BUILD_TYPE:[A-Z]*=//p' "$cache")
  [ "$kind" = Release ] || { echo "$build is a build of type '$kind'; packages are made of a Release" >&2; exit 2; }
  # Where the packages have their files is asked for here alone; afterwards the build is as it was.
  before=()
  for name in CMAKE_INSTALL_PREFIX CMAKE_INSTALL_LIBDIR GRAZE_PYTHON GRAZE_PYTHON_FOLDER GRAZE_CONTACT; do
    if line=$(grep "^$name:" "$cache"); then before+=("-D$line"); else before+=("-U$name"); fi
  done
  trap 'cmake -S "$root" -B "$build" "${before[@]}" > /dev/null' EXIT
fi
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
  -DCMAKE_INSTALL_LIBDIR="lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)" \
  -DGRAZE_PYTHON=ON -DGRAZE_PYTHON_FOLDER=lib/python3/dist-packages \
  ${GRAZE_CONTACT:+"-DGRAZE_CONTACT=$GRAZE_CONTACT"} > /dev/null
targets=$(ninja -C "$build" -t targets all | grep -oE '^lib/libgraze_[a-z]+\.a' | sort -u)
# shellcheck disable=SC2086
ninja -C "$build" ${NINJA_JOBS:-} $targets graze_program graze_c graze_shell graze_changelog graze_python graze_python_package graze_python_stub
mkdir -p "$folder"
rm -f "$folder"/*.deb
(cd "$build" && cpack -G DEB -B "$folder")
rm -rf "$folder/_CPack_Packages"
