#!/bin/sh
# Makes the pictures of reports that docs/gallery/README.md shows, docs/gallery/*.png, by Chromium: sh scripts/gallery.sh [PROGRAM]
set -eu
cd "$(dirname "$0")/.."
program=${1:-build/release/cli/loadpath}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p docs/gallery

# report NAME COMMAND WORDS...: a report of an example, as its file is called from here.
report() {
  name=$1
  shift
  "$program" "$@" --quiet --report "$work/$name.html" || [ $? = 1 ] || [ $? = 4 ]
}

# picture NAME REPORT FRAGMENT SELECTOR: the window at the element that is selected. Within a frame, for Chromium paints
# nothing of a page that it has scrolled itself.
picture() {
  cp "$work/$2.html" "$work/page.html"
  [ -z "$4" ] || printf '<script>addEventListener("load", () => setTimeout(() => document.querySelector("%s").scrollIntoView(), 300))</script>\n' "$4" >> "$work/page.html"
  printf '<body style="margin:0"><iframe src="page.html%s" style="border:0;width:880px;height:660px"></iframe>\n' "$3" > "$work/frame.html"
  chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --allow-file-access-from-files --virtual-time-budget=3000 \
    --window-size=880,660 --screenshot="$PWD/docs/gallery/$1.png" "file://$work/frame.html" > "$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
}

report lever run examples/slotted-lever/project.toml
report gears run examples/gearbox-shaft/project.toml
report receiver run examples/air-receiver/project.toml
report strut sweep examples/strut-sweep/project.toml --pareto "mass:min,u:min"

picture answer receiver "" ""
picture load-path gears "" "figure.path"
picture mechanism lever "#position=90" "figure.moving"
picture formulas lever "" "#crankshaft-calculation"
picture shaft gears "" "#shaft"
picture sweep strut "" ""
ls -l docs/gallery
