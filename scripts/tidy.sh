#!/bin/sh
# clang-tidy over the sources, by the rules of .clang-tidy: `sh scripts/tidy.sh [FOLDER...]`, all of them where none is
# named. Most of its time goes into the headers of a source, so all of them are read in batches, a folder file by file.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
install_missing clang-14 clang-tidy-14 $build_packages

folders=$(echo "${*:-lib calculators cli api build/tidy/calculators}" | tr ' ' '|')
batches=ON
[ $# = 0 ] || batches=OFF
cmake --preset tidy -DLOADPATH_BATCHES=$batches >/dev/null
cmake -E chdir build/tidy run-clang-tidy-14 -quiet -j "$(nproc)" -p . "^$PWD/($folders)/"
