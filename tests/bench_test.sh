#!/usr/bin/env bash
# `raylab bench` as its users meet it: a quick run, its report, an interruption, comparing.
#   tests/bench_test.sh PROGRAM CHECK      CHECK: raylab-bench-check
set -uo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
program=$(realpath "$1")
report_is_right=$(realpath "$2")
enter_new_folder
# Interrupted in the middle, it keeps what it has; the same command finishes it.
"$program" bench --quick --out run >stdout 2>stderr </dev/null &
for ((i = 0; i < 1200; i++)); do
  [[ -e run/measurements.jsonl && $(wc -l <run/measurements.jsonl) -gt 5 ]] && break
  sleep 0.1
done
kill -INT $!
wait $!
check "exit code $?, wanted 130: interrupted" test $? = 130
says 'the same command goes on from there'
check 'no report of half a run' test ! -e run/report.json
kept=$(wc -l <run/measurements.jsonl)
run 1 bench scene1 --quick --out run
says 'differs from this one in: scenes.'
check 'another run leaves it alone' test "$(wc -l <run/measurements.jsonl)" = "$kept"
run 0 bench --quick --out run
prints 'For a picture to look at: --engine fast --precision f32'
check 'the journal is gone' test ! -e run/measurements.jsonl
check 'the report is complete, its errors in bounds' "$report_is_right" run >stdout 2>stderr

# Comparing
run 0 bench --compare run/report.json run/report.json
grep -q '"sentence": "The machine was busy' run/report.json || prints ' 0 changed beyond noise'
prints 'errors and counts: 0 changed'
sed 's/"flipped": 0/"flipped": 7/' run/report.json >worse.json
run 0 bench --compare run/report.json worse.json
prints 'Errors and counts'
prints 'worse'
run 2 bench --compare run/report.json missing.json
says 'missing.json: cannot be read'
echo 'not json' >text.json
run 2 bench --compare text.json run/report.json
says 'not JSON'
echo '{}' >empty.json
run 2 bench --compare empty.json run/report.json
says 'not a report'

# Bad input
run 2 bench no_such_scene --quick --out x
says 'no_such_scene: there is no such file'
run 2 bench scene1 scene1 --quick --out x
says 'twice'
echo 'text' >file
run 1 bench scene1 --quick --out file
check 'nothing was made' test ! -e x

report_checks
