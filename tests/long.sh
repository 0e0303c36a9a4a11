#!/usr/bin/env bash
# What takes too long for every test run, to be run before a release and after every larger change:
#   bash tests/long.sh
# - the commands of README.md and docs that take long, compared with the pages (tests/docs/long.sh), and the
#   pages as a site without a dead link (docs/site.sh);
# - every command of tests/results/commands.txt under the address and undefined-behaviour sanitizers;
# - the program so built against scenes, options and journals that are nearly right, FUZZ_SECONDS
#   (default 300) long;
# - a stable motion over ten million forcing periods, and loci of sticking orbits at ten places each;
# - the scripts that the independent numbers of data/validation are from, against those numbers;
# - graze-mpi with 1 to 8 ranks, and after 100 kills, against the program (tests/mpi);
# - the Python package against the program on every command of tests/results/commands.txt, its memory over
#   a thousand calls of each function, wrong arguments, and ten million rows on their way to NumPy;
# - the Debian packages in a bare Debian 12, and lintian over them (tests/packages), where this runs as root
#   and a mirror can be reached; the C interface from Octave (tests/c);
# - matrices that CalculiX (Debian's calculix-ccx) writes of its eighteen element types, against its own
#   frequencies (tests/calculix);
# - the lowest 50 modes of an elastic block with 1e5 unknowns, against 120 s and 6 GiB;
# - one command of each kind under valgrind, which sees reads of what was never written.
# About an hour on two cores; the logs are left in build/long. Exit 1 when anything was found.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
[ $# -eq 0 ] || { echo "usage: bash tests/long.sh" >&2; exit 2; }
set -e
bash apps/install_packages.sh --tests --mpi --python --deb
command -v valgrind > /dev/null || sudo -n apt-get install -y valgrind || apt-get install -y valgrind
for preset in release dev; do cmake --preset "$preset" -DGRAZE_TESTS=ON > /dev/null; done
cmake --build --preset release --target graze_program
cmake --build --preset dev --target graze_program fuzz_program
set +e
logs=$root/build/long
rm -rf "$logs"
mkdir -p "$logs"
failed=0

echo "== pages"
bash tests/docs/long.sh > "$logs/pages.log" 2>&1 || { failed=1; tail -n 20 "$logs/pages.log"; }

echo "== site"
bash docs/site.sh > "$logs/site.log" 2>&1 || { failed=1; tail -n 20 "$logs/site.log"; }

echo "== ten million periods, ten slices of loci"
{ cmake --build --preset release --target test_hard test_bifurcation &&
  GRAZE_LONG=1 build/tests/test_hard --gtest_filter=HardCases.M7LongTime &&
  GRAZE_LONG=1 build/tests/test_bifurcation --gtest_filter='Planes/*'; } \
  > "$logs/periods.log" 2>&1 || { failed=1; tail -n 20 "$logs/periods.log"; }

echo "== validation"
python3 -c 'import mpmath' 2> /dev/null || sudo -n apt-get install -y python3-mpmath || apt-get install -y python3-mpmath
python3 tests/validation/check_scripts.py || failed=1

echo "== ranks of an MPI job"
{ cmake --preset release -DGRAZE_MPI=ON && cmake --build --preset release --target graze_mpi; } \
  > "$logs/mpi.log" 2>&1
python3 tests/mpi/check_ranks.py build/graze build/graze-mpi data/scenes "$logs/mpi" 100 || failed=1

echo "== Python package"
{ cmake --preset release -DGRAZE_PYTHON=ON && cmake --build --preset release --target graze_python; } \
  > "$logs/python_build.log" 2>&1
GRAZE_LONG=1 /usr/bin/python3 -m pytest -q -p no:cacheprovider tests/python > "$logs/python.log" 2>&1 ||
  { failed=1; tail -n 40 "$logs/python.log"; }

echo "== C interface from Octave"
{ command -v mkoctfile > /dev/null || apt-get install -y --no-install-recommends octave liboctave-dev; } > "$logs/octave.log" 2>&1
cmake --build --preset release --target graze_c >> "$logs/octave.log" 2>&1
bash tests/c/octave_test.sh build "$logs/octave" >> "$logs/octave.log" 2>&1 || { failed=1; tail "$logs/octave.log"; }

echo "== Debian packages"
if [ "$(id -u)" -eq 0 ]; then
  { apt-get install -y --no-install-recommends debootstrap lintian && bash apps/packaging/make_debs.sh build "$logs/packages"; } \
    > "$logs/packages.log" 2>&1
  bash tests/packages/debian_test.sh "$logs/packages" "$logs/debian" >> "$logs/packages.log" 2>&1 || { failed=1; tail "$logs/packages.log"; }
else
  echo "left out: only root can make a bare system"
fi

echo "== matrices of CalculiX"
{ command -v ccx || sudo -n apt-get install -y calculix-ccx || apt-get install -y calculix-ccx; } > "$logs/calculix.log" 2>&1
rm -rf "$logs/calculix"
python3 tests/calculix/check_elements.py build/graze "$logs/calculix" >> "$logs/calculix.log" 2>&1 ||
  { failed=1; tail -n 20 "$logs/calculix.log"; }

echo "== modes of a solid"
{ cmake --preset release -DGRAZE_BENCH=ON && cmake --build --preset release --target solid_modes; } \
  > "$logs/bench.log" 2>&1
build/tests/bench/solid_modes || failed=1

echo "== sanitizers"
bash tests/results/write.sh build-dev/graze "$logs/sanitized" > "$logs/sanitized.log"
grep -lE 'runtime error:|Sanitizer' "$logs"/sanitized/*.messages && failed=1
# 0 and 3 are answers; anything else is none.
grep -LxE '0|3' "$logs"/sanitized/*.code | grep . && failed=1
build-dev/tests/fuzz_program "$root/build-dev/graze" "$root/data" "$logs/fuzz" 1 "${FUZZ_SECONDS:-300}" || failed=1

echo "== valgrind"
cat > "$logs/graze_watched" << END
#!/usr/bin/env bash
LD_PRELOAD="$root/build/tests/libgraze_under_valgrind.so" exec valgrind -q --error-exitcode=99 "$root/build/graze" "\$@"
END
chmod +x "$logs/graze_watched"
bash tests/results/write.sh "$logs/graze_watched" "$logs/valgrind" check_hub simulate_sphere \
  simulate_hub_momentum simulate_sensitivity orbit_one_mode orbit_beam_on_spring branch_gap sticking_gap \
  compliant_gap loci_one_mode regions_one_mode diagram_one_mode map_one_mode compare_methods fit_contact
grep -lx 99 "$logs"/valgrind/*.code && failed=1
watched() { "$logs/graze_watched" "$@" > "$logs/valgrind/last.log" 2>&1; [ $? -ne 99 ] || { failed=1; cat "$logs/valgrind/last.log"; }; }
watched cost data/scenes/06_bouncing_ball.toml --duration 1 --quiet
watched simulate data/scenes/06_bouncing_ball.toml --duration 1 --out "$logs/run" --plot "$logs/run.html" --quiet
watched simulate data/scenes/06_bouncing_ball.toml --duration 2 --resume "$logs/run" --quiet
for k in 1 2; do
  watched diagram data/scenes/04_impact_oscillator.toml --parameter forcing.frequency --from 2.6 --to 2.8 \
    --points 6 --shard "$k/2" --out "$logs/share$k" --quiet
done
watched merge "$logs/share1" "$logs/share2" --out "$logs/whole" --quiet
[ "$failed" -eq 0 ] && echo "nothing was found" || echo "something was found; the logs are in $logs" >&2
exit "$failed"
