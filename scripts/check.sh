#!/bin/sh
# Builds the tests and passes them. Usage: sh scripts/check.sh [--replace]
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh

install_missing ${1:-} $build_packages $test_packages
cmake --preset release -DLOADPATH_TESTS=ON >/dev/null
cmake --build --preset release
ctest --preset release --no-tests=error --parallel "$(nproc)"
