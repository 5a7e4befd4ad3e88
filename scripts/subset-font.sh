#!/bin/sh
# Makes lib/report/assets/fonts/loadpath-math.woff2 from STIX Math 1.1.1: what formulas need, with the MATH table, renamed as
# the licence of a font with reserved names requires. Needs fonts-stix, python3-fonttools and python3-brotli.
set -eu
source_font=${1:-/usr/share/fonts/opentype/stix-word/STIXMath-Regular.otf}
target=$(cd "$(dirname "$0")/.." && pwd)/lib/report/assets/fonts/loadpath-math.woff2
renamed=$(mktemp --suffix=.otf)
trap 'rm -f "$renamed"' EXIT

/usr/bin/python3 - "$source_font" "$renamed" <<'PYTHON'
import sys
from fontTools.ttLib import TTFont

font = TTFont(sys.argv[1], recalcTimestamp=False)
names = {1: "Loadpath Math", 2: "Regular", 3: "Loadpath Math subset of version 1.1.1", 4: "Loadpath Math",
         6: "LoadpathMath-Regular"}
kept = {0, 13, 14}
font["name"].names = [record for record in font["name"].names if record.nameID in kept]
for number, text in names.items():
    font["name"].setName(text, number, 3, 1, 0x409)
cff = font["CFF "].cff
cff.fontNames = ["LoadpathMath-Regular"]
for key in ("FullName", "FamilyName"):
    setattr(cff.topDictIndex[0], key, "Loadpath Math")
# Browsers stop the index of a root short of its sign, so it is set nearer and lower.
constants = font["MATH"].table.MathConstants
constants.RadicalKernBeforeDegree.Value = 60
constants.RadicalKernAfterDegree.Value = -360
constants.RadicalDegreeBottomRaisePercent = 62
# Only these grow with what they enclose.
variants = font["MATH"].table.MathVariants
growing = {"parenleft", "parenright", "bar", "braceleft", "uni221A"}
kept_pairs = [pair for pair in zip(variants.VertGlyphCoverage.glyphs, variants.VertGlyphConstruction) if pair[0] in growing]
variants.VertGlyphCoverage.glyphs = [glyph for glyph, _ in kept_pairs]
variants.VertGlyphConstruction = [construction for _, construction in kept_pairs]
variants.VertGlyphCount = len(kept_pairs)
# The font's own ascent is that of its largest integral; a line of text with a symbol would be three lines high.
metrics = font["OS/2"]
font["hhea"].ascent, font["hhea"].descent = 900, -250
metrics.usWinAscent, metrics.usWinDescent = 900, 250
font.save(sys.argv[2])
PYTHON

# Latin, its superscripts, pi, operators, the radical, math italics of Latin and of Greek letters that are none of its letters
# by another name. Other letters and signs, upright Greek ones and arrows, are set in the sans font. Without the text of the licence, which the file LICENSE has, and without
# kerning and variants of scripts, which lines of text have not either.
/usr/bin/python3 -m fontTools.subset "$renamed" --output-file="$target" --flavor=woff2 --layout-features='' \
  --drop-tables+=FFTM,GDEF --no-hinting --desubroutinize --no-recalc-timestamp --name-IDs='0,1,2,3,4,6,14' \
  --notdef-outline --unicodes="\
U+0020-0021,U+0025,U+0028-003A,U+003C-003E,U+0041-005A,U+0061-007D,U+00A0,U+00B0-00B3,U+00B5,U+00B7,U+00B9,U+00D7,U+03C0,U+2009,\
U+2026,U+2032,U+210E,U+2126,U+2212,U+221A,U+221E,U+2227,U+2228,U+2248,U+2260,U+2264,U+2265,U+22C5,U+1D434-1D467,U+1D6E4,U+1D6E5,\
U+1D6E9,U+1D6EC,U+1D6EF,U+1D6F1,U+1D6F4,U+1D6F6,U+1D6F7,U+1D6F9,U+1D6FA,U+1D6FC-1D709,U+1D70B,U+1D70C,U+1D70E-1D714"
