#!/bin/sh
# Both commands of the README, and the two packages, in roots of Debian 12 that hold nothing else, made by debootstrap, so that
# a package that other machines happen to have cannot hide. Needs root and Debian's packages. The committed sources are taken;
# the packages are those in build/release/packages, and are made where there are none.
# Usage: sh scripts/bare_root.sh [packages | sources]
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
[ "$(id -u)" = 0 ] || { echo "error: debootstrap and chroot need root" >&2; exit 1; }
install_missing debootstrap

root=
leave() {
  [ -n "$root" ] || return 0
  umount "$root/proc" "$root/dev/pts" "$root/dev" 2>/dev/null || true
  rm -rf --one-file-system "$root"
  root=
}
trap leave EXIT

enter() {
  leave
  root=$(mktemp -d)
  debootstrap --variant=minbase bookworm "$root" >/dev/null
  cp /etc/resolv.conf "$root/etc/"
  mkdir -p "$root/loadpath"
  mount -t proc proc "$root/proc"
  mount --bind /dev "$root/dev"
  mount --bind /dev/pts "$root/dev/pts"
}

# timed COMMAND: in the root, with nothing of this machine's environment.
timed() {
  started=$(date +%s)
  chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin sh -c "cd /loadpath && $1" ||
    { echo "error: $1 failed" >&2; exit 1; }
  echo "$1: exit 0 after $(($(date +%s) - started)) s"
}

packages() {
  [ -n "$(find build/release/packages -name '*.deb' 2>/dev/null)" ] || sh scripts/packages_check.sh
  enter
  cp build/release/packages/*.deb build/release/packages/*.tar.xz "$root/loadpath/"
  cp -r examples "$root/loadpath/"
  timed "apt-get install --yes --no-install-recommends ./*.deb xz-utils >/dev/null && loadpath --version"
  timed "loadpath run examples/slotted-lever/project.toml --quiet --report report.html"
  timed "tar -xJf *.tar.xz && loadpath-*/loadpath run examples/slotted-lever/project.toml --quiet"
}

sources() {
  enter
  git archive HEAD | tar -x -C "$root/loadpath"
  timed "sh scripts/quickstart.sh"
  timed "sh scripts/check.sh"
}

case "${1:-}" in
  packages) packages ;;
  sources) sources ;;
  "")
    packages
    sources
    ;;
  *) echo "usage: sh scripts/bare_root.sh [packages | sources]" >&2; exit 2 ;;
esac
