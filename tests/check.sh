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

# The last line of a test script: its totals, and its exit code.
report_checks() {
  printf '%d passed, %d failed\n' $passed $failed
  ((failed == 0 && passed > 0))
}
