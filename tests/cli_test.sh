#!/usr/bin/env bash
# The program as its users meet it: commands, files, messages, exit codes, Ctrl-C.
#   tests/cli_test.sh PROGRAM SCENES_FOLDER
set -uo pipefail
program=$(realpath "$1")
scenes=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
passed=0 failed=0

ok() { passed=$((passed + 1)); }
not_ok() {
  failed=$((failed + 1))
  printf 'FAILED: %s\n' "$1"
  sed 's/^/  | /' out err 2>/dev/null | head -20
}
check() { local what=$1; shift; if "$@"; then ok; else not_ok "$what"; fi; }

# run CODE ARGUMENT...: runs the program; its exit code must be CODE. Output goes to the files out and err.
run() {
  local code=$1 got; shift
  "$program" "$@" >out 2>err </dev/null
  got=$?
  if ((got == code)); then ok; else not_ok "exit code $got, wanted $code: raylab $*"; fi
}
says() { check "standard error says: $1" grep -qF -- "$1" err; }
prints() { check "standard output says: $1" grep -qF -- "$1" out; }
no_file() { check "nothing but $2 in $1" test "$(ls -A "$1" | tr '\n' ' ')" = "$2"; }

# Rendering

run 0 render "$scenes/scene1.toml" --size 40x30
check 'the default image is out/SCENE-STAGE.png' test -s out.d/x -o -s out/scene1-ssaa.png
