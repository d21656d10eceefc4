#!/usr/bin/env bash
# Proves that the lab extends: in a copy of the project, the files under tests/extension/ and one line in stages/list.txt make
# an eighth stage, which renders and is tested like the others.
#   tests/extension_test.sh SOURCE_FOLDER
set -euo pipefail
source=$(realpath "$1")
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

cp -r "$source"/{CMakeLists.txt,CMakePresets.json,LICENSE,README.md,bench,cmake,core,reference,scenes,stages,tests} "$copy"
cd "$copy"
cp -r tests/extension/{stages,reference,tests} .
echo 08_depth_cueing >>stages/list.txt

# Without optimisation, debug information and what does not run the stage table: this is about building, not about speed.
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=None -DRAYLAB_WITH_ENGINE=OFF -DRAYLAB_WITH_ORACLE=OFF -DRAYLAB_WERROR=ON \
  --log-level=WARNING >/dev/null
ninja -C build >build.log || { tail -40 build.log; exit 1; }
raylab=build/bin/raylab

expect() {
  local what=$1; shift
  "$@" || { echo "FAILED: $what"; exit 1; }
}
$raylab stages >stages.txt
expect 'the stage is listed with its task' grep -q '8.1  depth_cue' stages.txt
$raylab render scenes/scene1.toml --size 64x48
expect 'the last stage is the default' test -s out/scene1-depth-cueing.png
$raylab render scenes/scene1.toml --size 64x48 --stage ssaa
expect 'stage 8 changes the image' bash -c '! cmp -s out/scene1-depth-cueing.png out/scene1-ssaa.png'
$raylab sheet scenes/scene1.toml --size 64x48
$raylab call --list >list.txt
expect 'its example runs' env PATH="$PWD/build/bin:$PATH" bash -c "$(grep -o 'raylab call 8.1 .*' list.txt) | grep -q '\"result\":\['"
expect 'its tests pass' "$raylab" test 8
expect 'its starter fails them, and no earlier ones' build/bin/raylab-starter-proof
echo '7 passed, 0 failed'
