#!/usr/bin/env bash
# The program as its users meet it: commands, files, messages, exit codes, Ctrl-C.
#   tests/cli_test.sh PROGRAM SCENES_FOLDER
set -uo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
program=$(realpath "$1")
scenes=$(realpath "$2")
enter_new_folder

cat >good.toml <<'TOML'
[camera]
position = [0, 1, 5]
facing = [0, 0, -1]
up = [0, 1, 0]
[image]
width = 33
height = 21
[[sphere]]
center = [0, 1, 0]
radius = 1
color = [0.9, 0.2, 0.2]
[[ambient_light]]
intensity = 0.5
TOML
sed 's/radius = 1/radius = -1/; s/color/colour/' good.toml >bad.toml
: >empty.toml

# render: where the image goes
run 0 render good.toml
prints 'out/good-ssaa.png  33x21'
silent
check 'the default name is out/SCENE-STAGE.png' test -s out/good-ssaa.png
run 0 render good.toml --stage shadows
check 'the stage by name' test -s out/good-shadows.png
run 0 render good.toml --stage 2 -o deep/er/x.exr --size 8x4
check 'the stage by number, a folder that is made' test -s deep/er/x.exr
prints 'deep/er/x.exr  8x4'
for ending in tif tiff bmp; do run 0 render good.toml --size 8x4 -o "x.$ending"; done

# render: the same bytes for any number of threads
for ending in png exr tif; do
  run 0 render "$scenes/scene4.toml" --size 61x47 --threads 1 -o "one.$ending"
  run 0 render "$scenes/scene4.toml" --size 61x47 --threads 7 -o "seven.$ending"
  check "1 and 7 threads, .$ending" cmp -s "one.$ending" "seven.$ending"
done

# render: engines, precisions, sampling
run 0 render good.toml --engine fast --precision f32 --stats stats.json -o fast.png
check 'solution and engine give the same 8 bits here' cmp -s fast.png out/good-ssaa.png
for key in '"load_seconds"' '"build_seconds"' '"render_seconds"' '"primary": 2772' '"shadow": 0' '"reflected": 0' \
  '"refracted": 0' '"samples": 2772' '"threads"' '"engine": "fast"' '"precision": "f32"' '"width": 33' '"height": 21' \
  '"peak_memory_bytes"'; do
  check "--stats has $key" grep -qF -- "$key" stats.json
done
run 0 render good.toml --engine oracle --size 8x4 -o oracle.png
run 0 render good.toml --stage 2 --aa grid16 --stats stats.json
check '--aa works before stage 7' grep -qF '"samples": 11088' stats.json
run 0 render good.toml --aa adaptive --stats stats.json
check '--aa adaptive takes from 4 to 16 samples a pixel' awk '/"samples"/ { exit !($2 + 0 > 2772 && $2 + 0 < 11088) }' stats.json

# the fast engine's instruction sets
run 0 doctor
check 'doctor names the instruction set in use' grep -qE '^engine fast .*<- used$' stdout
check 'doctor names scalar as the last resort' grep -qE 'scalar: 1 f32 or 1 f64 at a time' stdout
run 0 render good.toml --engine fast --stats stats.json -o widest.exr
export RAYLAB_SIMD=scalar
run 0 render good.toml --engine fast --stats stats.json -o scalar.exr
check 'RAYLAB_SIMD chooses the instruction set' grep -qF '"simd": "scalar"' stats.json
check 'every instruction set gives the same image' cmp -s widest.exr scalar.exr
export RAYLAB_SIMD=mmx
run 1 render good.toml --engine fast -o scalar.exr
says "RAYLAB_SIMD: there is no 'mmx' on this machine; there are"
run 1 doctor
unset RAYLAB_SIMD
run 2 render good.toml --engine stages --precision f32
says '--engine stages computes in f64 only'
run 2 render good.toml --engine oracle --precision f64
run 2 render good.toml --aa 9x9
run 2 render good.toml --size 640
says "wanted WIDTHxHEIGHT, like 640x480, each from 1 to 65536, got '640'"
run 2 render good.toml --size 0x9
run 2 render good.toml --size 70000x9
run 2 render good.toml --stage fog
says "there is no stage 'fog'"
says '3 blinn-phong'
run 2 render good.toml --max-bounces 101
run 2 render good.toml --threads 0
run 2 render
run 2 paint good.toml
run 2

# render: what cannot be written or read
run 1 render good.toml -o x.xyz
says "no image format is known for the ending '.xyz': use .png, .exr or .tif"
run 1 render good.toml -o deep
run 1 render none.toml
says 'none.toml'
run 1 render bad.toml -o bad.png
says 'bad.toml:10:10: sphere[0].radius: must be greater than 0, got -1'
says "bad.toml:11:1: sphere[0].colour: unknown key, did you mean 'color'?"
says 'bad.toml: 3 mistakes'
check 'nothing is rendered from a scene with a mistake' test ! -e bad.png
mkfifo pipe.toml
run 1 render pipe.toml
says 'pipe.toml: a pipe or a device; copy its content to a file'
run 1 check-scene /dev/zero
sed 's/^\[\[sphere\]\]/[[sphere_cloud]]\nfile = "pipe.toml"/; /^center/d; /^radius/d' good.toml >cloud.toml
run 1 check-scene cloud.toml
says 'cloud.toml:9:8: sphere_cloud[0].file: cannot read pipe.toml: a pipe or a device'
sed 's/center = \[0, 1, 0\]/center = [0, 1, 1e20]/' good.toml >far.toml
run 1 render far.toml --engine fast --precision f32
says 'use --precision f64'

run 1 render good.toml -o /proc/x.png
says '/proc/x.png: cannot be written'
cp good.toml own.toml
run 2 render own.toml --stats own.toml
run 2 render own.toml -o ./own.toml
run 2 render own.toml -o x.png --stats ./x.png
says 'both the image and the statistics'
check 'no file of its own is overwritten' cmp -s own.toml good.toml
run 1 render good.toml --size 20000x2 -o wide.jpg
run 2 sheet good.toml --size 5000x9
run 0 render good.toml --threads 1024

# --show and the progress bar
run 0 render good.toml --show
prints '▀'
check 'the viewer that the launcher names gets the file' env RAYLAB_VIEWER='cp -t viewed' bash -c \
  'mkdir viewed && "$0" render good.toml --show >/dev/null && for i in {1..50}; do [[ -s viewed/good-ssaa.png ]] && exit; sleep 0.1; done; exit 1' "$program"
check 'a long render shows a progress bar on a terminal' bash -c \
  'script -qec "timeout -s INT 2 \"$0\" render \"$1\" --engine oracle -o long.png" /dev/null </dev/null | grep -q "left"' "$program" "$scenes/scene3.toml"

# Ctrl-C: ends within 0.2 s, says so, and leaves nothing
mkdir stopped
for engine in stages fast oracle; do
  "$program" render "$scenes/scene5.toml" --engine $engine --size 6000x6000 --aa grid64 -o stopped/x.png >stdout 2>stderr &
  pid=$!
  sleep 1.2
  start=$(date +%s%N)
  kill -INT $pid
  code=0; wait $pid || code=$?
  milliseconds=$((($(date +%s%N) - start) / 1000000))
  check "--engine $engine: interrupted has exit code 130, got $code" test $code = 130
  check "--engine $engine: stops within 0.2 s, took $milliseconds ms" test $milliseconds -lt ${RAYLAB_STOP_LIMIT_MS:-200}
  check "--engine $engine: leaves no file" test -z "$(ls -A stopped)"
  says 'interrupted, nothing was written'
done

# sheet, check-scene, stages, help, test
run 0 sheet good.toml --size 40x30
check 'the contact sheet' test -s out/good-sheet.png
run 0 check-scene good.toml "$scenes"/*.toml "$scenes"/*/*.toml
prints 'good.toml: good: 0 planes, 1 spheres, 1 lights, 33x21, 5 bounces'
run 1 check-scene good.toml bad.toml empty.toml
prints 'good.toml: good'
says '2 of 3 scene files have mistakes'
run 0 stages
prints '5.1  reflect'
run 0 --help
prints 'raylab render scenes/scene5.toml'
for command in render sheet check-scene call test diff reference; do
  run 0 $command --help
  prints 'Example'
done
run 0 test 5.1
prints '4 passed, 0 failed'
run 0 test shadows
run 2 test 5.9
says "there is no stage or task '5.9'"
run 2 test 55

# call: one task on given data, on the command line
ray='"ray": {"origin": [0, 0, 5], "direction": [0, 0, -1]}' sphere='"sphere": {"center": [0, 0, 0], "radius": 1}'
hit='{"task":"2.2","name":"sphere_hit","result":4.0,"hex":"0x1p+2"}'
run 0 call 2.2 "{$ray, $sphere}"
check 'call prints one line' test "$(cat stdout)" = "$hit"
silent
run 0 call sphere_hit "{$sphere, $ray}" --with solution --precision f64
prints "$hit"
run 0 call 2.2 "{$ray, $sphere}" --precision oracle
prints "$hit"
run 2 call 2.2 "{$ray}"
says 'raylab: sphere: is missing'
run 2 call 2.2 "{$ray, ${sphere/radius/raduis}}"
says "raylab: sphere.raduis: unknown key, did you mean 'radius'?"
run 2 call 2.2 ''
says 'raylab: this is no JSON: line 1, column 1'
run 2 call shpere_hit '{}'
says "there is no task 'shpere_hit', did you mean 'sphere_hit'?"
run 2 call 2.9 '{}'
says "there is no task '2.9': 'raylab call --list' lists them"
run 2 call
says 'name a task'
run 2 call 2.2 '{}' --precision f32
says '--with solution computes in f64 only'
for precision in f32 f64 oracle; do
  run 0 call 2.2 "{$ray, $sphere}" --with fast --precision $precision
  prints "$hit"
done
run 0 call 3.1 '{"shininess": 100}' --with fast --precision f32
prints '"hex":"0x1.f597eap-3"'
run 2 call 2.2 --list
run 1 call 2.2 "{${ray/-1/0}, $sphere}" --precision oracle
says 'the oracle has no answer where a direction has the length 0'

# call: a line of JSON for each line of standard input
answers() {
  local code=$1 got=0; shift
  "$program" call "$@" >stdout 2>stderr || got=$?
  check "exit code $got, wanted $code: raylab call $* <lines" test "$got" = "$code"
  silent
}
answers 0 2.2 < <(printf '%s\r\n\n \t\r\n%s' "{$ray, $sphere}" "{$ray, $sphere}")
check 'CRLF, blank lines, no newline at the end' test "$(cat stdout)" = "$hit"$'\n'"$hit"
answers 1 2.2 < <(printf '%s\n' "{$ray}" '[' $'\xff' "{$ray, $sphere}")
check 'a mistake does not stop the rest' test "$(wc -l <stdout)" = 4
prints '{"task":"2.2","error":"sphere: is missing"}'
check 'the last line is answered' test "$(tail -1 stdout)" = "$hit"
answers 1 2.2 < <(head -c 100000000 /dev/zero | tr '\0' '['; printf '\n%s\n' "{$ray, $sphere}")
prints '{"task":"2.2","error":"the line is longer than 4194304 bytes"}'
prints "$hit"
answers 1 2.2 < <(head -c 1000000 /dev/zero | tr '\0' '[')
prints 'more than 32 levels of brackets'
answers 1 2.2 < <(head -c 300000 "$program")
answers 0 2.2 </dev/null
coproc "$program" call 3.1
echo '{"shininess": "inf"}' >&"${COPROC[1]}"
check 'an answer comes before the next line is sent' bash -c 'read -r -t 20 line && [[ $line == *:1.0,* ]]' <&"${COPROC[0]}"
kill "$COPROC_PID"

# call: the examples of --list and of docs/call.md run as they stand
run 0 call --list
grep '^    raylab call ' stdout >examples
check 'each task has an example' test "$(wc -l <examples)" = "$("$program" stages | grep -c '^    ')"
prints 'sphere: {center: [x, y, z], radius: number}'
PATH=$(dirname "$program"):$PATH
while IFS= read -r example; do check "$example" bash -c "$example >/dev/null"; done <examples
while IFS= read -r command && IFS= read -r output; do
  check "docs/call.md: $command" test "$(bash -c "${command#'$ '}" 2>&1)" = "$output"
done < <(grep -A1 '^\$ raylab call' "$(dirname "$scenes")/docs/call.md" | grep -v '^--$')

# diff: verdicts, exit codes, output
run 0 render "$scenes/scene3.toml" --stage 5 --size 160x120 -o mine.exr
run 0 diff mine.exr --scene scene3 --stage reflections
prints 'same: mine.exr and scene3 at stage 5, reflections'
run 0 render "$scenes/scene3.toml" --stage 4 --size 160x120 -o behind.png
run 1 diff behind.png --scene "$scenes/scene3.toml" --stage 5
prints 'This is what stage 4, shadows, gives: one stage behind.'
silent
run 0 diff behind.png --scene scene3 --stage 4
run 0 render "$scenes/scene3.toml" --stage 5 --size 160x120 --max-bounces 7 -o bounces.png
run 1 diff bounces.png --scene scene3 --stage 5 --json
prints '"verdict": "differs"'
run 0 diff mine.exr mine.exr
run 1 diff mine.exr behind.png --out deep/diff
prints 'deep/diff/index.html'
for file in index.html heat.png side-by-side.png diff.json; do check "diff --out writes $file" test -s "deep/diff/$file"; done
run 0 render "$scenes/scene1.toml" --stage 6 --size 160x120 -o glassless.png
run 0 diff glassless.png --scene scene1 --stage 6
prints 'nothing has changed since stage 5, reflections'

# diff: what cannot be compared
run 0 render "$scenes/scene3.toml" --stage 5 --size 64x48 -o small.png
run 2 diff small.png --scene scene3 --stage 5
says 'small.png: is 64x48 pixels, and scene3 at stage 5, reflections is 160x120: render it again with --size 160x120'
run 2 diff none.png --scene scene3
says 'none.png'
run 2 diff mine.exr --scene scene9
says "there are no references of a scene 'scene9'"
run 2 diff mine.exr --scene scene3 --stage fog
run 2 diff mine.exr
says 'name a reference image, or a scene with --scene'
run 2 diff mine.exr behind.png --scene scene3
run 2 diff mine.exr behind.png --stage 3
ln -s mine.exr link.exr
run 2 diff link.exr --scene scene3
says 'link.exr: is a link'
mkfifo pipe.png
run 2 diff pipe.png --scene scene3
head -c 9000 mine.exr >cut.exr
run 2 diff cut.exr --scene scene3
says 'cut.exr'
run 2 diff . --scene scene3

run 2 diff deep/diff/heat.png mine.exr --out deep/diff
check 'what is compared is not overwritten' grep -q 'deep/diff/heat.png: would be overwritten' stderr
run 2 diff mine.exr behind.png --out good.toml
run 0 diff "$scenes/../reference/renders/05_reflections/scene3.exr" --scene scene3 --stage 5

# reference: in an installation of its own, with two small scenes
run 2 reference
says 'say either --update or --check'
run 2 reference --check scene9
mkdir -p own/bin own/share/raylab/{docs,scenes/more}
cp "$program" own/bin/raylab
echo 'the model' >own/share/raylab/docs/model.md
sed 's/width = 33/width = 160/; s/height = 21/height = 2/' good.toml >own/share/raylab/scenes/one.toml
cp own/share/raylab/scenes/one.toml own/share/raylab/scenes/more/two.toml
renders=own/share/raylab/reference/renders
own() { program=$PWD/own/bin/raylab run "$@"; }
own 1 reference --check
says 'there is no manifest of the references'
own 0 reference --update
prints '8 references rendered, 8 in all'
own 0 reference --update
prints '0 references rendered, 8 in all'
own 0 reference --check
prints '8 references hold'
own 0 reference --check --all
rm $renders/01_rays/one.png
own 1 reference --check
says '01_rays/one.png: is missing, though the manifest lists it'
own 0 reference --update
prints '1 references rendered, 8 in all'
own 0 reference --check
echo 'another model' >own/share/raylab/docs/model.md
own 0 reference --update two
own 1 reference --check
says 'model.md: has changed since its references were rendered'
own 0 reference --update
prints '4 references rendered, 8 in all'
own 0 reference --check
sed -i 's/"sha1": "/"sha1": "0/' $renders/manifest.json
own 1 reference --check
own 0 reference --update --all
rm own/share/raylab/scenes/more/two.toml
own 0 reference --update
check 'the renders of a scene that is gone are removed' test ! -e $renders/01_rays/two.exr
mkdir own/share/raylab/scenes/hard
cp own/share/raylab/scenes/one.toml own/share/raylab/scenes/hard/three.toml
own 0 reference --update
prints '1 references rendered, 5 in all'
check 'a hard scene has a reference at the last stage' test -e $renders/07_ssaa/three.exr
cp $renders/01_rays/one.exr $renders/02_intersections/one.exr
own 1 reference --check
says '02_intersections/one.exr: is not the file that the manifest lists'
sed -i 's/radius = 1/radius = 2/' own/share/raylab/scenes/one.toml
own 0 render own/share/raylab/scenes/one.toml --size 160x2 -o own.exr
own 2 diff own.exr --scene one
says 'one.toml: has changed since its references were rendered'

# Many lights over many spheres: a single ray's shadows take long, and stop all the same
{
  cat good.toml
  printf '[[sphere_cloud]]\nfile = "many.csv"\ncolor = [1, 1, 1]\n'
  for k in {1..400}; do printf '[[point_light]]\nposition = [%d, 9, 9]\nintensity = 1\n' "$k"; done
} >many.toml
{ echo x,y,z,radius; seq 1 200000 | sed 's/.*/&,-9,-50,0.4/'; } >many.csv
"$program" render many.toml --stage shadows --size 300x300 -o stopped/x.png >stdout 2>stderr &
pid=$!
sleep 2
start=$(date +%s%N)
kill -INT $pid
wait $pid
milliseconds=$((($(date +%s%N) - start) / 1000000))
check "many lights: stops within 0.2 s, took $milliseconds ms" test $milliseconds -lt ${RAYLAB_STOP_LIMIT_MS:-200}
check 'many lights: leaves no file' test -z "$(ls -A stopped)"

report_checks
