# For the scripted tests, to be sourced: counts what holds.
passed=0 failed=0

# check WHAT COMMAND...: the command must succeed. Where it does not, shows the files stdout and stderr, if there are any.
check() {
  local what=$1; shift
  if "$@"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED: %s\n' "$what"
    sed 's/^/  | /' stdout stderr 2>/dev/null | head -20 || true
  fi
}

# Goes to a new folder, $folder, which is gone at the end.
enter_new_folder() {
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  cd "$folder" || exit 1
}
# run CODE ARGUMENT...: runs $program; its exit code must be CODE. What it prints goes to the files stdout and stderr.
run() {
  local code=$1 got=0; shift
  "$program" "$@" >stdout 2>stderr </dev/null || got=$?
  check "exit code $got, wanted $code: raylab $*" test "$got" = "$code"
}
prints() { check "standard output says: $1" grep -qF -- "$1" stdout; }
says() { check "standard error says: $1" grep -qF -- "$1" stderr; }
silent() { check 'standard error is silent' test ! -s stderr; }

# The last line of a test script: its totals, and its exit code.
report_checks() {
  printf '%d passed, %d failed\n' $passed $failed
  ((failed == 0 && passed > 0))
}
