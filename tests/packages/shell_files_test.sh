#!/usr/bin/env bash
# Manual pages, completions and docs/commands.md against the program that they are of:
#   bash tests/packages/shell_files_test.sh PROGRAM FOLDER SCENES
# FOLDER is where the build wrote them. What a shell completes is asked of the shell itself, where it is
# installed. Exit 1 when anything is wrong.
set -uo pipefail
program=$1 folder=$2
# A path that is longer than a terminal's line, wherever the project lies.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
scenes=$scratch/a_folder_whose_name_alone_is_longer_than_what_stands_in_one_line_of_most_terminals
ln -s "$(realpath "$3")" "$scenes"
scene=$scenes/02_wagg_momentum.toml
failed=0
fail() { echo "$*" >&2; failed=1; }
commands=$("$program" help | awk '/^Subcommands:/ { below = 1; next } /^$/ { below = 0 } below && /^  [a-z]/ { print $1 }')
[ "$(wc -w <<< "$commands")" -gt 13 ] || fail "commands: $commands"
options_of() { "$program" help "$1" | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -e '--[a-z-]+' | sort -u; }

echo "== docs/commands.md"
cmp "$folder/commands.md" "$(dirname "$0")/../../docs/commands.md" || fail "docs/commands.md is not what the options say: bash tests/update_pages.sh"
for command in $commands; do
  [ "$command" = help ] || grep -qx "## $command" "$folder/commands.md" || fail "docs/commands.md: no $command"
  for option in $(options_of "$command"); do
    [ "$option" = --help ] || grep -qF -e "\`$option" "$folder/commands.md" || fail "docs/commands.md does not name $option"
  done
done

echo "== manual pages"
for command in $commands; do
  page=$(zcat "$folder/man/graze-$command.1.gz" | sed 's/\\-/-/g; s/\\f[BIR]//g') || fail "no page of $command"
  for option in $(options_of "$command"); do
    [ "$option" = --help ] && continue
    grep -qE "^(-[a-z] ?.*, )?$option( |\$)" <<< "$page" || fail "graze-$command(1) does not name $option"
  done
  zcat "$folder/man/graze.1.gz" | grep -q "^.BR graze.-$command (1)" || fail "graze(1) does not name $command"
done
# Of graze-mpi, whose ranks share what shards share.
page=$(zcat "$folder/man_mpi/graze-mpi.1.gz" | sed 's/\\-/-/g; s/\\f[BIR]//g')
for command in $commands; do
  shared=$(options_of "$command" | grep -cx -e --shard)
  named=$(grep -cx ".BR graze-$command (1),*" <<< "$page")
  [ "$shared" = "$named" ] || fail "graze-mpi(1): $command"
done
[ "$(grep -c '^.BR graze-' <<< "$page")" = 3 ] || fail "graze-mpi(1) does not name the three commands with blocks"
if command -v man > /dev/null; then
  for page in "$folder"/man/*.gz "$folder"/man_mpi/*.gz; do
    told=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 > /dev/null)
    [ -z "$told" ] || fail "$page: $told"
  done
fi

echo "== bash"
# What the line `graze WORDS..` may go on with.
in_bash() {
  bash -c '
    source "$1"; shift
    compopt() { :; }
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
    _graze
    printf "%s\n" "${COMPREPLY[@]}"' - "$folder/graze.bash" "$program" "$@" | sort
}
same() { [ "$2" = "$3" ] || fail "$1: got '$2', not '$3'"; }
same "bash: commands" "$(in_bash "" | grep -v -e '^-')" "$(sort <<< "$commands")"
for command in $commands; do
  same "bash: options of $command" "$(in_bash "$command" --)" "$(options_of "$command" | sort)"
done
names=$("$program" check "$scene" --parameters | awk '{ print $1 }' | sort)
grep -qx stop.gap <<< "$names" || fail "check --parameters: $names"
same "bash: parameters" "$(in_bash continue "$scene" --parameter "")" "$names"
same "bash: parameters, --parameter=" "$(in_bash continue "$scene" --parameter = "")" "$names"
same "bash: settings" "$(in_bash check "$scene" -s stop.g)" "stop.gap="
same "bash: words" "$(in_bash simulate "$scene" --record "")" "$(printf 'events\nnone\nsamples')"
same "bash: kinds" "$(in_bash init "")" "$(printf 'beam\nhub\nlumped\nmatrices\noscillator')"
same "bash: scenes" "$(in_bash check "$scenes/02")" "$scene"

if command -v fish > /dev/null; then
  echo "== fish"
  in_fish() {
    PATH=$(dirname "$program"):$PATH fish --no-config -c "source '$folder/graze.fish'; complete -C '$1'" | cut -f 1 | sort
  }
  same "fish: commands" "$(in_fish 'graze ' )" "$(sort <<< "$commands")"
  same "fish: parameters" "$(in_fish "graze continue $scene --parameter ")" "$names"
  same "fish: words" "$(in_fish "graze simulate $scene --record ")" "$(printf 'events\nnone\nsamples')"
  for command in $commands; do
    same "fish: options of $command" "$(in_fish "graze $command --")" "$(options_of "$command" | sort)"
  done
fi
if command -v zsh > /dev/null; then
  echo "== zsh"
  # Its widgets work at a terminal only: what stands there once the tabulator was pressed, in one line
  # however long the scene's path is.
  in_zsh() {
    timeout 60 zsh -f -c '
      zmodload zsh/zpty
      zpty shell zsh -f -i
      zpty -w shell "stty columns 4000; PROMPT=; fpath=($2 \$fpath); PATH=$3:\$PATH; autoload -Uz compinit; compinit -u -D; unset zle_bracketed_paste; print rea\"\"dy"
      while zpty -r shell line; do [[ $line == *ready* && $line != *print* ]] && break; done
      sleep 0.5
      zpty -w -n shell "$1"$'"'\\t'"'
      for ((i = 0; i < 100; i++)); do
        while zpty -rt shell line; do all+=$line; done
        [[ $all == *"$4"* ]] && break
        sleep 0.1
      done
      print -r -- "$all"
      zpty -d shell' - "$1" "$folder" "$(dirname "$program")" "$2" 2> /dev/null | tr -d '\r\a'
  }
  shown() {
    local got
    got=$(in_zsh "$1" "$2")
    grep -qF -e "$2" <<< "$got" || fail "zsh: '$1' does not go on to '$2' but to $got"
  }
  shown "graze simu" "graze simulate"
  shown "graze simulate $scene --reco" "--record"
  shown "graze simulate $scene --record sam" "--record samples"
  shown "graze continue $scene --parameter stop.g" "--parameter stop.gap"
  shown "graze check $scene -s beam.le" "-s beam.length="
  shown "graze init mat" "graze init matrices"
  zsh -n "$folder/_graze" || fail "zsh: syntax"
  for command in $commands; do
    for option in $(options_of "$command"); do
      grep -qF -e "${option#--}" "$folder/_graze" || fail "zsh: $command has no $option"
    done
  done
fi
[ "$failed" -eq 0 ] && echo "manual pages and completions are those of the program"
exit "$failed"
