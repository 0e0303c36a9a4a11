#!/usr/bin/env bash
# The property tests at length: 10 000 random scenes, 100 000 samples per forcing period, ten periods
# each; about an hour and a half of computing, divided by the cores. From anywhere:
#   bash tests/soak.sh [SCENES [SAMPLES [JOBS]]]
# Each job draws its own scenes, from seed FIRST_SEED (default 1000) on. Logs and a summary are left
# in build/soak; exit 1 when a property failed. Then the program for FUZZ_SECONDS (default 3600)
# against scenes, options and journals that are nearly right (tests/fuzz), drawn from FIRST_SEED;
# exit 1 as well when it failed there. Between the two MIXED_CASES (default 100000) motions against
# rigid stops and springs at once are compared with an independent integration.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
scenes=${1:-10000} samples=${2:-100000} jobs=${3:-$(nproc)}
first=${FIRST_SEED:-1000}
fuzz_seconds=${FUZZ_SECONDS:-3600}
mixed_cases=${MIXED_CASES:-100000}
for number in "$scenes" "$samples" "$jobs" "$first" "$fuzz_seconds" "$mixed_cases"; do
  [[ $number =~ ^[1-9][0-9]*$ ]] || { echo "usage: bash tests/soak.sh [SCENES [SAMPLES [JOBS]]]" >&2; exit 2; }
done

cmake --preset release -DGRAZE_TESTS=ON > /dev/null
cmake --build --preset release --target test_property test_motion fuzz_program
logs=$root/build/soak
mkdir -p "$logs"
rm -f "$logs"/seed_*.log
# What is rebuilt meanwhile shall not change what runs.
cp build/tests/test_property build/tests/test_motion build/tests/fuzz_program build/graze "$logs"

each=$(((scenes + jobs - 1) / jobs))
pids=()
for ((job = 0; job < jobs; ++job)); do
  seed=$((first + job))
  GRAZE_SCENES=$each GRAZE_SAMPLES=$samples GRAZE_SEED=$seed GRAZE_PROGRESS=1 \
    nice "$logs/test_property" > "$logs/seed_$seed.log" 2>&1 &
  pids+=($!)
done
stop() { kill "${pids[@]}" 2> /dev/null || true; }
trap 'stop; exit 130' INT TERM

# The last line of each log, until all are done.
running() { for pid in "${pids[@]}"; do kill -0 "$pid" 2> /dev/null && return 0; done; return 1; }
while running; do
  sleep 10
  [ -t 2 ] && for log in "$logs"/seed_*.log; do
    printf '%s: %s\n' "$(basename "$log" .log)" "$(tail -n 1 "$log")" >&2
  done
done
failed=0
for pid in "${pids[@]}"; do wait "$pid" || failed=1; done

# The worst of each quantity and the sum of each count over all jobs.
awk '
  /^[A-Za-z]+:$/ { test = $1; if (!(test in known)) { known[test] = 1; order[++tests] = test }; next }
  test && /^    [0-9]/ {
    n = split($0, parts, ",")
    for (i = 1; i <= n; ++i) {
      value = parts[i] + 0; name = parts[i]; sub(/^ *[0-9]+ /, "", name)
      sum[test, name] += value; if (!seen[test, name]++) counts[test] = counts[test] SUBSEP name
    }
    test = ""; next
  }
  test && /^    / {
    value = $NF; name = $0; sub(/^ */, "", name); sub(/ [^ ]*$/, "", name)
    number = value == "inf" ? 1e308 : value + 0  # awks differ in what is beyond it
    if (!seen[test, name]++) { worsts[test] = worsts[test] SUBSEP name; worst[test, name] = number }
    else if (number > worst[test, name]) worst[test, name] = number
    next
  }
  { test = "" }
  END {
    for (t = 1; t <= tests; ++t) {
      test = order[t]; print test
      n = split(worsts[test], names, SUBSEP)
      for (i = 2; i <= n; ++i) printf "    %-45s %.3g\n", names[i], worst[test, names[i]]
      n = split(counts[test], names, SUBSEP)
      for (i = 2; i <= n; ++i) printf "    %-45s %d\n", names[i], sum[test, names[i]]
    }
  }' "$logs"/seed_*.log | tee "$logs/summary.txt"
grep -h -A 60 -E "Falsifiable|Failure" "$logs"/seed_*.log || true
if [ "$failed" -ne 0 ]; then echo "a property failed; the logs are in $logs" >&2; fi
GRAZE_MIXED_CASES=$mixed_cases GRAZE_SEED=$first nice "$logs/test_motion" --gtest_filter='MixedContacts.*' ||
  failed=1
rm -rf "$logs/fuzz"
"$logs/fuzz_program" "$logs/graze" "$root/data" "$logs/fuzz" "$first" "$fuzz_seconds" || failed=1
exit "$failed"
