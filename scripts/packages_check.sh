#!/bin/sh
# Makes the Debian package and the portable archive out of a build, and runs what is in them: sh scripts/packages_check.sh
# [BUILD]
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/release}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
rm -rf "$build/packages"
cmake --build "$build" --target loadpath_said portable
(cd "$build" && cpack -G DEB)
solve="run /examples/slotted-lever/project.toml --quiet"

# The package for Debian, unpacked.
dpkg-deb -x "$build"/packages/*.deb "$work/deb"
for file in bin/loadpath share/man/man1/loadpath.1.gz share/bash-completion/completions/loadpath \
  share/zsh/vendor-completions/_loadpath share/fish/vendor_completions.d/loadpath.fish \
  share/loadpath/loadpath.schema.json share/loadpath/examples/slotted-lever/project.toml share/doc/loadpath/LICENSE; do
  test -f "$work/deb/usr/$file" || { echo "error: the package lacks $file" >&2; exit 1; }
done
"$work/deb/usr/bin/loadpath" --version
dpkg-deb -f "$build"/packages/*.deb Package Version Depends

# The archive in a root that holds nothing else: no library, no shell.
archive=$(cd "$build/packages" && pwd)/$(cd "$build/packages" && ls loadpath-*.tar.xz)
(cd "$work" && cmake -E tar xJf "$archive")
root=$(echo "$work"/loadpath-*)
code=0
if [ "$(id -u)" = 0 ]; then
  chroot "$root" /loadpath $solve || code=$?
else
  unshare -r chroot "$root" /loadpath $solve || code=$?
fi
test "$code" = 0 || { echo "error: in the bare root the example ends with $code, not 0" >&2; exit 1; }
ls -l "$build"/packages/*.deb "$build"/packages/*.tar.xz
