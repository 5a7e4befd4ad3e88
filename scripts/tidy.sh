#!/bin/sh
# clang-tidy over the sources, by the rules of .clang-tidy: `sh scripts/tidy.sh [FOLDER...]`, all of them where none is
# named. About ten seconds a file.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
install_missing clang-14 clang-tidy-14 $build_packages

folders=$(echo "${*:-lib calculators cli}" | tr ' ' '|')
cmake --preset tidy >/dev/null
cmake -E chdir build/tidy run-clang-tidy-14 -quiet -j "$(nproc)" -p . "^$PWD/($folders)/"
