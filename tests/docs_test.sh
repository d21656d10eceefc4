#!/usr/bin/env bash
# Every relative link in the project's pages leads somewhere, and docs/driver.md quotes the driver as it is.
#   tests/docs_test.sh SOURCE_FOLDER
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
cd "$1"

while IFS=: read -r page link; do
  [[ $link == *:* || $link == '#'* ]] && continue
  check "$page links to $link" test -e "$(dirname "$page")/${link%%#*}"
done < <(find . -name '*.md' -not -path './build/*' -not -path '*/node_modules/*' -exec grep -oHE '\]\([^) ]+\)' {} + | sed 's/](\(.*\))$/\1/')

while IFS= read -r line; do
  check "docs/driver.md quotes: $line" grep -qF -- "$line" core/render/driver.hpp
done < <(awk '/^```/ {code = /^```cpp/; next} code && NF' docs/driver.md | sed 's/^ *//')

report_checks
