#!/usr/bin/env bash
# Builds the Debian packages of Graze into a folder:
#   bash apps/packaging/make_debs.sh [BUILD [FOLDER]]     default: build-deb, build-deb/packages
# Their maintainer is GRAZE_CONTACT, "Name <address>", where that is set.
# Needs the packages of `bash apps/install_packages.sh --python --deb`.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(realpath -m "${1:-$root/build-deb}")
folder=$(realpath -m "${2:-$build/packages}")
# An earlier configuration of the folder may have had Python's packages elsewhere.
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr \
  -DCMAKE_INSTALL_LIBDIR="lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)" \
  -DGRAZE_PYTHON=ON -DGRAZE_PYTHON_FOLDER=lib/python3/dist-packages \
  ${GRAZE_CONTACT:+"-DGRAZE_CONTACT=$GRAZE_CONTACT"} > /dev/null
targets=$(ninja -C "$build" -t targets all | grep -oE '^lib/libgraze_[a-z]+\.a' | sort -u)
# shellcheck disable=SC2086
ninja -C "$build" ${NINJA_JOBS:-} $targets graze_program graze_c graze_shell graze_changelog graze_python graze_python_package
mkdir -p "$folder"
rm -f "$folder"/*.deb
(cd "$build" && cpack -G DEB -B "$folder")
rm -rf "$folder/_CPack_Packages"
