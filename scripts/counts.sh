#!/bin/sh
# Counts the instructions per point of the kernels that have bars (tests/bench/counted.cpp, by callgrind) and compares
# them with tests/bench/counts.txt: more than a twentieth above the limit fails, a tenth below it is told, for the limit
# should follow. Usage: sh scripts/counts.sh [PROGRAM]; `--write` in place of the program writes the limits anew.
set -eu
cd "$(dirname "$0")/.."
limits=tests/bench/counts.txt
write=""
if [ "${1:-}" = "--write" ]; then write=yes; shift; fi
program=${1:-build/release/tests/loadpath_counted}

# instructions KERNEL BLOCKS: of the whole run. valgrind knows AVX2 and hides wider registers from the program.
instructions() {
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$1" "$2" 2>&1 >/dev/null |
    sed -n 's/.*Collected : \([0-9]*\).*/\1/p'
}

# per_point KERNEL POINTS: of the blocks beyond the first two, so that starting up does not count.
per_point() {
  few=$(instructions "$1" 2)
  many=$(instructions "$1" 6)
  echo $(((many - few) / (4 * $2)))
}

counted=$(mktemp)
trap 'rm -f "$counted"' EXIT
"$program" | while read -r kernel points; do
  echo "$kernel $(per_point "$kernel" "$points")"
done >"$counted"
[ -s "$counted" ] || { echo "error: $program counts nothing" >&2; exit 1; }
if [ -n "$write" ]; then
  { echo "# Instructions per point, release build of g++ 12 on AVX2: sh scripts/counts.sh --write"; cat "$counted"; } >"$limits"
  exit 0
fi
awk -v limits="$limits" '
  FNR == NR { if ($1 != "#") limit[$1] = $2; next }
  !($1 in limit) { printf "%s has no limit in %s\n", $1, limits; bad = 1; next }
  { printf "%-24s %7d instructions a point, limit %d\n", $1, $2, limit[$1]; seen[$1] = 1 }
  $2 > 1.05 * limit[$1] { printf "%s has grown by %.0f %%: make it fast again, or say in the change why its limit in %s rises\n", $1, 100 * ($2 / limit[$1] - 1), limits; bad = 1 }
  $2 < 0.9 * limit[$1] { printf "%s has become faster: lower its limit in %s\n", $1, limits }
  END { for (name in limit) if (!(name in seen)) { printf "%s is not counted any more\n", name; bad = 1 }; exit bad }
' "$limits" "$counted"
