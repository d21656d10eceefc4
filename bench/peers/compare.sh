#!/usr/bin/env bash
# Renders the same scenes with POV-Ray, Tachyon and raylab in turn, each on one and the same core, and prints the medians of
# the times of rendering alone, and how many times faster raylab is.
#   bench/peers/compare.sh FOLDER ROUNDS SCENE...        bench/peers/compare.sh /tmp/peers 5 small flake4 grid100
# Needs povray, tachyon and python3; on a shared machine only the ratios mean anything.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
raylab=$here/../../build/release/bin/raylab
(($# >= 3)) || { sed -n '2,5s/^# \?//p' "${BASH_SOURCE[0]}"; exit 2; }
for tool in povray tachyon python3 "$raylab"; do
  command -v "$tool" >/dev/null || { echo "compare.sh: $tool is missing" >&2; exit 2; }
done
folder=$1 rounds=$2; shift 2
pinned=(taskset -c "$(($(nproc) - 1))")
widest=$("$raylab" doctor | sed -n 's/^.* \([a-z0-9]*\):.*<- used$/\1/p')

povray_seconds() {
  "${pinned[@]}" povray +I"$1".pov +W1280 +H960 -D -F -A +WT1 2>&1 | sed -n 's/.*Trace Time:.*(\([0-9.]*\) seconds).*/\1/p'
}
tachyon_seconds() { "${pinned[@]}" tachyon "$1".dat -numthreads 1 -nosave +V 2>&1 | sed -n 's/.*Ray Tracing Time: *\([0-9.]*\) .*/\1/p'; }
raylab_seconds() {
  RAYLAB_SIMD=$3 "${pinned[@]}" "$raylab" render "$1".toml --engine fast --precision "$2" --aa none --threads 1 --stats "$folder"/stats.json \
    -o "$folder"/out.png >/dev/null
  sed -n 's/.*"trace_seconds": \([0-9.e-]*\).*/\1/p' "$folder"/stats.json
}
median() { sort -g | awk '{a[NR] = $1} END {print a[int((NR + 1) / 2)]}'; }

python3 "$here"/scenes.py "$folder" "$@" >/dev/null
for scene in "$@"; do
  base=$folder/$scene
  rm -f "$base".*.seconds
  for ((round = 0; round < rounds; ++round)); do
    povray_seconds "$base" >>"$base".povray.seconds
    tachyon_seconds "$base" >>"$base".tachyon.seconds
    for variant in "f32 $widest" "f64 $widest" 'f32 avx2'; do
      # shellcheck disable=SC2086  # two words
      raylab_seconds "$base" $variant >>"$base.raylab ${variant}.seconds"
    done
  done
  povray=$(median <"$base".povray.seconds) tachyon=$(median <"$base".tachyon.seconds)
  printf '%-8s POV-Ray %.3f s, Tachyon %.3f s\n' "$scene" "$povray" "$tachyon"
  for file in "$base".raylab*.seconds; do
    variant=${file#"$base".} variant=${variant%.seconds} seconds=$(median <"$file")
    awk -v v="$variant" -v s="$seconds" -v p="$povray" -v t="$tachyon" \
      'BEGIN {printf "  %-20s %.4f s  %6.1f Mpixel/s  %5.1f times Tachyon  %5.1f times POV-Ray\n", v, s, 1.2288 / s, t / s, p / s}'
  done
done
