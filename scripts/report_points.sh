#!/bin/sh
# The points of the acceptance of reports that a program can measure, on the reports of all examples as Chromium lays them out:
# blocks of page 1, margins, words, labels of figures, formulas, type sizes, clipped text, rows, contrast, phones of 390 pixels,
# number of pages, share of a page that is used, embedded fonts.
# sh scripts/report_points.sh [BUILD | PROGRAM] [EXAMPLE | PROJECT.toml...]
# Prints a line per finding; exit code 1 if there is one that scripts/report_points.known does not list.
set -eu
cd "$(dirname "$0")/.."
given=${1:-build/release}
[ $# -gt 0 ] && shift
program=$given
[ -d "$given" ] && program=$given/cli/loadpath
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
[ -n "$browser" ] || { echo "skipped: no Chromium"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sandbox=""
[ "$(id -u)" = 0 ] && sandbox=--no-sandbox  # its sandbox refuses root
found=0

look() {  # WORDS...: the browser, without a word of its own
  "$browser" --headless --disable-gpu --disable-quic --no-first-run --disable-background-networking $sandbox \
    --user-data-dir="$work/profile" --hide-scrollbars --force-device-scale-factor=1 "$@" 2>/dev/null
}

say() {  # NAME FINDING
  if printf '%s\n' "$1: $2" | grep -qF -f scripts/report_points.known; then
    echo "known: $1: $2"
  else
    echo "$1: $2"
    found=1
  fi
}

# laid NAME MEDIA WIDTH: what the script finds in a copy of the report, in a frame of that width, for the window of a browser
# has a least width of its own. For print its rules hold on the screen, and those of screens nowhere.
laid() {
  {
    if [ "$2" = print ]; then
      sed -e 's/@media print{/@media all{/' -e 's/@media screen/@media speech/' "$work/r.html"
    else
      cat "$work/r.html"
    fi
    printf '<script>\nconst MEDIA = "%s";\n' "$2"
    cat scripts/report_points.js
    echo '</script>'
  } >"$work/copy.html"
  cat >"$work/frame.html" <<HTML
<!doctype html><body style="margin:0"><iframe id="f" src="copy.html" style="border:0;width:$3px;height:1000px"></iframe>
<script>setInterval(() => {
  const all = document.getElementById("f").contentDocument.body.getAttribute("data-findings");
  if (all && !document.getElementById("out")) document.body.insertAdjacentHTML("beforeend", '<pre id="out"></pre>');
  if (all) document.getElementById("out").textContent = "\n" + all + "\n";
}, 100);</script>
HTML
  look --allow-file-access-from-files --virtual-time-budget=20000 --window-size=1400,1100 --dump-dom \
    "file://$work/frame.html" >"$work/dom.txt" || true
  grep -q 'id="out"' "$work/dom.txt" || { say "$1" "$2: the browser has not finished"; return; }
  sed -n '/<pre id="out">/,/<\/pre>/p' "$work/dom.txt" | grep '^point' >"$work/findings.txt" || return 0
  while read -r line; do say "$1" "$2: $line"; done <"$work/findings.txt"
}

# printed NAME: pages of the short report (4 for two machines with more parts than others, 1 for one shaft), their lowest
# text, and its fonts.
printed() {
  most=3
  case $1 in
    press | conveyor-drive) most=4 ;;
    line-shaft) most=1 ;;
  esac
  look --no-pdf-header-footer --print-to-pdf="$work/r.pdf" "file://$work/brief.html" >/dev/null || true
  [ -s "$work/r.pdf" ] || { say "$1" "the browser has not printed"; return; }
  command -v pdfinfo >/dev/null && command -v pdffonts >/dev/null || return 0
  pages=$(pdfinfo "$work/r.pdf" | awk '/^Pages:/ { print $2 }')
  [ "$pages" -le "$most" ] || say "$1" "point 4: $pages pages, at most $most"
  at=1
  while [ "$at" -lt "$pages" ]; do
    # The footer of all pages is below 0.95 of the height.
    share=$(pdftotext -f "$at" -l "$at" -bbox "$work/r.pdf" - | awk -F'"' '
      /<page/ { height = $4 }
      /<word/ && $8 < 0.95 * height && $8 > low { low = $8 }
      END { printf "%d", 100 * low / height }')
    [ "$share" -ge 60 ] || say "$1" "point 5: page $at is filled to $share %"
    at=$((at + 1))
  done
  # The font of formulas has outlines that Chromium writes as drawings without a name.
  pdffonts "$work/r.pdf" | awk 'NR > 2 && !/^\[none\] +Type 3/ && (!/ yes (yes|no) +(yes|no) / || !/^[A-Z]+\+(Loadpath|OpenSans)/) { print $1 }' |
    sort -u >"$work/fonts.txt"
  while read -r font; do say "$1" "point 14: font $font"; done <"$work/fonts.txt"
}

every=no
if [ $# -eq 0 ]; then
  every=yes
  set -- examples/*/project.toml
fi
for file in "$@"; do
  case $file in *.toml) ;; *) file=examples/$file/project.toml ;; esac
  name=$(basename "${file%/project.toml}" .toml)
  rm -f "$work"/*.html "$work/r.pdf"
  status=0
  "$program" run "$file" --quiet --report "$work/r.html" >/dev/null 2>&1 || status=$?
  [ "$status" != 2 ] && [ -s "$work/r.html" ] || continue  # a sweep has its own report
  "$program" run "$file" --quiet --brief --report "$work/brief.html" >/dev/null 2>&1 || true
  laid "$name" print 662  # A4 between margins of 20 and 15 mm
  laid "$name" phone 390
  printed "$name"
done
# Point 23: page 1 against the JSON of the same run.
if [ "$every" = yes ] && command -v python3 >/dev/null; then
  python3 scripts/report_numbers.py "$program" >"$work/numbers.txt" || found=1
  [ "$found" = 0 ] || cat "$work/numbers.txt"
fi
[ "$found" = 0 ] && echo "all points pass"
exit "$found"
