#!/usr/bin/env bash
# The C interface from Octave: builds docs/examples/graze_octave.cc with mkoctfile in SCRATCH, and holds what
# it returns against a closed form. Needs octave and liboctave-dev.
#   bash tests/c/octave_test.sh BUILD SCRATCH
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(realpath "$1")
mkdir -p "$2"
cd "$2"
mkoctfile -I"$root/apps/c" -L"$build" -Wl,-rpath,"$build" -lgraze -o graze_run.oct "$root/docs/examples/graze_octave.cc"
cat > interface_test.m << 'END'
# A ball that falls 1.25 m on a floor: the first impact after sqrt(2 h / g), with sqrt(2 g h).
scene = ["[modal]\nfrequencies = [0.0]\ninertia = [1.0]\n[gravity]\nacceleration = 10.0\n" ...
         "[[stop]]\nshape = [1.0]\ngap = 1.25\nrestitution = 0.8\n"];
run = graze_run(scene, "simulate", "--duration", "2", "--record", "samples", "--sample-rate", "100");
assert(abs(run.events.time(1) - 0.5) < 1e-12);
assert(abs(run.events.speed(1) - 5.0) < 1e-12);
assert(strcmp(run.events.kind{1}, "impact"));
assert(numel(run.samples.time), 201);
assert(jsondecode(run.json).totals.impacts, sum(strcmp(run.events.kind, "impact")));
said = "";
try
  graze_run(scene, "simulate", "--duration", "x");
catch failure
  said = failure.message;
end_try_catch
assert(! isempty(strfind(said, "--duration: 'x' is not")));
disp("Octave has the results of the program")
END
LD_LIBRARY_PATH=$build octave-cli --norc --quiet interface_test.m
