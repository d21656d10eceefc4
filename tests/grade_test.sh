#!/usr/bin/env bash
# Grades a class of hostile, broken and right submissions, and looks at the verdicts and at what is left behind.
#   tests/grade_test.sh RAYLAB SOURCE_FOLDER
set -uo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
program=$(realpath "$1")
source=$(realpath "$2")
enter_new_folder
class=$folder/class out=$folder/out
solution=$source/reference/solution

# Each hostile file says first what must become of task 5.1, or of all tasks of its stage: "// all crashed: ...".
hostile() {
  local file=$1 into=$class/$2 edit='s/^  return d - 2 \*/  attack();\n&/'
  mkdir -p "$into"
  grep -q 'attack()' "$file" || edit='s/^  return d - 2 \*.*/  return ::answer(d, n);/'
  { cat "$file"; sed "$edit" "$solution/05_reflections.cpp"; } >"$into/05_reflections.cpp"
}
result_of() { printf '%s/submissions/%s/result.json' "$out" "$(printf 'test\n%s' "$1" | sha1sum | cut -c1-12)"; }
verdict() { # FOLDER LABEL
  grep -o "\"label\":\"$2\",\"name\":\"[a-z_0-9]*\",\"verdict\":\"[a-z_]*\"" "$(result_of "$1")" | sed 's/.*:"\(.*\)"/\1/'
}
expect() { # FOLDER LABEL VERDICT
  local got
  got=$(verdict "$1" "$2")
  check "$1: $2 is $got, wanted $3" test "$got" = "$3"
}

for file in "$source"/tests/submissions/hostile/*.cpp; do hostile "$file" "$(basename "$file" .cpp)"; done
mkdir -p "$class"/{good,nothing,link,pipe,folder,huge,bytes,nasty-error}
cp "$solution"/*.cpp "$class/good"
ln -s /etc/passwd "$class/link/01_rays.cpp"
mkfifo "$class/pipe/01_rays.cpp"
mkdir "$class/folder/01_rays.cpp"
head -c 100000000 /dev/zero >"$class/huge/01_rays.cpp"
head -c 10000 /dev/urandom >"$class/bytes/01_rays.cpp"
printf '#error \033[31m]]></script>\xff=HYPERLINK("x")\n' >"$class/nasty-error/01_rays.cpp"
odd=$class/$'=HYPERLINK("x")\n<script>\033[31m'
mkdir "$odd" && cp "$solution/01_rays.cpp" "$odd"

printf '[limits]\ncall = 0.5\n' >grading.toml
mkdir tmp && chmod 711 . && export TMPDIR=$folder/tmp XDG_CACHE_HOME=$folder/cache  # where the sandbox's user can look
run 0 grade "$class" --out "$out" --seed test --config grading.toml

for file in "$source"/tests/submissions/hostile/*.cpp; do
  name=$(basename "$file" .cpp) wanted=$(sed -n '1s|^// \(.*\): .*|\1|p' "$file")
  expect "$name" 5.1 "${wanted#all }"
  if [[ $wanted == all* ]]; then expect "$name" 5.3 "${wanted#all }"; else expect "$name" 5.3 right; fi
done
for name in link pipe folder huge; do expect $name 1.1 refused; done
for name in bytes nasty-error; do expect $name 1.1 does_not_compile; done
expect nothing 1.1 not_written
for label in 1.1 2.4 3.6 4.1 5.2 6.3 7.2; do expect good $label right; done
check 'the good solution has all points' grep -q '"points":{"got":100.0,"most":100.0},"bonus":{"got":30.0,"most":30.0}' "$(result_of good)"
check 'nothing went wrong on this side' bash -c "! grep -l infrastructure '$out'/submissions/*/result.json"
check 'no process is left' bash -c "! pgrep -f '[r]aylab-[a-z]* .*$folder'"
check 'no file is left' test -z "$(ls -A tmp)"
check 'results are private' test "$(stat -c %a "$out")" = 700
check 'no escape sequence in any result' bash -c "! grep -lP '\\x1b' '$out'/results.json"

report_checks
