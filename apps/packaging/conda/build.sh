#!/usr/bin/env bash
# What conda-build runs; see meta.yaml. Untested.
set -euo pipefail
cmake -S . -B build-conda -G Ninja ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$PREFIX" \
  -DGRAZE_PYTHON=ON -DGRAZE_PYTHON_INTERPRETER="$PYTHON" -DGRAZE_PYTHON_FOLDER="${SP_DIR#"$PREFIX"/}"
cmake --build build-conda
cmake --install build-conda
