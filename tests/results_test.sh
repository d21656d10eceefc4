#!/usr/bin/env bash
# What other programs must be able to read of grading's reports: XML and JSON, whatever a submission wrote.
#   tests/results_test.sh RAYLAB_SAMPLE_REPORTS SOURCES
# Ends with 77, "skipped", where there is no Python to read them with.
set -euo pipefail
command -v python3 >/dev/null || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" "$2" "$folder"

python3 - "$folder" <<'PYTHON'
import csv, glob, json, sys
import xml.etree.ElementTree as xml

folder = sys.argv[1]
passed = 0

def check(what, holds):
    global passed
    if not holds:
        sys.exit(f'FAILED: {what}')
    passed += 1

suites = xml.parse(folder + '/junit.xml').getroot()
check('a suite for each submission', len(suites) == 6)
cases = suites.findall('.//testcase')
check('the counts are those of the cases', int(suites.get('tests')) == len(cases))
check('hostile text is text', any(']]> </script><script>' in (case.get('name') or '') for case in cases))

results = json.load(open(folder + '/results.json', encoding='utf-8'))
check('results.json', len(results['submissions']) == 6)
for path in glob.glob(folder + '/submissions/*/gradescope.json'):
    tests = json.load(open(path, encoding='utf-8'))['tests']
    check('Gradescope: no number is NaN', all(abs(test.get('score', 0)) < 1e9 for test in tests))

lines = list(csv.reader(open(folder + '/gradebook.csv', encoding='utf-8', newline='')))
check('a line for each submission, of one length', len(lines) == 7 and len({len(line) for line in lines}) == 1)
check('no formula', not any(cell.lstrip(' "')[:1] in set('=+-@\t\r') - {''} for line in lines for cell in line))
roster = list(csv.reader(open(folder + '/roster.csv', encoding='utf-8', newline='')))
check('the roster', roster[0] == ['id', 'name'] and len(roster) == 6)
print(f'{passed} passed, 0 failed')
PYTHON
