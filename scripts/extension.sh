#!/bin/sh
# Packages the extension for VS Code in a folder of its own: scripts/extension.sh SOURCE WORK. Exit 77 where npm is missing or
# reaches no registry, and where tests take a share.
set -eu
source=$1
work=$2
[ -n "${LOADPATH_IN_FULL:-}" ] || { echo "skipped: LOADPATH_IN_FULL=1 runs it"; exit 77; }
command -v npm >/dev/null && command -v node >/dev/null || { echo "skipped: no npm"; exit 77; }
rm -rf "$work"
cp -r "$source" "$work"
cd "$work"
client=$(node -p 'require("./package.json").dependencies["vscode-languageclient"]')
timeout 60 npm view "vscode-languageclient@$client" version >/dev/null 2>&1 || { echo "skipped: no registry"; exit 77; }
node --check extension.js
npm install --no-audit --no-fund --no-package-lock --silent
npm run --silent package
files=$(./node_modules/.bin/vsce ls)
for file in extension.js package.json language-configuration.json loadpath.tmLanguage.json; do
  echo "$files" | grep -qx "$file" || { echo "the package lacks $file" >&2; exit 1; }
done
test -s loadpath-*.vsix
