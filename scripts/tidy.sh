#!/bin/sh
# clang-tidy by the rules of .clang-tidy. Usage: sh scripts/tidy.sh [--changed | FOLDER...]
# Without arguments all sources are read, in batches, for most of the time goes into the headers of a source. --changed reads
# the sources that were changed since the commit in .ci/tidied, which passed in full, and for each changed header one
# source that includes it; all sources where the history does not reach that commit.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
install_missing clang-14 clang-tidy-14 $build_packages

# The sources whose reading shows every change since a commit, one a line.
changed_sources() {
  git diff --name-only --diff-filter=d "$1" -- lib calculators cli api >build/tidy/changed
  git ls-files --others --exclude-standard -- lib calculators cli api >>build/tidy/changed
  grep '\.cpp$' build/tidy/changed || true
  grep '\.hpp$' build/tidy/changed | while read -r header; do source_reading "$header"; done
}

# A source that reads a header: its own, one that includes it, or one that includes a header that does.
source_reading() {
  header=$1
  for depth in 1 2 3 4; do
    [ ! -f "${header%.hpp}.cpp" ] || { echo "${header%.hpp}.cpp"; return; }
    readers=$(git grep -lF "#include \"$header\"" -- lib calculators cli api || true)
    source=$(echo "$readers" | grep '\.cpp$' | head -n 1)
    [ -z "$source" ] || { echo "$source"; return; }
    header=$(echo "$readers" | head -n 1)
    [ -n "$header" ] || return 0
  done
}

# read_sources PATTERN: clang-tidy over the compile commands whose file matches; the counts of suppressed warnings are noise.
read_sources() {
  log=$(mktemp)
  status=0
  cmake -E chdir build/tidy run-clang-tidy-14 -quiet -j "$(nproc)" -p . "$1" >"$log" 2>&1 || status=$?
  grep -v -e '^[0-9]* warnings\? generated\.$' -e '^clang-tidy-14 ' "$log" || true
  rm -f "$log"
  return $status
}

mkdir -p build/tidy
# With the batches of the build tree, without the sources that a build generates there.
whole="^$PWD/(lib|calculators|cli|api|build/tidy/(lib|calculators|cli)/.*)/"
case "${1:-}" in
  "") batches=ON pattern=$whole ;;
  --changed)
    since=$(cat .ci/tidied)
    if git merge-base --is-ancestor "$since" HEAD 2>/dev/null; then
      changed_sources "$since" | sort -u >build/tidy/sources
      count=$(wc -l <build/tidy/sources)
      echo "$count sources show what changed since $since"
      [ "$count" != 0 ] || exit 0
    fi
    if [ "${count:-1000}" -le 150 ]; then  # beyond that batches are faster
      batches=OFF
      pattern="^$PWD/($(paste -sd '|' build/tidy/sources | sed 's/\./\\./g'))\$"
    else
      echo "all sources"
      batches=ON pattern=$whole
    fi ;;
  *) batches=OFF pattern="^$PWD/($(echo "$*" | tr ' ' '|'))/" ;;
esac
cmake --preset tidy -DLOADPATH_BATCHES=$batches >/dev/null
read_sources "$pattern"
