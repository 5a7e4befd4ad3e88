#!/bin/sh
# Counts the program's own instructions per point of kernels (tests/bench/counted.cpp, by callgrind) and compares them with
# tests/bench/counts.txt: more than 5 %, and 3 instructions, above the limit fails; 10 % below it is reported, so that the
# limit is lowered.
# Usage: sh scripts/counts.sh [PROGRAM]; `--write` in place of the program writes the limits anew.
set -eu
cd "$(dirname "$0")/.."
limits=tests/bench/counts.txt
write=""
if [ "${1:-}" = "--write" ]; then write=yes; shift; fi
program=${1:-build/release/tests/loadpath_counted}

files=$(mktemp -d)
trap 'rm -rf "$files"' EXIT
own=$(realpath "$program")

# instructions KERNEL BLOCKS: of the full run, those of the program's own object file. The C library is left out, because
# the variant of sin or exp that it runs depends on the CPU. valgrind offers AVX2 at most, whatever the CPU has.
instructions() {
  valgrind -q --tool=callgrind --compress-strings=no --compress-pos=no --callgrind-out-file="$files/costs" "$program" "$1" "$2" >/dev/null
  # Self cost is "LINE COST" under the object's ob=; the line after calls= is the inclusive cost of a call.
  awk -v own="ob=$own" '
    /^ob=/ { mine = $0 == own }
    /^calls=/ { getline; next }
    mine && /^[0-9]+ [0-9]+$/ { sum += $2 }
    END { if (!sum) exit 1; printf "%.0f\n", sum }
  ' "$files/costs"
}

# per_point KERNEL POINTS: of the blocks beyond the first two, so that starting up does not count.
per_point() {
  few=$(instructions "$1" 2) && many=$(instructions "$1" 6) || return 1
  echo $(((many - few) / (4 * $2)))
}

counted=$files/counted
"$program" | while read -r kernel points; do
  count=$(per_point "$kernel" "$points") || exit 1
  echo "$kernel $count"
done >"$counted" && [ -s "$counted" ] || { echo "error: $program counts nothing" >&2; exit 1; }
if [ -n "$write" ]; then
  { echo "# Own instructions per point, release build of g++ 12 on AVX2: sh scripts/counts.sh --write"; cat "$counted"; } >"$limits"
  exit 0
fi
awk -v limits="$limits" '
  FNR == NR { if ($1 != "#") limit[$1] = $2; next }
  !($1 in limit) { printf "%s has no limit in %s\n", $1, limits; bad = 1; next }
  { printf "%-24s %7d instructions a point, limit %d\n", $1, $2, limit[$1]; seen[$1] = 1 }
  $2 > 1.05 * limit[$1] && $2 > limit[$1] + 3 { printf "%s has grown by %.0f %%: make it fast again, or say in the change why its limit in %s rises\n", $1, 100 * ($2 / limit[$1] - 1), limits; bad = 1 }
  $2 < 0.9 * limit[$1] && $2 < limit[$1] - 3 { printf "%s has become faster: lower its limit in %s\n", $1, limits }
  END { for (name in limit) if (!(name in seen)) { printf "%s is not counted any more\n", name; bad = 1 }; exit bad }
' "$limits" "$counted"
