#!/usr/bin/env bash
# The Debian packages in FOLDER in a bare Debian 12, which debootstrap makes in SCRATCH (280 MB from a
# mirror): they install with their dependencies, the program runs, manual pages and completions are
# there, Python imports the module, a C++ program builds on the library, and all of it is removed again
# without a trace. lintian, where it is installed, finds no error. Needs root.
#   bash tests/packages/debian_test.sh FOLDER SCRATCH [MIRROR]
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
packages=$(realpath "$1") scratch=$(realpath -m "$2") mirror=${3:-http://deb.debian.org/debian}
failed=0
fail() { echo "$*" >&2; failed=1; }

if command -v lintian > /dev/null; then
  echo "== lintian"
  lintian --no-tag-display-limit --allow-root "$packages"/*.deb 2> /dev/null | sort | uniq > "$packages/lintian.log"
  grep '^E:' "$packages/lintian.log" && fail "lintian finds errors"
  echo "$(grep -c '^W:' "$packages/lintian.log") warnings, in $packages/lintian.log"
fi

base=$scratch/bookworm.tar system=$scratch/system
mkdir -p "$scratch"
if [ ! -e "$base" ]; then
  rm -rf "$system"
  debootstrap --variant=minbase bookworm "$system" "$mirror" > "$scratch/debootstrap.log" 2>&1 ||
    { tail -n 5 "$scratch/debootstrap.log" >&2; exit 1; }
  tar -C "$system" -cf "$base.part" . && mv "$base.part" "$base"
fi
rm -rf "$system"
mkdir -p "$system" && tar -C "$system" -xf "$base"
cp /etc/resolv.conf "$system/etc/resolv.conf" 2> /dev/null || true
mkdir "$system/packages" && cp "$packages"/*.deb "$system/packages"
cp -r "$here/../install/consumer" "$system/consumer"
mount -t proc proc "$system/proc" || exit 1
trap 'umount "$system/proc" 2> /dev/null' EXIT
inside() { chroot "$system" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive bash -c "$1"; }
inside 'apt-get update -qq'
# What is there of Graze.
files() { (cd "$system" && find usr etc var/lib/dpkg/info -path '*graze*' | sort); }

echo "== the program alone"
inside 'apt-get install -y -qq --no-install-recommends /packages/graze_*.deb' > "$scratch/install.log" 2>&1 || { tail "$scratch/install.log" >&2; fail "the program does not install"; }
inside 'graze version && cd /root && graze check /usr/share/graze/scenes/02_wagg_momentum.toml && graze orbit /usr/share/graze/scenes/05_wagg_one_mode.toml -s forcing.frequency=40' > "$scratch/program.log" 2>&1 || fail "the program does not run: $(tail -n 3 "$scratch/program.log")"
for kind in beam oscillator matrices hub; do
  inside "cd /root && graze init $kind $kind.toml && graze check $kind.toml" > /dev/null || fail "graze init $kind"
done
inside 'for scene in /usr/share/graze/scenes/*.toml; do graze check "$scene" -q > /dev/null || echo "$scene"; done' | grep . && fail "scenes do not pass"

echo "== manual pages and completions"
inside 'apt-get install -y -qq --no-install-recommends man-db bash-completion fish zsh' > "$scratch/shells.log" 2>&1 || fail "the shells do not install"
inside 'man -w graze graze-simulate && man -P cat graze-continue' | grep -q -e '--max-step' || fail "manual pages"
inside '. /usr/share/bash-completion/bash_completion && _completion_loader graze; complete -p graze' | grep -q _graze || fail "bash does not find the completion"
inside "fish -c \"complete -C 'graze simu'\"" | grep -q '^simulate' || fail "fish does not complete"
inside "fish -c \"complete -C 'graze continue /usr/share/graze/scenes/02_wagg_momentum.toml --parameter stop.g'\"" | grep -q '^stop.gap' || fail "fish does not complete parameters"
inside "zsh -f -c 'autoload -Uz compinit && compinit -u -D && print \$_comps[graze]'" | grep -q '^_graze' || fail "zsh does not find the completion"

echo "== Python"
inside 'apt-get install -y -qq --no-install-recommends /packages/python3-graze_*.deb' > "$scratch/python.log" 2>&1 || fail "the Python package does not install"
inside "python3 -c \"import graze; run = graze.simulate('/usr/share/graze/scenes/02_wagg_momentum.toml', periods=5); print(run.outcome)\"" > "$scratch/import.log" 2>&1 || fail "import graze: $(tail -n 3 "$scratch/import.log")"
grep -qx reached_end "$scratch/import.log" || fail "Python: $(cat "$scratch/import.log")"

echo "== library"
inside 'apt-get install -y -qq --no-install-recommends /packages/libgraze0_*.deb /packages/libgraze-dev_*.deb /packages/graze-doc_*.deb g++ cmake ninja-build' > "$scratch/library.log" 2>&1 || { tail "$scratch/library.log"; fail "the library does not install"; }
inside 'cmake -S /consumer -B /consumer/build -G Ninja -DCMAKE_BUILD_TYPE=Release && cmake --build /consumer/build && /consumer/build/consumer /usr/share/graze/scenes/05_wagg_one_mode.toml' > "$scratch/consumer.log" 2>&1 || { tail -n 15 "$scratch/consumer.log" >&2; fail "no program builds on the library"; }
[ -e "$system/usr/share/doc/graze-doc/docs/index.md" ] || fail "no documentation"

inside 'printf "#include <graze.h>\n#include <stdio.h>\nint main(void) { return puts(graze_version()) < 0; }\n" > /root/version.c && gcc /root/version.c -lgraze -o /root/version && /root/version' | grep -qx "$(inside 'graze version' | cut -d ' ' -f 2)" || fail "no program of C builds on the library"

echo "== removal"
inside 'apt-get purge -y -qq graze python3-graze libgraze0 libgraze-dev graze-doc' > "$scratch/removal.log" 2>&1 || fail "the packages are not removed"
left=$(files)
[ -z "$left" ] || fail "left behind: $left"
umount "$system/proc"
rm -rf "$system"
[ "$failed" -eq 0 ] && echo "the packages install, run and are removed"
exit "$failed"
