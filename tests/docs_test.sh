#!/usr/bin/env bash
# Every relative link in the project's pages leads somewhere, the pages that a workspace gets link only to what it has too, and
# docs/driver.md quotes the driver as it is, and all of it.
#   tests/docs_test.sh SOURCE_FOLDER
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
cd "$1"

while IFS=: read -r page link; do
  [[ $link == *:* || $link == '#'* ]] && continue
  check "$page links to $link" test -e "$(dirname "$page")/${link%%#*}"
done < <(find . -name '*.md' -not -path './build/*' -not -path '*/node_modules/*' -exec grep -oHE '\]\([^) ]+\)' {} + | sed 's/](\(.*\))$/\1/')

# The handbook: what `raylab new` copies, with the scenes and the references beside it.
in_handbook() {
  [[ $1 =~ ^(stages/([^/]+/)?README\.md|stages/[^/]+/stage\.hpp|stages/figures/.*|docs/(driver|glossary|errata|model|tolerance)\.md|(scenes|reference/renders)(/.*)?)$ ]]
}
while IFS=: read -r page link; do
  [[ $link == *:* || $link == '#'* ]] && continue
  target=$(realpath -m --relative-to=. "$(dirname "$page")/${link%%#*}")
  check "$page links to $link, which a workspace has" in_handbook "$target"
done < <(grep -oHE '\]\([^) ]+\)' stages/README.md stages/*/README.md docs/{driver,glossary,errata,model,tolerance}.md | sed 's/](\(.*\))$/\1/')

while IFS= read -r line; do
  check "docs/driver.md quotes: $line" grep -qF -- "$line" core/render/driver.hpp
done < <(awk '/^```/ {code = /^```cpp/; next} code && NF' docs/driver.md | sed 's/^ *//')

while IFS= read -r line; do
  check "docs/driver.md leaves out: $line" grep -qF -- "$line" docs/driver.md
done < <(sed -n '/^template/,$p' core/render/driver.hpp | sed 's/^ *//; /^\/\/ /d; /^$/d; /^}  \/\/ namespace/d')

report_checks
