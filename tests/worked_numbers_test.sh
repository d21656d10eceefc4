#!/usr/bin/env bash
# The numbers to check by hand on the pages of stages/ are what the code gives. They stand in fenced blocks marked `hand`:
#   raylab call 3.1 '{"shininess": 200}'  -> 0.462117     calls a task
#   b^2 - q = 25 - 24.36 = 0.64                           arithmetic: all sides are equal; the last is a number
# In a result "..." stands for anything, and a comma at the end of the line says that it goes on. Numbers with six decimals or more
# are rounded, those with fewer are exact. "#" starts a remark. Elsewhere on a page no number has more than three decimals, so that
# none escapes.
#   tests/worked_numbers_test.sh PROGRAM SOURCE_FOLDER
set -uo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$2" || exit 1
pages=(stages/README.md stages/*/README.md)

# In awk, for both programs below: are two numbers equal, within the decimals of the second?
close_awk='
function decimals(text,   point) { sub(/[eE].*/, "", text); point = index(text, "."); return point ? length(text) - point : 0 }
function close_to(got, wanted,   gap, size) {
  gap = got - wanted; if (gap < 0) gap = -gap
  size = wanted < 0 ? -wanted : wanted + 0
  if (decimals(wanted) >= 6) return gap <= 0.500001 * 10 ^ -decimals(wanted)
  return gap <= 1e-12 * (size > 1 ? size : 1)
}'

# matches GOT WANTED: is one JSON text like the other, where "..." stands for anything?
matches() {
  GOT=$1 WANTED=$2 awk "$close_awk"'
  function tokens(text, list,   count) {
    count = 0
    while (match(text, /\.\.\.|"[^"]*"|-?[0-9][-+0-9.eE]*|[a-z]+|[^ ]/)) {
      list[++count] = substr(text, RSTART, RLENGTH)
      text = substr(text, RSTART + RLENGTH)
    }
    return count
  }
  function alike(i, j,   k) {
    if (j > wanted_count) return i > got_count
    if (wanted[j] == "...") {
      for (k = i; k <= got_count + 1; ++k) if (alike(k, j + 1)) return 1
      return 0
    }
    if (i > got_count) return 0
    if (wanted[j] ~ /^-?[0-9]/ ? !(got[i] ~ /^-?[0-9]/ && close_to(got[i], wanted[j])) : got[i] != wanted[j]) return 0
    return alike(i + 1, j + 1)
  }
  BEGIN {
    got_count = tokens(ENVIRON["GOT"], got); wanted_count = tokens(ENVIRON["WANTED"], wanted)
    exit !alike(1, 1)
  }'
}

# The calls: page, label, arguments and result, separated by tabs.
awk '
FNR == 1 { hand = 0 }
/^```/ { hand = !hand && /^```hand/; next }
!hand { next }
{ sub(/[ ]*#.*/, "") }
/^raylab call / { call = "" ; open = 1 }
open {
  call = call " " $0
  if ((arrow = index(call, "->")) == 0 || /,$/) next
  open = 0
  first = index(call, "\047"); last = first + index(substr(call, first + 1), "\047")
  split(substr(call, 1, first), word, " ")
  print FILENAME "\t" word[3] "\t" substr(call, first + 1, last - first - 1) "\t" substr(call, arrow + 3)
}' "${pages[@]}" >"$folder/calls"
while IFS=$'\t' read -r page label json wanted; do
  (cd "$folder" && "$program" call "$label" "$json" >stdout 2>stderr)
  got=$(sed -E 's/.*"result":(.*),"hex":.*/\1/' "$folder/stdout")
  check "$page: raylab call $label '$json' -> $wanted, got $got" matches "$got" "$wanted"
done <"$folder/calls"

# Every task has one.
while read -r label; do
  check "a worked number of $label" grep -q $'\t'"$label"$'\t' "$folder/calls"
done < <("$program" call --list | grep -oE '^[0-9]+\.[0-9]+')

# The arithmetic: each block becomes an awk program that prints what does not hold.
awk '
FNR == 1 { hand = 0 }
/^```/ { hand = !hand && /^```hand/; if (hand) print "#" FILENAME; open = 0; next }
!hand { next }
{ sub(/[ ]*#.*/, "") }
/^raylab call / { open = 1; arrow = 0 }
open { if (/->/) arrow = 1; if (arrow && !/,$/) open = 0; next }
NF { print }' "${pages[@]}" |
  sed -E 's/\(([^()]+,[^()]+,[^()]+)\) \. \(([^()]+,[^()]+,[^()]+)\)/dot(\1, \2)/g; s/\|\(([^()]+)\)\|/norm(\1)/g' |
  awk '
/^#/ { page = substr($0, 2); split("", known); print "deg = atan2(0, -1) / 180"; next }
{
  line = $0; gsub(/^ +| +$/, "", line)
  count = split(line, side, / = /)
  number = side[count]
  bad = count < 2 || number !~ /^-?[0-9.]+$/ || line ~ /[^-+*\/^()., =A-Za-z0-9_]/ || line ~ /[0-9)] +[A-Za-z0-9(]/
  if (bad) { printf "print \"%s: not understood: %s\"\n", page, line; next }
  start = 1
  if (side[1] ~ /^[A-Za-z_][A-Za-z_0-9]*$/ && (count > 2 || !(side[1] in known))) {
    known[side[1]]; printf "%s = %s\n", side[1], side[2]; start = 2
  }
  for (k = start; k < count; ++k)
    printf "sides++; if (!close_to(%s, \"%s\")) print \"%s: %s is \" (%s) \", not %s\"\n", side[k], number, page, side[k], side[k], number
}' >"$folder/arithmetic"
{
  printf '%s\n' "$close_awk" '
function tan(x) { return sin(x) / cos(x) }
function tanh(x) { return (exp(x) - exp(-x)) / (exp(x) + exp(-x)) }
function asin(x) { return atan2(x, sqrt(1 - x * x)) }
function max(a, b) { return (a > b) ? a : b }
function dot(a, b, c, d, e, f) { return a * d + b * e + c * f }
function norm(a, b, c) { return sqrt(a * a + b * b + c * c) }
BEGIN { OFMT = CONVFMT = "%.12g"'
  cat "$folder/arithmetic"
  echo 'print sides + 0 " sides checked" }'
} >"$folder/arithmetic.awk"
awk -f "$folder/arithmetic.awk" >"$folder/found" 2>&1
while IFS= read -r found; do
  check "$found" test "${found#* }" = 'sides checked' -a "${found%% *}" != 0
done <"$folder/found"

# No computed number stands outside the blocks.
while IFS= read -r found; do
  check "$found: a number with more than three decimals belongs into a block marked hand" false
done < <(awk 'FNR == 1 { code = 0 } /^```/ { code = !code && /^```hand/; next } !code && /[0-9]\.[0-9][0-9][0-9][0-9]/ { print FILENAME ":" FNR }' "${pages[@]}")

report_checks
