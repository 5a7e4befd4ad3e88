"""The places of mutants: what a mutant has in the place of a part of a source.

Formulas are those of STEP; a mutant has another sign or constant. Rules are conditions and tables: a condition negated,
an early return left out, a row dropped, an enumerator in place of another one, an operator in place of its opposite.
"""
import fnmatch
import pathlib
import re
from dataclasses import dataclass

STEP = re.compile(r'\b(STEP|STEP_TO|NAMED_STEP)\(')
SIGN = re.compile(r'(?<= )[+-](?= )')
CONSTANT = re.compile(r'(?<![\w.])\d+\.\d+(?![\w.])')
COMPARISON = re.compile(r'(?<= )[<>](?= )')
OTHER = {'+': '-', '-': '+', '<': '>', '>': '<'}
# What decides in a rule. A value or a function behind the colons of a class is no enumerator.
OPERATOR = re.compile(r'(?<= )(==|!=|&&|\|\||<=|>=)(?= )')
OTHER_OPERATOR = {'==': '!=', '!=': '==', '&&': '||', '||': '&&', '<=': '<', '>=': '>'}
CONDITION = re.compile(r'\bif \(')
EARLY = re.compile(r'\s*(return|continue|break)\b')
LIST = re.compile(r'(?P<before>(?:static |inline |constexpr |const )*)\bstd::array\b(?:<(?P<of>[^;={}()]*)>)?'
                  r'[ \n]*(?P<name>\w*)\{+|(?P<loop>\bfor \([^;{}()]*:\s*)\{+')
TABLE = re.compile(r'\bconstexpr std::array\b[^;]*;')
ENUMERATOR = re.compile(r'(?<![&\w])((?:\w+::)*[A-Z]\w*)::([a-z]\w*)\b(?![(<{]|::)')
UNREAD = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|^\s*(?:#|static_assert|case )[^\n]*', re.M)


@dataclass(frozen=True)
class Site:
    """A place of a source, and what a mutant has there."""
    path: pathlib.Path
    start: int
    end: int
    new: str

    def mutated(self, text):
        return text[:self.start] + self.new + text[self.end:]

    def described(self, text):
        """Place, and the line before and after."""
        first, last = text.rfind('\n', 0, self.start) + 1, text.find('\n', self.end)
        line = text[first:last].strip()
        after = (text[first:self.start] + self.new + text[self.end:last]).strip()
        return f"{self.path}:{text.count(chr(10), 0, self.start) + 1}\n    {line}\n    {after}"


def arguments(text, start):
    """The bounds of the arguments of a macro, from behind its opening parenthesis; then where it ends."""
    bounds, begun, depth, at = [], start, 1, start
    while depth:
        if text[at] == '"':
            at = re.compile(r'"(\\.|[^"\\])*"').match(text, at).end()
            continue
        depth += {'(': 1, ')': -1}.get(text[at], 0)
        if depth == 0 or (depth == 1 and text[at] == ','):
            bounds.append((begun, at))
            begun = at + 1
        at += 1
    return bounds, at


def steps(text):
    """The bounds of each STEP, and those of the formula in it."""
    for found in STEP.finditer(text):
        bounds, end = arguments(text, found.end())
        yield (found.start(), end), bounds[2 if found[1] == 'STEP_TO' else 1]


def swaps(pattern, path, text, start, end):
    return [Site(path, m.start(), m.end(), OTHER[m[0]]) for m in pattern.finditer(text, start, end)]


def formula_sites(path, text):
    """Every sign and every constant of a formula; the constant becomes larger by 3 %."""
    sites = []
    for _, (start, end) in steps(text):
        sites += swaps(SIGN, path, text, start, end)
        sites += [Site(path, m.start(), m.end(), repr(float(m[0]) * 1.03))
                  for m in CONSTANT.finditer(text, start, end) if float(m[0])]
    return sites


def is_plain(line):
    """Whether the line computes: no comment, no text, nothing for the preprocessor or the compiler alone."""
    return not (line.lstrip().startswith(('//', '#')) or '"' in line or 'template' in line)


def code_sites(path, text):
    """Signs and comparisons outside of formulas. Counting by one and by sizes is left: most of it would only crash."""
    sites, begun, formulas = [], 0, [bounds for bounds, _ in steps(text)]
    for line in text.splitlines(keepends=True):
        start, end = begun, begun + len(line.split(' // ')[0])
        begun += len(line)
        if not is_plain(line) or any(a < end and start < b for a, b in formulas):
            continue
        if 'size()' not in line:
            sites += [s for s in swaps(SIGN, path, text, start, end) if not re.match(r' 1\b', text[s.end:])]
        if re.search(r'\bif \(|\?', line) and 'for (' not in line:
            sites += swaps(COMPARISON, path, text, start, end)
    return sites


def blank(found):
    return re.sub(r'[^\n]', ' ', found[0])


def bare(path, text):
    """The text with blanks in place of what does not decide: words of messages, comments, labels. A table in a header may be
    a part of types, by its length."""
    seen = UNREAD.sub(blank, text)
    return TABLE.sub(blank, seen) if path.suffix == '.hpp' else seen


def closing(text, start):
    """Where the bracket closes that is open at the start; then the commas at its level."""
    depth, at, commas = 1, start, []
    while depth:
        depth += {'(': 1, '[': 1, '{': 1, ')': -1, ']': -1, '}': -1}.get(text[at], 0)
        if depth == 1 and text[at] == ',':
            commas.append(at)
        at += 1
    return at - 1, commas


def condition_sites(path, text, seen):
    """Each condition negated, and each early return left out."""
    sites = []
    for found in CONDITION.finditer(seen):
        start, (end, _) = found.end(), closing(seen, found.end())
        if re.search(r';|[^=!<>]=[^=]', re.sub(r'\[[=&]', '[ ', seen[start:end])):
            continue  # with a declaration
        sites.append(Site(path, start, end, f'!({text[start:end]})'))
        if EARLY.match(seen, end + 1):
            sites.append(Site(path, start, end, f'false && ({text[start:end]})'))
    return sites


def lists(seen):
    """Each list of several elements: how it begins, the bounds between its elements, where it closes."""
    for found in LIST.finditer(seen):
        end, commas = closing(seen, found.end())
        last = commas.pop() if commas and not seen[commas[-1] + 1:end].strip() else end
        if commas:
            yield found, [found.end(), *(c + 1 for c in commas), last], end


def row_sites(path, bounds):
    """Each row of a table, and each element that a loop names, left out with the comma next to it."""
    return [*(Site(path, a, b, '') for a, b in zip(bounds, bounds[1:-1])), Site(path, bounds[-2] - 1, bounds[-1], '')]


def enumerator_sites(path, seen):
    """Each enumerator replaced by the next one that the source has of its enumeration."""
    all_, sites = {}, []
    for found in ENUMERATOR.finditer(seen):
        all_.setdefault(found[1], {})[found[2]] = None
    for found in ENUMERATOR.finditer(seen):
        names = list(all_[found[1]])
        if len(names) > 1:
            sites.append(Site(path, found.start(2), found.end(2), names[(names.index(found[2]) + 1) % len(names)]))
    return sites


def rule_sites(path, text):
    """What a rule consists of: its conditions, comparisons, tables and enumerators."""
    seen = bare(path, text)
    rows = [site for _, bounds, _ in lists(seen) for site in row_sites(path, bounds)]
    return [*condition_sites(path, text, seen), *rows, *enumerator_sites(path, seen),
            *(Site(path, m.start(), m.end(), OTHER_OPERATOR[m[0]]) for m in OPERATOR.finditer(seen)),
            *code_sites(path, text)]


def sources(folders, patterns):
    """The sources of the folders whose path fits a pattern; in a pattern a star stands for slashes too."""
    paths = sorted({p for folder in folders for p in pathlib.Path(folder).rglob('*.[ch]pp')})
    return [p for p in paths if any(fnmatch.fnmatchcase(p.as_posix(), pattern) for pattern in patterns)]
