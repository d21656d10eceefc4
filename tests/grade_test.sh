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
id_of() { printf 'test\n%s' "$1" | sha1sum | cut -c1-12; }
result_of() { printf '%s/submissions/%s/result.json' "$out" "$(id_of "$1")"; }
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
mkdir "$class/seed" && cp "$solution/01_rays.cpp" "$class/seed" && echo x >"$class/seed/seed.txt"
mkdir "$class/closed" && cp "$solution/01_rays.cpp" "$class/closed" && chmod 000 "$class/closed"  # but root may
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
expect seed 1.1 right
[[ $(id -u) == 0 ]] || expect closed 1.1 refused
chmod 700 "$class/closed"
for label in 1.1 2.4 3.6 4.1 5.2 6.3 7.2; do expect good $label right; done
check 'the good solution has all points' grep -q '"points":{"got":100.0,"most":100.0},"bonus":{"got":30.0,"most":30.0}' "$(result_of good)"
check 'nothing went wrong on this side' bash -c "! grep -l infrastructure '$out'/submissions/*/result.json"
check 'no process is left' bash -c "! pgrep -f '[r]aylab-[a-z]* .*$folder'"
check 'no file is left' test -z "$(ls -A tmp)"
check 'no name of a temporary file in any result' bash -c "! grep -l '$folder/tmp' '$out'/submissions/*/result.json"
check 'no result is long' test -z "$(find "$out/submissions" -name result.json -size +200k)"
check 'results are private' test "$(stat -c %a "$out")" = 700
check 'no escape sequence in any result' bash -c "! grep -qF '\\u001b' '$out/results.json'"


# A class of four: reports, going on, parts that are merged.
mkdir small && cp -r "$class/good" small/ada-lovelace && cp -r "$class/answers_nan" small/bob && cp -r "$class/nothing" small/cy && cp -r "$class/counter" small/dee
run 0 grade small --out whole --seed test --config grading.toml
prints 'ada-lovelace: 100 of 100, bonus 30 of 30'
for file in index.html results.json gradebook.csv junit.xml roster.csv; do check "there is $file" test -s whole/$file; done
check 'the gradebook has names and marks' grep -q ',ada-lovelace,100,100,30,30,' whole/gradebook.csv
ada=$(id_of ada-lovelace) bob=$(id_of bob)
check 'a page for each student' test -s "whole/submissions/$ada/report.html"
check 'nobody else on it' bash -c "! grep -qE 'lovelace|$ada' whole/submissions/$bob/report.html"

mkdir before && cp whole/{results.json,gradebook.csv,junit.xml,roster.csv} before
run 0 grade small --out whole --config grading.toml
says '4 of 4 submissions are graded already'
check 'the same again' cmp -s whole/results.json before/results.json
rm "whole/submissions/$bob/result.json"
run 0 grade small --out whole --config grading.toml
says '3 of 4 submissions are graded already'
check 'the same after an interruption' cmp -s whole/results.json before/results.json
cp "$solution/01_rays.cpp" small/cy
run 0 grade small --out whole --config grading.toml
says '3 of 4 submissions are graded already'
rm small/cy/01_rays.cpp

if command -v parallel >/dev/null; then
  check 'GNU parallel grades four shards' parallel --will-cite "$program" grade small --out 'part-{}' --shard '{}/4' --seed test --config grading.toml --jobs 1 ::: 1 2 3 4 >stdout 2>stderr
else
  for k in 1 2 3 4; do run 0 grade small --out part-$k --shard $k/4 --seed test --config grading.toml; done
fi
run 0 merge part-1 part-2 part-3 part-4 --out merged
for file in results.json gradebook.csv junit.xml roster.csv; do check "four shards merged give the same $file" cmp merged/$file before/$file; done

# For somebody else's pages.
run 0 grade small/bob --out one --seed test --config grading.toml --gradescope gs/results.json
check 'Gradescope gets tests' grep -q '"tests"' gs/results.json
GITHUB_STEP_SUMMARY=$folder/summary.md run 0 grade small/bob --out one --config grading.toml --github
prints '::error file=05_reflections.cpp'
check 'a step summary' test -s summary.md
run 2 grade small --out whole --config grading.toml --github
says 'for one submission'

# Wrong usage, and what it says.
run 1 grade small/no-such --out x
says 'is no folder'
run 1 grade small --out whole --seed other
says 'was graded with the seed test'
run 2 grade small --out x --shard 5/4
says '--shard: wanted I/N'
printf '[[stage]]\nstage = 9\npoints = -1\n[hints]\nlevel = 4\n' >bad.toml
run 2 grade small --out x --config bad.toml
says 'bad.toml:2:'
says 'bad.toml:3:'
says 'bad.toml:5:'
printf "[[hidden_test]]\ntask = '5.1'\ncall = '{\"d\": 1}'\n" >bad.toml
run 2 grade small --out x --config bad.toml
says 'hidden_test[0].call: d: '
check 'nothing was written' test ! -e x

# A hidden test counts, and the student's page tells nothing of it.
mkdir -p edge/fay && sed 's/^  return d - 2 \*/  if (d.x == 0.28) return d;\n&/' "$solution/05_reflections.cpp" >edge/fay/05_reflections.cpp
printf "[[hidden_test]]\ntask = '5.1'\ncall = '{\"d\": [0.28, -0.96, 0], \"n\": [0, 1, 0]}'\n" >hidden.toml
run 0 grade edge --out edges --seed test --config hidden.toml
out=$folder/edges
expect fay 5.1 wrong
check 'the page of the student tells nothing of a hidden test' bash -c "! grep -q '0.28' edges/submissions/$(id_of fay)/report.html"
check 'results.json does' grep -q '0.28' edges/results.json

# Nor can the submission tell it later, in what is published.
mkdir edge/gus && sed '1i static bool seen = false;
  s/^  return d - 2 \*/  seen = seen || d.x == 0.28;\n&/; s/{ return bounce/{ if (seen) throw 1; return bounce/' "$solution/05_reflections.cpp" >edge/gus/05_reflections.cpp
run 0 grade edge --out edges --seed test --config hidden.toml
expect gus 5.1 right
expect gus 5.3 right

# Time for a whole submission: what it has not answered by then is too slow.
mkdir -p late && cp -r "$class/endless_constructor" late
printf '[limits]\nsubmission = 1\n' >late.toml
start=$SECONDS
run 0 grade late --out lates --seed test --config late.toml
check 'a submission has a time of its own' test $((SECONDS - start)) -lt 60
out=$folder/lates
expect endless_constructor 5.1 too_slow

mkdir full && touch full/note
run 1 grade small --out full
says 'holds something else'

# What students get: nothing of the answers.
run 0 handout lab
for file in 01_rays.cpp 07_ssaa.cpp README.md INSTALL.md handbook/stages/README.md scenes/scene5.toml; do check "the handout has $file" test -s lab/$file; done
check 'no answers in it' bash -c "! grep -rqE 'difference_of_products|d - 2 \* dot|hidden_test' lab"
check 'no path of this machine in it' bash -c "! grep -rq '$source' lab"

# Without namespaces, as in a container: the other layers hold.
mkdir bin && for tool in as ld cp; do ln -s "$(command -v $tool)" bin; done
mkdir rest
for name in reads_passwd reads_proc reads_folders reads_environment opens_a_socket kills_everything daemon reaches_others raw_clone fork_bomb \
  fills_the_disk memory_file incbin_passwd include_zero becomes_root; do
  cp -r "$class/$name" rest
done
cp -r "$class/good" rest
out=$folder/fallback
PATH=$folder/bin run 0 grade rest --out "$out" --seed test --config grading.toml
check 'the report says that there are no namespaces' bash -c "! grep -q namespaces '$out/run.json'"
for submission in rest/*; do
  name=$(basename "$submission") wanted=right
  [[ $name == good ]] || wanted=$(sed -n '1s|^// \(all \)*\(.*\): .*|\2|p' "$source/tests/submissions/hostile/$name.cpp")
  expect "$name" 5.1 "$wanted"
done
check 'no process is left' bash -c "! pgrep -f '[r]aylab-[a-z]* .*$folder'"

report_checks
