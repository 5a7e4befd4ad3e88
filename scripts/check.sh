#!/bin/sh
# Builds the tests and passes them. Usage: sh scripts/check.sh [--replace]
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh

install_missing ${1:-} $build_packages $test_packages
options="-DLOADPATH_PYTHON=OFF -DLOADPATH_HDF5=OFF -DLOADPATH_MPI=OFF -DLOADPATH_BENCH=OFF"  # in the tree only when asked for
cmake --preset release -DLOADPATH_TESTS=ON $options >/dev/null
cmake --build --preset release
ctest --preset release --no-tests=error --parallel "$(nproc)"
