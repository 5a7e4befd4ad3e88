#!/usr/bin/env python3
"""Counts words per 1,000 words of comment that make comments hard to read: WORDS, HEADLESS and SWEPT below.

Usage: python3 scripts/count_words.py [--max N] [--list] [PATH...]

Reads the C++ comments and Python `#` comments of the files that git tracks below the paths (default: api,
calculators, cli, lib, python, tests). Strings, code, paths, names in backquotes and quoted text do not count.
Prints one line per folder (two levels) and the total; `--list` prints each comment with a counted word as
FILE:LINE: WORDS: TEXT. `--max N` exits 1 if the total exceeds N per 1,000 words.
"""

import argparse
import collections
import io
import pathlib
import re
import subprocess
import sys
import tokenize

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ["api", "calculators", "cli", "lib", "python", "tests"]

WORDS = [
    r"told|tells?|telling",
    r"stands?|stood|standing",
    r"beside",
    r"whole",
    r"alone",
    r"holds? for",
    r"(?:asks?|asked|asking) for",
    r"(?:comes?|came|coming) (?:with|along)",
    r"(?<!there )is no(?! (?:longer|more|less)\b)",
    r"mend(?:s|ed|ing)?",
    r"feels?|felt|feeling",
    r"pulls?",
    r"senses? of",
    r"(?<!-)ways?",
    r"play",
    r"anew",
]
FORBIDDEN = re.compile(r"\b(?:" + "|".join(WORDS) + r")\b", re.IGNORECASE)
# Sentences that begin with a relative clause without a head, or with a genitive; a question may.
HEADLESS = re.compile(r"(?:^|(?<=[.!?:] ))(?:What|Of)\b(?![^.:]*\?)|^(?:what|of)\b")
# A point of a sweep is a point or a design, not a machine; counted in files with "sweep" in their path.
SWEPT = re.compile(r"\bmachines?(?!-)\b", re.IGNORECASE)
WORD = re.compile(r"[A-Za-z]+(?:['-][A-Za-z]+)*")

CPP = re.compile(
    r"""R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Za-z])'(?:\\.|[^'\\\n])+'"""
    r"""|(?P<line>//[^\n]*)|(?P<block>/\*.*?\*/)""",
    re.DOTALL,
)


def cpp_comments(text):
    """Yields (line, whether code precedes it, text) of each comment line."""
    for match in CPP.finditer(text):
        comment = match.group("line") or match.group("block")
        if not comment:
            continue
        line = text.count("\n", 0, match.start()) + 1
        trails = bool(text[text.rfind("\n", 0, match.start()) + 1 : match.start()].strip())
        for index, part in enumerate(comment.split("\n")):
            yield line + index, trails, re.sub(r"^\s*(?://[/!]?<?|/\*+!?<?|\*(?!/))|\*/\s*$", "", part).strip()


def python_comments(text):
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and not token.string.startswith("#!"):
            yield token.start[0], bool(token.line[: token.start[1]].strip()), token.string.lstrip("# ").strip()


def comments(path):
    """Yields (line, text) of each comment. After code, it continues in lines that do not begin with a capital."""
    text = path.read_text(encoding="utf-8")
    start, last, parts, behind = 0, 0, [], False
    for line, trails, part in python_comments(text) if path.suffix == ".py" else cpp_comments(text):
        if parts and (line != last + 1 or trails or not part or (behind and part[:1].isupper())):
            yield start, " ".join(parts)
            parts = []
        behind = trails or (behind and bool(parts))
        if part:
            start = start if parts else line
            parts.append(part)
        last = line
    if parts:
        yield start, " ".join(parts)


def plain(comment):
    return re.sub(r"`[^`]*`|\"[^\"]*\"|\b\w+(?:/\w+)+(?:\.\w+)?|\b\w+\.[ch]pp\b", "0", comment)


def found(path, comment):
    hits = [match.group() for match in HEADLESS.finditer(comment)]
    hits += [match.group().lower() for match in FORBIDDEN.finditer(comment)]
    if "sweep" in str(path):
        hits += [match.group().lower() for match in SWEPT.finditer(comment)]
    return hits


def rate(count, of):
    return 1000 * count / of if of else 0.0


def show(name, count, of):
    print(f"{name:30} {count:5} of {of:6} words: {rate(count, of):5.1f} per 1,000")


def main():
    arguments = argparse.ArgumentParser(description="Counts forbidden words per 1,000 words of comment.")
    arguments.add_argument("--max", type=float, metavar="N", help="exit 1 if the total exceeds N per 1,000 words")
    arguments.add_argument("--list", action="store_true", help="print each comment that counts")
    arguments.add_argument("paths", nargs="*", default=FOLDERS, help="files or folders")
    options = arguments.parse_args()

    tracked = subprocess.run(
        ["git", "ls-files", "-z", "--", *options.paths], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout.split("\0")
    words, hits = collections.Counter(), collections.Counter()
    for name in tracked:
        path = pathlib.Path(name)
        if path.suffix not in {".hpp", ".cpp", ".h", ".py"} or not (ROOT / path).is_file():
            continue
        folder = "/".join(path.parts[:-1][:2])
        for line, comment in comments(ROOT / path):
            text = plain(comment)
            words[folder] += len(WORD.findall(text))
            bad = found(path, text)
            hits[folder] += len(bad)
            if bad and options.list:
                print(f"{name}:{line}: {', '.join(bad)}: {comment}")

    for folder in sorted(words):
        show(folder, hits[folder], words[folder])
    show("total", sum(hits.values()), sum(words.values()))
    total = rate(sum(hits.values()), sum(words.values()))
    if options.max is not None and total > options.max:
        print(f"error: more than {options.max:g} per 1,000 words", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
