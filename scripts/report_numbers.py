#!/usr/bin/env python3
"""Compares the numbers of page 1 of the reports of all examples with the JSON of the same run.

python3 scripts/report_numbers.py [BUILD | PROGRAM] [PROJECT.toml...]

Verdict and counts, the table of governing failure modes by row, and every quantity with a unit in text, tables and
figures: it must be a number of the JSON, rounded to the digits that are shown. Prints a line per difference; exit code 1
if there is one.
"""
import html
import json
import math
import os
import re
import subprocess
import sys
import tempfile

# What a page shows, in the units of the JSON.
UNITS = {
    "mm": ("m", 1e-3), "µm": ("m", 1e-6), "m": ("m", 1.0), "mm²": ("m^2", 1e-6), "cm²": ("m^2", 1e-4),
    "mm³": ("m^3", 1e-9), "mm⁴": ("m^4", 1e-12), "N": ("N", 1.0), "kN": ("N", 1e3), "MN": ("N", 1e6),
    "N·m": ("N*m", 1.0), "kN·m": ("N*m", 1e3), "Pa": ("Pa", 1.0), "kPa": ("Pa", 1e3), "MPa": ("Pa", 1e6),
    "GPa": ("Pa", 1e9), "W": ("W", 1.0), "kW": ("W", 1e3), "rpm": ("rad/s", math.pi / 30), "°": ("rad", math.pi / 180),
    "°/m": ("rad/m", math.pi / 180), "rad/s": ("rad/s", 1.0), "1/s": ("rad/s", 1.0), "kg": ("kg", 1.0),
    "g": ("kg", 1e-3), "kg·m²": ("kg*m^2", 1.0), "s": ("s", 1.0), "h": ("s", 3600.0), "m/s": ("m/s", 1.0),
    "m/s²": ("m/s^2", 1.0), "J": ("J", 1.0), "kJ": ("J", 1e3),
}
ALIKE = {"J": "N*m", "N/m^2": "Pa", "1/s": "rad/s", "N*m/s": "W"}
NUMBER = r"[−-]?\d[\d\u2009\u202f]*(?:\.\d+)?(?:e[−-]?\d+)?"
BY_LENGTH = "|".join(re.escape(unit) for unit in sorted(UNITS, key=len, reverse=True))
QUANTITY = re.compile(rf"(?<![\w.,])({NUMBER})[ \u00a0\u2009\u202f]?({BY_LENGTH})(?![\w·/²³⁴])")
PAIR = re.compile(rf"({NUMBER}) / ({NUMBER})(?:[ \u00a0]?(\S+))?$")


def number_of(text):
    """The number, and half a unit of its last digit: of 13 620, with three digits at least, of the last but one."""
    plain_text = re.sub("[\u2009\u202f]", "", text).replace("−", "-")
    mantissa, _, power = plain_text.partition("e")
    whole, _, decimals = mantissa.partition(".")
    whole = whole.lstrip("-")
    last = -len(decimals) if decimals else min(len(whole) - len(whole.rstrip("0")), max(0, len(whole) - 3))
    return float(plain_text), 0.5001 * 10.0 ** (last + int(power or 0))


def shows(text, value, factor=1.0):
    """Whether a text shows the value."""
    shown, half = number_of(text)
    if value is None or not math.isfinite(value):
        return False
    actual = abs(value) / factor
    return abs(abs(shown) - actual) <= half + 1e-12 * actual


def values_of(entry):
    if not isinstance(entry, dict):
        return []
    value = entry.get("value")
    return entry.get("values", [value] if isinstance(value, (int, float)) else [])


def peaks_of(values):
    """The vertices of the parabolas through extremes of a series, as the figures label them."""
    for a, b, c in zip(values, values[1:], values[2:]):
        if None not in (a, b, c) and (b - a) * (c - b) < 0:
            yield b - (c - a) ** 2 / (8 * (a - 2 * b + c))


def positions_of_peaks(step):
    """Where those vertices are on an axis of angles."""
    for entry in step["results"].values():
        axis = step.get("axes", {}).get(entry.get("axis") if isinstance(entry, dict) else None, {})
        if axis.get("shown_in") != "deg":
            continue
        at, values = axis["at"], entry["values"]
        for i in range(1, len(values) - 1):
            a, b, c = values[i - 1 : i + 2]
            if None not in (a, b, c) and (b - a) * (c - b) < 0:
                yield at[i] + 0.5 * (at[i + 1] - at[i]) * (a - c) / (a - 2 * b + c)


def resultants_of(entries):
    """Of components along x and y, at each position."""
    for key, entry in entries.items():
        if key.split(".")[-1] in ("F_x", "R_x"):
            other = values_of(entries.get(key[:-1] + "y"))
            for x, y in zip(values_of(entry), other):
                if None not in (x, y):
                    yield entry.get("unit"), math.hypot(x, y)


def numbers_in(node, unit, found):
    """All numbers of the JSON by their unit."""
    if isinstance(node, dict):
        unit = None if isinstance(node.get("shown_in"), str) else node.get("unit", unit)
        for value in node.values():
            numbers_in(value, unit, found)
        for one, value in resultants_of(node):
            found.setdefault(one, []).append(value)
        if "values" in node:
            found.setdefault(ALIKE.get(unit, unit), []).extend(peaks_of(node["values"]))
    elif isinstance(node, list):
        for value in node:
            numbers_in(value, unit, found)
    elif isinstance(node, (int, float)) and not isinstance(node, bool):
        found.setdefault(ALIKE.get(unit, unit), []).append(node)


def numbers_of(data):
    """Loads also with the application factor of their step, as figures show them."""
    all_found = {}
    numbers_in(data, None, all_found)
    for step in data["steps"]:
        factor = (values_of(step["inputs"].get("K_A")) or [1])[0]
        all_found.setdefault("rad", []).extend(positions_of_peaks(step))
        own = {}
        numbers_in(step, None, own)
        for unit in ("N", "N*m"):
            all_found.setdefault(unit, []).extend(factor * value for value in own.get(unit, []))
    return all_found


def plain(text):
    text = re.sub(r"<span class=bar[^>]*></span>|<(?:wbr|/?[bi]|/?su[bp]|/?tspan[^>]*|/?span[^>]*)>", "", text)
    return html.unescape(re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", text))).strip()


def tables_of(page):
    for table in re.findall(r"<table.*?</table>", page, re.S):
        rows = re.findall(r"<tr>(.*?)(?=<tr>|<tbody>|</table>)", table, re.S)
        yield [[plain(cell) for cell in re.split(r"<t[dh][^>]*>", row)[1:]] for row in rows]


def same_mode(row, mode):
    component, title, _, _, used = row
    step = mode["step"].replace("_", " ")
    is_named = title.startswith(mode["meaning"].split(" (")[0][:12]) or component == step
    return mode.get("utilisation") is not None and is_named and shows(used, mode["utilisation"])


def governing(page, modes, report):
    for rows in tables_of(page):
        if not rows or len(rows[0]) < 5 or rows[0][-1] != "Utilisation":
            continue
        for row in rows[1:]:
            used = re.match(NUMBER, row[-1])
            if not used:
                continue
            row[-1] = used.group()
            fitting = [mode for mode in modes if same_mode(row, mode)]
            if not fitting:
                report("no mode with the utilisation of: " + " | ".join(row))
                continue
            pair = PAIR.match(row[2])
            if pair and not any(pair_of(pair, mode) for mode in fitting):
                report("other demand or capacity: " + " | ".join(row))


def pair_of(pair, mode):
    if "demand" not in mode:  # of two safety factors only the utilisation is given
        (demand, half), (capacity, other) = number_of(pair.group(1)), number_of(pair.group(2))
        return (demand - half) / (capacity + other) <= mode["utilisation"] <= (demand + half) / (capacity - other)
    _, factor = UNITS.get(pair.group(3) or "", ("", 1.0))
    return shows(pair.group(1), mode["demand"]["value"], factor) and shows(pair.group(2), mode["capacity"]["value"], factor)


def verdict(page, data, report):
    finding = plain(re.search(r'<p class="?finding.*?(?=<div|</p>)', page, re.S).group())
    if not finding.startswith(data["headline"]):
        report("other headline: " + finding)
    words = {"pass": "passes", "not considered": "not_considered", "accepted by user": "accepted", "fail": "fails"}
    for word, key in words.items():
        for count in re.findall(rf"(?<![\d.])(\d+) {word}\b", finding):
            if int(count) != data[key]:
                report(f"{count} {word}, in the JSON {data[key]}: {finding}")
    for used in re.findall(r"highest utilisation ([\d.]*\d)", finding):
        if not any(shows(used, mode["utilisation"]) for mode in data["modes"] if mode.get("utilisation") is not None):
            report("no mode with the highest utilisation " + used)


def quantities(page, found, report):
    page = re.sub(r"<p class=\"?note\"?>\* sized.*?(?=<p|</section)", "", page, flags=re.S)  # of sizes that were tried
    page = re.sub(r"<(title|desc)>.*?</\1>|<header.*?</header>", "", page, flags=re.S)
    page = re.sub(r"<text[^>]*class=\"?quiet\"?[^>]*>.*?</text>", "", page, flags=re.S)  # scales
    texts = [plain(text) for text in re.findall(r"<text.*?</text>", page, re.S)]
    texts += [plain(text) for text in re.split(r"</?(?:p|td|tr|table|h2|section|div|figcaption|small)\b[^>]*>",
                                               re.sub(r"<svg.*?</svg>", "", page, flags=re.S))]
    for text in texts:
        if "values." in text:  # the JSON has no [values]
            continue
        for shown, unit in QUANTITY.findall(text):
            si, factor = UNITS[unit]
            if not any(shows(shown, value, factor) for value in found.get(si, []) + found.get(None, [])):
                report(f"{shown} {unit} is not in the JSON: {text[:90]}")


def differences(program, file):
    all_found = []
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "r.html")
        subprocess.run([program, "run", file, "--quiet", "--brief", "--report", report], capture_output=True, check=False)
        run = subprocess.run([program, "run", file, "--json"], capture_output=True, text=True, check=False)
        if not os.path.exists(report) or not run.stdout.startswith("{"):
            return None
        with open(report, encoding="utf-8") as stream:
            page = stream.read()
    page = page[page.index("<body"):]
    page = page[:[m.start() for m in re.finditer(r'<section class="?sheet', page + '<section class=sheet')][1]]
    data = json.loads(run.stdout)
    if "verdict" in data:
        verdict(page, data["verdict"], all_found.append)
        governing(page, data["verdict"]["modes"], all_found.append)
    quantities(page, numbers_of(data), all_found.append)
    return all_found


def main(arguments):
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    program = arguments[0] if arguments else "build/release"
    if os.path.isdir(program):
        program = os.path.join(program, "cli", "loadpath")
    files = arguments[1:] or sorted(os.path.join("examples", name, "project.toml") for name in os.listdir("examples"))
    count = 0
    for file in files:
        if not os.path.exists(file):
            continue
        for line in differences(program, file) or []:
            print(f"{file}: {line}")
            count += 1
    print("numbers of page 1 agree with the JSON" if count == 0 else f"{count} differences")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
