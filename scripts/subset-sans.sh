#!/bin/sh
# Makes lib/report/assets/fonts/loadpath-sans{,-more,-semibold,-italic}.woff2 from Open Sans 1.11: the letters of reports,
# with tabular figures; "more" are letters of titles and names that few reports have. Needs fonts-open-sans, python3-fonttools and python3-brotli.
set -eu
folder=${1:-/usr/share/fonts/truetype/open-sans}
target=$(cd "$(dirname "$0")/.." && pwd)/lib/report/assets/fonts

# Latin with German letters, signs, Greek, punctuation, superscripts, arrows, operators
letters="U+0020-007E,U+00A0,U+00B0-00B3,U+00B5,U+00B7,U+00B9,U+00BC-00BE,U+00C4,U+00D6-00D8,U+00DC,U+00DF,U+00E4,U+00F6,U+00F7,\
U+00FC,U+0391-03A1,U+03A3-03A9,U+03B1-03C9,\
U+2009,U+200A,U+2013,U+2014,U+2018-201D,U+2022,U+2026,U+2032,U+2033,U+2070,U+2074-207B,U+2080-2089,U+2126,U+2190,U+2192,\
U+2202,U+2206,U+2212,U+2215,U+221A,U+221E,U+2248,U+2260,U+2264,U+2265,U+2300,U+22C5"

# Open Sans has no superscript minus: the sign of subtraction, as small and as high as its superscript digits.
regular=$(mktemp --suffix=.ttf)
scaled=$(mktemp --suffix=.ttf)
trap 'rm -f "$regular" "$scaled"' EXIT
/usr/bin/python3 - "$folder/OpenSans-Regular.ttf" "$regular" <<'PYTHON'
import sys
from fontTools.pens.transformPen import TransformPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTFont

font = TTFont(sys.argv[1], recalcTimestamp=False)
glyphs, metrics, cmap = font.getGlyphSet(), font["hmtx"].metrics, font.getBestCmap()
scale, name = 0.6, "uni207B"
digit = font["glyf"][cmap[0x2074]]  # of the superscripts, 4
sign = font["glyf"][cmap[0x2212]]
middle = (digit.yMin + digit.yMax) / 2 - scale * (sign.yMin + sign.yMax) / 2
pen = TTGlyphPen(None)
glyphs[cmap[0x2212]].draw(TransformPen(pen, (scale, 0, 0, scale, 0, middle)))
font.setGlyphOrder(font.getGlyphOrder() + [name])
font["glyf"][name] = pen.glyph()
metrics[name] = (round(scale * metrics[cmap[0x2212]][0]), round(scale * metrics[cmap[0x2212]][1]))
for table in font["cmap"].tables:
    if table.isUnicode():
        table.cmap[0x207B] = name
font.save(sys.argv[2])
PYTHON

# Outlines in thousandths of the em: a unit is 0.003 mm on paper.
subset() {
  /usr/bin/python3 -m fontTools.ttLib.scaleUpem "$1" 1000 --output-file "$scaled"
  /usr/bin/python3 -m fontTools.subset "$scaled" --output-file="$target/$2.woff2" --flavor=woff2 \
    --layout-features='kern,lnum,tnum,liga' --no-hinting --desubroutinize --no-recalc-timestamp --notdef-outline \
    --drop-tables+=DSIG,GDEF --unicodes="$3"
}
# Other signs and accents of Latin, Cyrillic
more="U+00A1-00AF,U+00B4,U+00B6,U+00B8,U+00BA,U+00BB,U+00BF-00C3,U+00C5-00D5,U+00D9-00DB,U+00DD,U+00DE,U+00E0-00E3,\
U+00E5-00F5,U+00F8-00FB,U+00FD-017F,U+0401,U+0410-044F,U+0451"

# Headings, labels and sizes that were found, with the Greek letters of sizes and factors
slim="U+0020-007E,U+00A0,U+00B0,U+00B2,U+00B3,U+00B5,U+00B7,U+00C4,U+00D6,U+00D7,U+00DC,U+00DF,U+00E4,U+00F6,U+00FC,\
U+03B1,U+03B2,U+03B4,U+03B5,U+03B7,U+03B8,U+03BB,U+03BC,U+03C1,U+03C3,U+03C4,U+03C6,U+03C8,U+03C9,\
U+2013,U+2026,U+2212,U+221E,U+2248,U+2264,U+2265"
subset "$regular" loadpath-sans "$letters"
subset "$regular" loadpath-sans-more "$more"
subset "$folder/OpenSans-Semibold.ttf" loadpath-sans-semibold "$slim"
# Symbols in figures
symbols="U+0020,U+0030-0039,U+0041-005A,U+0061-007A,U+0391-03A1,U+03A3-03A9,U+03B1-03C9"
subset "$folder/OpenSans-Italic.ttf" loadpath-sans-italic "$symbols"
