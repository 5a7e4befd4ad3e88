#!/bin/sh
# Fetches axe-core by npm into build/, and has the reports of all examples checked by it: sh scripts/axe.sh [BUILD]
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/release}
version=4.10.2
folder=build/axe-core-$version
if [ ! -f "$folder/package/axe.min.js" ]; then
  command -v npm >/dev/null || { echo "skipped: no npm"; exit 0; }
  mkdir -p "$folder"
  (cd "$folder" && npm pack --silent "axe-core@$version" >/dev/null && tar -xzf axe-core-*.tgz)
fi
LOADPATH_AXE=$PWD/$folder/package/axe.min.js "$build/tests/loadpath_tests" --test-suite=accessibility
