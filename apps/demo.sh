#!/usr/bin/env bash
# Installs what is missing, builds Graze, runs the main job on the beam of Wagg (2004) and leaves
# pictures and tables in demo/. From the project's root or anywhere else.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
bash apps/install_packages.sh
cmake --preset release > /dev/null
cmake --build --preset release --target graze_program
bash apps/demo_runs.sh build/graze demo
