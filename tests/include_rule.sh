#!/usr/bin/env bash
# Who may include what: the one-way rule math <- scene <- image <- render <- calls <- references <- report <- submission <- explain <- results <- grade <- cli, and each library's one user.
#   tests/include_rule.sh SOURCE_FOLDER
set -euo pipefail
cd "$1"
failed=0 passed=0

# rule FILES PATTERN...: the files' quoted includes of project headers must all match one of the patterns.
rule() {
  local files=$1 allowed wrong; shift
  allowed=$(IFS='|'; echo "$*")
  # shellcheck disable=SC2086  # FILES is a glob
  ls $files >/dev/null || { failed=$((failed + 1)); return; }
  wrong=$(grep -nE '^#include "' $files | grep -vE "#include \"($allowed)" || true)
  if [[ -z $wrong ]]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED: %s may include only %s\n%s\n' "$files" "$allowed" "$wrong"
  fi
}
# only LIBRARY PLACE: no file of ours outside PLACE includes the library.
only() {
  local wrong
  wrong=$(find bench core reference stages tests -name '*.[ch]pp' | grep -vE "$2" | xargs grep -nE "^#include <$1" || true)
  if [[ -z $wrong ]]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED: only %s may include <%s\n%s\n' "$2" "$1" "$wrong"
  fi
}

rule 'core/math/*.hpp' core/math/
rule 'core/scene/*' core/math/ core/scene/
rule 'core/image/*' core/math/ core/scene/ core/image/
rule 'core/render/*' core/math/ core/scene/ core/image/ core/render/ stages/stages.hpp
rule 'core/calls/*' core/math/ core/scene/ core/image/ core/render/ core/calls/
rule 'core/references/*' core/math/ core/scene/ core/image/ core/render/ core/calls/ core/references/
rule 'core/submission/*.?pp' core/math/ core/scene/ core/image/ core/render/ core/calls/ core/submission/
rule 'core/explain/*.?pp' core/math/ core/scene/ core/image/ core/render/ core/calls/ core/report/ core/submission/ core/explain/
rule 'core/report/*.?pp' core/math/ core/scene/ core/image/ core/render/ core/calls/ core/references/ core/report/
rule 'core/results/*.?pp' core/math/ core/scene/ core/image/ core/calls/ core/report/ core/results/
rule 'core/grade/*.?pp' core/math/ core/scene/ core/image/ core/render/ core/calls/ core/submission/ core/explain/ core/results/ core/grade/
rule 'core/cli/*.?pp' core/ 'bench/report/(bench|compare).hpp' 'reference/(engine/(engine|tasks)|oracle/(oracle|tasks)).hpp' 'tests/(runner|selection|hints/hints).hpp'
rule 'bench/report/*.?pp' core/ bench/ 'reference/(engine/(engine|tasks)|oracle/(oracle|tasks)).hpp'
rule 'bench/variants/*.?pp' core/ bench/variants/
rule 'stages/*/*.?pp' core/math/ 'stages/[0-9][0-9]_'
rule 'stages/export_tasks.cpp' core/math/ stages/stages.hpp
rule 'reference/solution/*' 'stages/[0-9][0-9]_'
rule 'tests/submissions/*/*/*' core/math/ 'stages/[0-9][0-9]_'
rule 'reference/oracle/*' core/math/ core/scene/scene.hpp 'core/render/(engine|stage_table).hpp' reference/oracle/
rule 'reference/engine/*.?pp' core/math/ core/scene/scene.hpp 'core/render/(engine|stage_table).hpp' reference/engine/
rule 'reference/engine/kernel/*' reference/engine/kernel/
for folder in stages/[0-9][0-9]_*; do rule "$folder/*.?pp" core/math/ "$folder/stage.hpp"; done

only 'toml\+\+' '^core/scene/'
only OpenImageIO '^core/image/'
only CLI/ '^core/cli/'
only boost/ '^reference/oracle/'
only hwy/ '^(bench|reference/engine)/'
only glm '^(core/math|reference/solution|stages|tests/submissions)/'
only nlohmann '^(bench/report|core/(calls|cli|explain|references|report|results)|tests)/'
only catch2 '^tests/'
only '(sys/|unistd|linux/|windows|fcntl|spawn|poll|dlfcn)' '^(core/submission|tests/submissions/hostile)/'  # the one place that knows of processes

printf '%d passed, %d failed\n' $passed $failed
((failed == 0))
