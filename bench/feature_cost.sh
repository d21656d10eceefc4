#!/usr/bin/env bash
# What does a feature cost that a scene does not have? Renders scenes without it by the engine as it is, and by one with the
# feature cut out of its source, counts the instructions of both, and prints a table. The pictures must be the same, to the bit.
#   bench/feature_cost.sh [FOLDER]        FOLDER keeps what is built, for the next time; JOBS=4 runs four things at once, not two
# Needs valgrind, python3, and what raylab is built with; takes a few minutes.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
fail() { echo "feature_cost.sh: $*" >&2; exit 1; }
usage() { sed -n '2,5s/^# \?//p' "${BASH_SOURCE[0]}"; }
if [[ ${1-} == --help ]]; then usage; exit 0; fi
if (($# > 1)) || [[ ${1-} == -* ]]; then usage >&2; exit 2; fi
for tool in valgrind python3 cmake ninja; do
  command -v "$tool" >/dev/null || fail "$tool is missing"
done
jobs=${JOBS:-2}
if (($#)); then
  mkdir -p "$1"
  work=$(cd "$1" && pwd)
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
export work

"$here"/feature_cost.py "$work" >"$work"/rows
folders=("$work"/kernels/*)
cmake -S "$here"/.. -B "$work"/build -G Ninja -DCMAKE_BUILD_TYPE=Release -DRAYLAB_WITH_TESTS=OFF -DRAYLAB_WITH_ORACLE=OFF \
  -DRAYLAB_KERNELS="$(IFS=';'; echo "${folders[*]}")" --log-level=WARNING >&2
ninja -C "$work"/build -j "$jobs" "${folders[@]/#*\//raylab-feature-cost-}" >&2

# The instructions of one rendering, and the picture's hash, into a file with the rendering's name.
count() { # KERNEL SIMD PRECISION SCENE STAGE SAMPLING
  local hash log="$work/counts/$*.log"
  hash=$(RAYLAB_SIMD=$2 valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect='trace_image*' \
    "$work/build/bin/raylab-feature-cost-$1" "$work/scenes/$4.toml" "$5" "$6" "$3" 2>"$log") || { cat "$log" >&2; return 255; }
  echo "$(sed -n 's/^.*Collected : //p' "$log") $hash" >"$work/counts/$*"
}
export -f count
modes=('avx2 f32' 'avx2 f64' 'scalar f32')
rm -rf "$work"/counts
mkdir "$work"/counts
while IFS='|' read -r _ kernel without with; do
  for mode in "${modes[@]}"; do
    printf '%s\n' "whole $mode $without" "$kernel $mode $without"
  done
  [[ $with == - ]] || echo "whole ${modes[0]} $with"
done <"$work"/rows | sort -u | xargs -P "$jobs" -I{} bash -c 'count {}'

instructions() { # the same arguments as count
  local found
  read -r found _ <"$work/counts/$*"
  ((found > 0)) || fail "callgrind counted nothing: $*"
  echo "$found"
}
hash_of() { cut -d' ' -f2 "$work/counts/$*"; }
percent() { awk -v now="$1" -v before="$2" 'BEGIN {printf "%+.2f", 100 * (now / before - 1)}'; }
cost() { awk -v p="$(percent "$@")" 'BEGIN {printf((p > 1 ? "**%s %%**" : "%s %%"), p)}'; } # in bold: more than it should

echo '| A scene without | instructions a pixel | with the code cut out | cost: avx2 f32 | avx2 f64 | scalar f32 | with one in it |'
echo '|---|---:|---:|---:|---:|---:|---:|'
while IFS='|' read -r title kernel without with; do
  costs='' present=
  for mode in "${modes[@]}"; do
    # shellcheck disable=SC2086  # words
    {
      whole=$(instructions whole $mode $without) less=$(instructions "$kernel" $mode $without)
      [[ $(hash_of whole $mode $without) == "$(hash_of "$kernel" $mode $without)" ]] ||
        fail "$title: without the code the picture is another ($mode, $without)"
    }
    costs+=" $(cost "$whole" "$less") |"
    [[ $mode == "${modes[0]}" ]] || continue
    pixels=$((320 * 240)) a_pixel=$(awk -v a="$whole" -v b="$less" -v n=$pixels 'BEGIN {printf "%.2f | %.2f", a / n, b / n}')
    # shellcheck disable=SC2086
    [[ $with == - ]] || present="$(percent "$(instructions whole $mode $with)" "$whole") %"
  done
  echo "| $title | $a_pixel |$costs $present |"
done <"$work"/rows
