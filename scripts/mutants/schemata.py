"""All mutants of a source in one: each behind a question whether it is the one that runs.

The source of "return a && b;" becomes "return (mutants::is(7) ? (a || b) : (a && b));", where the environment variable
LOADPATH_MUTANT names the one that runs. Each mutant is on a line of its own of the file "mutant", so that an error of
the compiler names it.
"""
import re

from mutants import places

HEADER = '''#pragma once
#include <cstdlib>
#include <initializer_list>
#include <type_traits>
#include <vector>
namespace mutants {
inline bool runs(int number) {
  static const char* const text = std::getenv("LOADPATH_MUTANT");
  static const int which = text == nullptr ? 0 : std::atoi(text);
  return number == which;
}
constexpr bool is(int number) { return !std::is_constant_evaluated() && runs(number); }
/// The elements of a list without the one that the mutant leaves out.
template <class T>
std::vector<T> rows(int first, std::initializer_list<T> all) {
  std::vector<T> left;
  for (const T& row : all) {
    if (!runs(first++)) left.push_back(row);
  }
  return left;
}
}  // namespace mutants
'''
ASSIGNMENT = re.compile(r'(?<![=!<>])=(?!=)')
CONSTANT = re.compile(r'\bconstexpr\b')
NESTING = {'(': 1, '[': 1, '{': 1, ')': -1, ']': -1, '}': -1}


def is_border(seen, at):
    """Whether an expression ends here, outside of its brackets."""
    is_label = seen[at] == ':' and ':' not in (seen[at - 1], seen[at + 1])
    return seen[at] in ',;?' or is_label or ASSIGNMENT.match(seen, at) or seen.endswith('return ', 0, at + 1)


def begins_before(seen, at):
    """Where the expression begins whose operator is here: behind a bracket, a comma, an assignment, a return."""
    depth = 0
    while at > 0 and depth >= 0:
        at -= 1
        depth -= NESTING.get(seen[at], 0)
        if depth == 0 and is_border(seen, at):
            break
    return at + len(re.compile(r'.\s*', re.S).match(seen, at)[0])


def ends_behind(seen, at):
    """Where it ends."""
    depth = 0
    while at < len(seen):
        depth += NESTING.get(seen[at], 0)
        if depth < 0 or (depth == 0 and is_border(seen, at)):
            break
        at += 1
    return at


class Schema:
    """A source with those of its mutants that have a number."""

    def __init__(self, path, text, numbers):
        self.path, self.text, self.numbers, self.held = path, text, numbers, set()
        seen = places.bare(path, text)
        regions = {}  # bounds of an expression -> its mutants
        listed = {}   # bounds of a list -> its beginning, its numbers
        for found, bounds, end in places.lists(seen):
            rows = [numbers.get(site) for site in places.row_sites(path, bounds)]
            if None not in rows:  # else one of them does not compile
                braces = len(found[0]) - len(found[0].rstrip('{'))
                listed[found.start(), end + braces] = found, end, rows
        for site, number in numbers.items():
            old = text[site.start:site.end]
            if site.new and re.match(r'[a-z]', site.new) and site.new.isidentifier():  # an enumerator
                bounds = next(m.span() for m in places.ENUMERATOR.finditer(seen) if m.start(2) == site.start)
            elif old in places.OTHER or old in places.OTHER_OPERATOR:
                bounds = begins_before(seen, site.start), ends_behind(seen, site.end)
            elif site.new:
                bounds = site.start, site.end
            else:
                continue  # a row
            regions.setdefault(bounds, []).append((number, site))
        places_ = [(a, -b, 1, regions[a, b]) for a, b in regions] + [(a, -b, 0, listed[a, b]) for a, b in listed]
        self.left = sorted(places_, key=lambda place: place[:3], reverse=True)
        self.source = released(f'#line 1 "{path}"\n' + self.written(0, len(text)), path.suffix == '.cpp')

    def written(self, start, end):
        parts, at = [], start
        while self.left and self.left[-1][0] < end:
            begin, minus_end, is_region, what = self.left.pop()
            if begin < at or -minus_end > end:
                continue  # it overlaps another one
            parts.append(self.text[at:begin])
            at = -minus_end
            parts.append(self.of_region(begin, at, what) if is_region else self.of_list(begin, at, *what))
        return ''.join(parts) + self.text[at:end]

    def of_region(self, begin, end, mutants):
        is_condition = any((site.start, site.end) == (begin, end) and '(' in site.new for _, site in mutants)
        as_type = 'bool' if is_condition else ''
        line = self.text.count('\n', 0, begin) + 1
        choice = ''
        for number, site in mutants:
            self.held.add(number)
            other = without_comments(self.text[begin:site.start] + site.new + self.text[site.end:end])
            choice += f'\n#line {number} "mutant"\n::mutants::is({number}) ? {as_type}({other}) : '
        return f'({choice}\n#line {line} "{self.path}"\n{as_type}({self.written(begin, end)}))'

    def of_list(self, begin, _, found, closing, rows):
        self.held.update(rows)
        inner = self.written(found.end(), closing)
        if found['loop']:
            return f"{found['loop']}::mutants::rows({rows[0]}, {{{inner}}})"
        of = f"<{found['of'].rsplit(',', 1)[0]}>" if found['of'] else ''
        call = f'::mutants::rows{of}({rows[0]}, {{{inner}}})'
        if not found['name']:
            return call
        is_global = begin == 0 or self.text[begin - 1] == '\n'
        before = 'inline ' if is_global and self.path.suffix == '.hpp' else 'static ' if 'static' in found['before'] else ''
        return f"{before}const std::vector {found['name']} = {call}"


def without_comments(text):
    kept = places.UNREAD.sub(lambda m: m[0] if m[0].startswith('"') else '' if m[0].startswith('//') else m[0], text)
    return kept.replace('\n', ' ')


def released(text, is_source):
    """The text with constants that hold mutants as variables, whose value is not fixed by the compiler."""
    parts, at = [], 0
    for found in CONSTANT.finditer(text):
        head = re.compile(r'[^(={;]*').match(text, found.end()).end()
        if found.start() < at or head >= len(text) or text[head] not in '={':
            continue
        end = ends_at_semicolon(text, head)
        if '::mutants::' not in text[head:end]:
            continue
        is_global = text[found.start() - 1] == '\n'
        inner = text[found.end():end]
        parts += [text[at:found.start()], 'const' if is_global else '',
                  inner.replace('::mutants::is(', '::mutants::runs(') if is_global and is_source else inner]
        at = end
    return ''.join(parts) + text[at:]


def ends_at_semicolon(text, at):
    depth = 0
    while text[at] != ';' or depth:
        depth += NESTING.get(text[at], 0)
        at += 1
    return at
