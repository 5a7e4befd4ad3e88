#!/bin/sh
# Both commands of the README in a Debian 12 that holds nothing else, made by debootstrap, so that a package that other
# machines happen to have cannot hide. Needs root and Debian's packages. Usage: sh scripts/bare_root.sh [FOLDER]
# The committed sources are taken. Without a folder the root is removed at the end, else it stays for a look.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
[ "$(id -u)" = 0 ] || { echo "error: debootstrap and chroot need root" >&2; exit 1; }
install_missing debootstrap

root=${1:-$(mktemp -d)}
keep=${1:-}
leave() {
  umount "$root/proc" "$root/dev/pts" "$root/dev" 2>/dev/null || true
  [ -n "$keep" ] || rm -rf --one-file-system "$root"
}
trap leave EXIT
debootstrap --variant=minbase bookworm "$root" >/dev/null
mkdir -p "$root/loadpath"
git archive HEAD | tar -x -C "$root/loadpath"
cp /etc/resolv.conf "$root/etc/"
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
mount --bind /dev/pts "$root/dev/pts"

# timed COMMAND: in the root, with nothing of this machine's environment.
timed() {
  started=$(date +%s)
  chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin sh -c "cd /loadpath && $1"
  echo "$1: exit 0 after $(($(date +%s) - started)) s"
}
timed "sh scripts/quickstart.sh"
timed "sh scripts/check.sh"
