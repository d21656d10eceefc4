#!/usr/bin/env bash
# A student's files, right, unwritten and broken in many ways, as the commands meet them: new, --with, explain, hints.
#   tests/submission_test.sh PROGRAM SOURCE_FOLDER
set -uo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
program=$(realpath "$1")
source=$(realpath "$2")
enter_new_folder
export XDG_CACHE_HOME=$folder/cache
unset RAYLAB_HINTS
export ASAN_OPTIONS=abort_on_error=1  # where the program has that sanitizer: a crash is to look like one
has_sanitizer() { grep -q __asan_init "$program"; }

# lab NAME: a folder with the whole solution in it.
lab() { mkdir -p "$1" && cp "$source"/reference/solution/0*.cpp "$1"; }
# edited NAME FILE SED: the solution with one edit.
edited() { lab "$1" && sed -i "$3" "$1/$2"; check "the edit of $1 changes $2" bash -c "! cmp -s $1/$2 $source/reference/solution/$2"; }
no_worker_left() { check 'no worker is left' bash -c "! pgrep -f '[r]aylab-worker .*$folder' >/dev/null"; }
small=(--size 40x30)

# new: a workspace is complete, and a submission as it stands
run 0 new 'my lab' --solutions 1-2
prints 'seven files to fill in'
for file in 01_rays.cpp 07_ssaa.cpp README.md handbook/stages/README.md handbook/stages/02_intersections/stage.hpp \
  handbook/docs/driver.md scenes/scene5.toml reference/renders/manifest.json solutions/02_intersections.cpp; do
  check "a workspace has $file" test -s "my lab/$file"
done
check 'only the solutions that were asked for' test ! -e 'my lab/solutions/03_blinn_phong.cpp'
check 'no oracle and no engine' bash -c "! find 'my lab' -name '*oracle*' -o -name '*engine*' | grep -q ."
while IFS=: read -r page link; do
  [[ $link == *:* || $link == '#'* ]] && continue
  check "my lab: $page links to $link" test -e "$(dirname "$page")/${link%%#*}"
done < <(find 'my lab' -name '*.md' -exec grep -oHE '\]\([^) ]+\)' {} + | sed 's/](\(.*\))$/\1/')
run 1 new 'my lab'
says 'is there already, and not empty'
run 2 new other --solutions 3-1
check 'nothing was made' test ! -e other
run 2 new other --solutions 8
mkdir empty
run 0 new empty

# a right submission: the same image to the last bit, all tests pass
lab right
run 0 render "$source/scenes/scene3.toml" "${small[@]}" -o theirs.exr --with right
run 0 render "$source/scenes/scene3.toml" "${small[@]}" -o own.exr
check 'the same image' cmp theirs.exr own.exr
run 0 test 2 --with right
prints 'passed  2.2 sphere_hit:'
run 0 test 5.1 --with right:5
run 2 test 5.1 --with right:4
says '--with names nothing of 5.1'
run 0 diff scene1 --stage 2 --with right --out diff
check 'the page of the difference' test -s diff/index.html
(cd right && "$program" diff scene1 --stage 2 --with .:1) >stdout
prints 'right:1'
run 0 sheet "$source/scenes/scene1.toml" "${small[@]}" --with right -o sheet.png
run 0 call 5.1 '{"d": [0.6, -0.8, 0], "n": [0, 1, 0]}' --with right
prints '"result":[0.6,0.8,0.0]'
printf '%s\n' '{"bounce": 1, "max_bounces": 0, "weight": 1}' '{"bounce": 1, "max_bounces": 1, "weight": 1}' >calls.jsonl
check 'JSON Lines' bash -c "'$program' call 5.3 --with right <calls.jsonl >stdout"
check 'two answers' test "$(wc -l <stdout)" = 2
run 0 explain "$source/scenes/scene1.toml" --stage 3 --with right
prints "all pixels are as the solution has them"

# not written: told by label, file and line; the rest runs; tests do not let the solution stand in
run 0 render "$source/scenes/scene1.toml" --stage 2 "${small[@]}" -o x.png --with 'my lab'
says "task 2.1 is not written yet: my lab/02_intersections.cpp:10: the solution's stands in for it"
run 1 test 2.1 --with 'my lab'
prints 'task 2.1 is not written yet: my lab/02_intersections.cpp:10'
run 1 test 2 --with 'my lab'
prints 'FAILED  stage 2: images are like the references'
run 1 call 2.1 '{"ray": {"origin": [0, 3, 0], "direction": [0, -1, 0]}, "plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}}' --with 'my lab'
says 'task 2.1 is not written yet'

# mixing: a later one wins, and only what is chosen counts
edited wrong5 05_reflections.cpp 's/return d - 2/return 2/'
run 1 test 5.1 --with wrong5
run 0 test 4 --with wrong5
run 0 test 5.1 --with wrong5 --with right
run 0 test 5.1 --with wrong5 --with right:5.1
run 1 test 5.1 --with right --with wrong5:5.1
run 0 test 5.3 --with wrong5
run 0 render "$source/scenes/scene3.toml" "${small[@]}" -o theirs.exr --with wrong5:1-4
run 2 render "$source/scenes/scene3.toml" --with wrong5:9
says "there is no stage or task '9'"
run 2 render "$source/scenes/scene3.toml" --with nowhere
says 'nowhere: is no folder'
mkdir bare
run 2 test --with bare
says 'has none of the files that a submission may have: 01_rays.cpp'
run 2 render "$source/scenes/scene3.toml" --with right --engine fast

# a mistake fails its own task, and none that asks it and is right; one that is wrong by itself fails all the same
fails() { # STAGE FOLDER TASK...: the tests of these tasks fail, and of no other task of the stage
  local stage=$1 name=$2 task; shift 2
  for task in $("$program" stages | grep -oE "^ +$stage\.[0-9]"); do
    case " $* " in *" $task "*) run 1 test "$task" --with "$name" ;; *) run 0 test "$task" --with "$name" ;; esac
  done
}
fails 5 wrong5 5.1
edited wrong_twice 05_reflections.cpp 's/return d - 2/return 2/; s/hit.leaves}, k_s}/hit.leaves}, 1}/'
fails 5 wrong_twice 5.1 5.2
edited weight 03_blinn_phong.cpp 's|tanh(shininess / 400)|tanh(-shininess / 400)|'
fails 3 weight 3.1
edited diffuse 03_blinn_phong.cpp 's/(diffuse + specular)/(diffuse - specular)/'
fails 3 diffuse 3.2
edited weight_and_light 03_blinn_phong.cpp 's|shininess / 400|shininess / 200|; s|light.intensity / ((1 + r) \* (1 + r))|light.intensity / (r * r)|'
fails 3 weight_and_light 3.1 3.3
edited exit 06_refraction.cpp 's/exit = d - 2 \* g/exit = d - g/'
fails 6 exit 6.1
edited power 06_refraction.cpp 's/m \* m \* m \* m \* m/m * m * m * m/'
fails 6 power 6.2
edited exit_and_mix 06_refraction.cpp 's/exit = d - 2 \* g/exit = d - g/; s/{\*exit, 1 - R}/{*exit, 1}/'
fails 6 exit_and_mix 6.1 6.3
edited unasked 05_reflections.cpp 's/^  return d - 2/  throw 1; return d - 2/; s/{hit.point, reflect(hit.direction, hit.normal)/{hit.point, hit.direction - 2 * dot(hit.direction, hit.normal) * hit.normal/'
fails 5 unasked 5.1

# what fails says what was asked, expected and answered, and how to ask it again
run 1 test 5.1 --with wrong5
prints '        asked     d = (0.6, -0.8, 0)'
prints '                  n = (0, 1, 0)'
prints '        expected  (0.6, 0.8, 0), give or take 3.8e-06'
prints '        got       (0, -1.6, 0)'
prints "        again     raylab call 5.1 '{\"d\":[0.6,-0.8,0.0],\"n\":[0.0,1.0,0.0]}' --with wrong5"
prints '        checked   length(r)'
edited last_of_equals 02_intersections.cpp 's/\*candidates\[k\].t < /*candidates[k].t <= /'
run 1 test 2.4 --with last_of_equals
prints 'expected  1'
prints 'got       3'

# what does not compile says so by the student's own file and line, and only where it matters
edited unfinished 03_blinn_phong.cpp 's/return std::tanh(shininess/return std::tanh(shine/'
run 1 render "$source/scenes/scene1.toml" --with unfinished
says 'unfinished/03_blinn_phong.cpp:10:'
says 'this does not compile'
check 'no image' test ! -e out
run 0 test 2 --with unfinished
run 0 render "$source/scenes/scene1.toml" --stage 2 "${small[@]}" -o x.png --with unfinished
lab helper && echo 'int helper();' >helper/helper.hpp && sed -i '1i #include "helper.hpp"' helper/01_rays.cpp
run 1 test 1 --with helper
says 'helper/01_rays.cpp:1:'
edited renamed 05_reflections.cpp 's/bool go_on(int bounce/bool go_on(long bounce/'
run 1 call 5.3 '{"bounce": 1, "max_bounces": 0, "weight": 1}' --with renamed
says 'task 5.3 is missing: no go_on is defined as stage.hpp declares it'
run 0 call 5.1 '{"d": [0.6, -0.8, 0], "n": [0, 1, 0]}' --with renamed

# crashes and endless loops end in a message with the task and its inputs
body='s/^Vec3 reflect(const Vec3& d, const Vec3& n) {/&\n'
edited null 05_reflections.cpp "$body  *static_cast<volatile int*>(nullptr) = 1;/"
edited forever 05_reflections.cpp "$body  volatile int on = 1; while (on) {}/"
edited leaves 05_reflections.cpp "1i #include <cstdlib>
$body  std::exit(0);/"
edited throws 05_reflections.cpp "$body  throw 42;/"
edited noisy 05_reflections.cpp "1i #include <iostream>
$body  std::cout << \"debug\" << std::endl;/"
edited deep 05_reflections.cpp "$body  return reflect(d, n) + d;/"
edited hungry 05_reflections.cpp "1i #include <vector>
$body  std::vector<double> all(1000000000); return all[3] * d;/"
for kind in null:crashed forever:'no answer in time' leaves:'exit code 0' deep:crashed; do
  run 1 call 5.1 '{"d": [0.6, -0.8, 0], "n": [0, 1, 0]}' --with "${kind%%:*}"
  says 'task 5.1 reflect'
  says "${kind#*:}"
  says "raylab call 5.1 '{\"d\":[0.6,-0.8,0.0],\"n\":[0.0,1.0,0.0]}' --with ${kind%%:*}"
  run 1 render "$source/scenes/scene3.toml" --stage 5 "${small[@]}" -o x.png --with "${kind%%:*}"
  says 'task 5.'
  says "${kind#*:}"
  says ' of row '
done
run 1 call 5.1 '{"d": [0.6, -0.8, 0], "n": [0, 1, 0]}' --with throws
says 'threw something that is no std::exception'
has_sanitizer || { run 1 call 5.1 '{"d": [0.6, -0.8, 0], "n": [0, 1, 0]}' --with hungry && says 'took more memory than there is for it'; }
run 0 call 5.1 '{"d": [0.6, -0.8, 0], "n": [0, 1, 0]}' --with noisy
prints '"result":[0.6,0.8,0.0]'
says 'debug'
run 1 test 5.1 --with null
prints 'FAILED  5.1 reflect:'
prints '0 passed'
edited born_dead 05_reflections.cpp '$a static int dead = [] { __builtin_trap(); return 1; }();'
run 1 call 5.3 '{"bounce": 1, "max_bounces": 0, "weight": 1}' --with born_dead
says 'while it was loaded'
no_worker_left

# Ctrl-C
"$program" render "$source/scenes/scene3.toml" --stage 5 -o late.png --with forever >stdout 2>stderr &
sleep 1.5
kill -INT $!
wait $!
check "exit code $?, wanted 130: Ctrl-C in an endless loop" test $? = 130
check 'no image' test ! -e late.png
no_worker_left
"$program" test 5 --with forever >stdout 2>stderr &
sleep 1.5
kill -INT $!
wait $!
check "exit code $?, wanted 130: Ctrl-C while tests run" test $? = 130
no_worker_left

# what is no number says where
edited nan 03_blinn_phong.cpp 's/(diffuse + specular)/std::sqrt(-1 - diffuse - specular)/'
run 0 render "$source/scenes/scene1.toml" --stage 3 "${small[@]}" -o x.png --with nan
says 'pixels are not finite numbers, the first at '

# explain
run 0 explain "$source/scenes/scene3.toml" --stage 5 "${small[@]}" --pixel 20,15 --svg rays.svg
prints 'camera ray: color'
prints 'reflected ray, bounce 1'
check 'a picture' grep -q '</svg>' rays.svg
for name in 'camera ray' 'reflected ray' 'point_light\[0\]' 'to point_light\[0\]' 'sphere\[[0-9]*\]'; do
  check "the picture names $name" grep -q ">$name</text>" rays.svg
done
check 'the picture names what it shows only' bash -c '! grep -q "refracted ray" rays.svg'
run 0 explain "$source/scenes/scene4.toml" --stage 7 "${small[@]}" --pixel 20,15 --json
check 'JSON' bash -c "python3 -c 'import json; assert len(json.load(open(\"stdout\"))[\"samples\"]) == 4' || ! command -v python3 >/dev/null"
run 1 explain "$source/scenes/scene3.toml" --stage 5 "${small[@]}" --pixel 20,15 --with wrong5 --svg rays.svg
check 'the picture has the wrong ray' grep -q '>by 5.2 of --with wrong5</text>' rays.svg
run 0 explain "$source/scenes/scene3.toml" --stage 5 "${small[@]}" --pixel 20,15 --with right
run 1 explain "$source/scenes/scene3.toml" --stage 5 --with wrong5
prints 'this call is the first to be answered differently'
prints 'task      5.2 mirror_bounce'
prints 'handout   section 5'
run 1 explain "$source/scenes/scene3.toml" --stage 5 --with null
prints 'there is no image: task 5.'
run 2 explain "$source/scenes/scene3.toml" --pixel 640,0
says 'from 0,0 at the top left to 639,479'
run 2 explain "$source/scenes/scene3.toml"
run 2 explain "$source/scenes/scene3.toml" --pixel 1,1 --hint 1

# hints, in levels, as far as the course allows
edited far_root 02_intersections.cpp 's/^std::optional<double> sphere_hit(const Ray& ray, const Sphere& sphere) {/&\n  if (dot(ray.origin - sphere.center, ray.origin - sphere.center) > sphere.radius * sphere.radius) { const Vec3 f = sphere.center - ray.origin; const double b = dot(f, ray.direction), q = sphere.radius * sphere.radius - dot(f - b * ray.direction, f - b * ray.direction); if (q < 0 || b + std::sqrt(q) < 0) return {}; return b + std::sqrt(q); }/'
run 1 test 2 --with far_root
prints 'the same with --hint 1'
run 1 test 2 --with far_root --hint 1
prints '1 observed: sphere_hit answers'
check 'no more than asked for' bash -c '! grep -q "2 look at" stdout'
run 1 test 2 --with far_root --hint 3
page=$(sed -n 's/^  2 look at: \(.*README.md\), 2.2 sphere_hit.*/\1/p' stdout)
check "the page that a hint names is there: $page" test -e "$page"
prints '3 mistake: the far root'
(cd 'my lab' && "$program" test 2.2 --with ../far_root --hint 2) >stdout
prints '2 look at: handbook/stages/02_intersections/README.md, 2.2 sphere_hit'
RAYLAB_HINTS=1 run 1 test 2 --with far_root --hint 3
check 'no more than allowed' bash -c '! grep -q "3 mistake" stdout'
says 'this course gives hints up to level 1'
RAYLAB_HINTS=9 run 2 test 2 --with far_root --hint 3

# --sanitize, where the compiler is g++
if "${CXX:-c++}" --version | grep -q 'Free Software' && ! has_sanitizer; then
  edited index 05_reflections.cpp "1i #include <vector>
$body  std::vector<double> all(3); volatile int k = 3; if (all[k] > 1e300) return d;/"
  run 0 call 5.1 '{"d": [0.6, -0.8, 0], "n": [0, 1, 0]}' --with index
  run 1 call 5.1 '{"d": [0.6, -0.8, 0], "n": [0, 1, 0]}' --with index --sanitize
  says 'index/05_reflections.cpp:'
  says 'Assertion'
fi

report_checks
