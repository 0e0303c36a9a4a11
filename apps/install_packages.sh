#!/usr/bin/env bash
# Installs the Debian packages of packages.txt that are missing, and npm; with --tests also the browser
# and Python that only the tests need, with --mpi also what graze-mpi needs (-DGRAZE_MPI=ON), with
# --python what the Python package and its tests need (-DGRAZE_PYTHON=ON), with --deb what Debian packages
# are made with. Needs root or sudo; without either it prints the one line to run and exits 2.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

mapfile -t wanted < "$here/packages.txt"
# Of the page of --plot x.html and its tests; each is as good from anywhere else.
has() { command -v "$1" >/dev/null; }
has node || has nodejs || wanted+=(nodejs)
has npm || wanted+=(npm)
for option in "$@"; do
  case "$option" in
    --tests)
      has chromium || has google-chrome || wanted+=(chromium)
      has python3 || wanted+=(python3-minimal)
      ;;
    --mpi) wanted+=(libopenmpi-dev openmpi-bin) ;;
    --python)
      wanted+=(pybind11-dev python3-dev python3-numpy python3-matplotlib python3-pandas
               python3-pip python3-setuptools python3-venv python3-wheel python3-pytest mypy
               python3-nbclient python3-ipykernel)
      ;;
    --deb) wanted+=(dpkg-dev file) ;;
    *) echo "usage: bash apps/install_packages.sh [--tests] [--mpi] [--python] [--deb]" >&2; exit 2 ;;
  esac
done
missing=()
for package in "${wanted[@]}"; do
  state=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

line="apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
if [ "$(id -u)" -eq 0 ]; then
  run=()
elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
  run=(sudo -n)
else
  echo "Graze needs packages that only root can install. Run this once, then start again:" >&2
  echo "  sudo sh -c '$line'" >&2
  exit 2
fi
echo "Installing ${#missing[@]} Debian packages .." >&2
"${run[@]}" apt-get update -qq
"${run[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
  "${missing[@]}" >&2
