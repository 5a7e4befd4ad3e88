#!/bin/sh
# From a fresh Debian 12 to a report: installs what is missing, builds the program, runs the slotted-lever project.
# Usage: sh scripts/quickstart.sh [--replace]
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh

install_missing ${1:-} $build_packages
cmake --preset release -DLOADPATH_TESTS=OFF >/dev/null
cmake --build --preset release --target loadpath

report=build/report.html
status=0
build/release/cli/loadpath run examples/slotted-lever/project.toml --report "$report" || status=$?
# 1 is an answer: a check that fails or is not covered, as the report says. Above 1 nothing was solved.
[ "$status" -le 1 ] || exit "$status"
echo "the report is in $(pwd)/$report"
