#!/usr/bin/env python3
"""Mutation test: does a test notice when a formula is wrong?

Changes one sign, constant or comparison at a random place of the sources, builds, runs the tests until one fails, and
puts the place back. A mutant that every test passes is a hole in the tests, unless it computes the same. Two of three
mutants are made in the formulas of STEP, the others in plain code. With --rules, all are made in the fold of verdicts
and in the rules of kinds, which are conditions and tables: a condition negated, an early return left out, a row
dropped, an enumerator in place of another one.

Run it in a clean checkout after scripts/check.sh, whose build it takes:
  scripts/mutate.py --seed 1
  scripts/mutate.py --only 'lib/account/*,lib/project/references/*'
  cmake -G Ninja -B build/mutants -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS=-w && scripts/mutate.py --build build/mutants --rules
A mutant of --rules may have a warning ("&&" within "||"): its build has none.
Ctrl-C and SIGTERM leave the sources as they were.
"""
import argparse
import fnmatch
import itertools
import pathlib
import random
import re
import signal
import subprocess
import sys
import time
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
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
LIST = re.compile(r'(\bstd::array\b[^;={}()]*|\bfor \([^;{}()]*:\s*)\{+')
ENUMERATOR = re.compile(r'(?<![&\w])((?:\w+::)*[A-Z]\w*)::([a-z]\w*)\b(?![(<{]|::)')
UNREAD = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|^\s*(?:#|static_assert|case )[^\n]*', re.M)
RULES = ('lib/account/*', 'lib/quantity/kinds.cpp', 'lib/quantity/expression/kinds.cpp', 'lib/project/references/*',
         'lib/project/run/own_bounds.cpp', 'lib/project/sweep/points/bounds.cpp')
SUITE = re.compile(r'TEST_SUITE\("([^"]*)"')
# The suites that see every calculator, split by element (tests/parts.hpp).
NOTICING = ('contract', 'contract: evaluation', 'contract: formulas', 'contract: overload', 'laws', 'limits', 'limit cases')
LONGEST = 300  # seconds that a suite may take


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


# --- places -----------------------------------------------------------------------------------------------------------

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


def bare(text):
    """The text with blanks in place of what does not decide: words of messages, comments, labels."""
    return UNREAD.sub(lambda m: re.sub(r'[^\n]', ' ', m[0]), text)


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


def row_sites(path, seen):
    """Each row of a table, and each element that a loop names, left out with the comma next to it."""
    sites = []
    for found in LIST.finditer(seen):
        start, (end, commas) = found.end(), closing(seen, found.end())
        if seen[start:end].rstrip().endswith(','):
            end = commas.pop()
        bounds = [start, *(c + 1 for c in commas), end]
        if commas:
            sites += [Site(path, a, b, '') for a, b in zip(bounds, bounds[1:-1])]
            sites.append(Site(path, commas[-1], end, ''))
    return sites


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
    seen = bare(text)
    return [*condition_sites(path, text, seen), *row_sites(path, seen), *enumerator_sites(path, seen),
            *(Site(path, m.start(), m.end(), OTHER_OPERATOR[m[0]]) for m in OPERATOR.finditer(seen)),
            *code_sites(path, text)]


def sources(folders, patterns):
    """The sources of the folders whose path fits a pattern; in a pattern a star stands for slashes too."""
    paths = sorted({p for folder in folders for p in pathlib.Path(folder).rglob('*.[ch]pp')})
    return [p for p in paths if any(fnmatch.fnmatchcase(p.as_posix(), pattern) for pattern in patterns)]


def all_sites(paths):
    """The places in formulas, and those in code; how a picture looks is for the goldens."""
    formulas, code = [], []
    for path in paths:
        text = path.read_text()
        formulas += formula_sites(path, text)
        if not path.as_posix().startswith('lib/draw/'):
            code += code_sites(path, text)
    return formulas, code


def drawn(formulas, code, count):
    """Two of three from the formulas."""
    most = min(len(formulas), count * 2 // 3)
    sites = random.sample(formulas, most) + random.sample(code, min(len(code), count - most))
    random.shuffle(sites)
    return sites


# --- tests ------------------------------------------------------------------------------------------------------------

@dataclass(frozen=True)
class Tests:
    """The suites of the test program, each with the folders that hold it."""
    build: pathlib.Path
    suites: dict

    @classmethod
    def of(cls, build):
        suites = {}
        for path in sorted(pathlib.Path('tests').rglob('*.cpp')):
            for name in SUITE.findall(path.read_text()):
                suites.setdefault(name, set()).add(path.parent.parts[1:])
        return cls(build, suites)

    def in_order_for(self, path):
        """The likeliest to notice a change of this source first: its own folder's, then those of every calculator."""
        def nearness(suite):
            return max(sum(1 for _ in itertools.takewhile(lambda pair: pair[0] == pair[1], zip(folder, path.parts)))
                       for folder in self.suites[suite])
        noticed = path.parts[0] == 'calculators'
        return sorted(self.suites, key=lambda s: (-max(nearness(s), 1.5 if noticed and s in NOTICING else 0), s))

    def commands_for(self, path):
        program = [str(self.build / 'tests/loadpath_tests'), '--abort-after=1']
        own = [[*program, f'--test-suite={suite}'] for suite in self.in_order_for(path)]
        verify = [str(self.build / 'cli/loadpath'), 'verify']
        if path.parts[0] != 'calculators':
            return [*own, verify]
        part = ['env', f'LOADPATH_PART={path.parts[1]}', *program]  # its own element takes a tenth of the time
        near = [[*part, f'--test-suite={suite}'] for suite in NOTICING] if len(path.parts) > 2 else []
        return [verify, *near, *own]


def passes(command):
    try:
        return subprocess.run(command, capture_output=True, timeout=LONGEST).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def first_failure(commands, jobs):
    """The first command that fails, with `jobs` at a time; nothing where all pass."""
    left = iter(commands)
    with ThreadPoolExecutor(jobs) as pool:
        running = {pool.submit(passes, c): c for c in itertools.islice(left, jobs)}
        while running:
            done, _ = wait(running, return_when=FIRST_COMPLETED)
            for result in done:
                command = running.pop(result)
                if not result.result():
                    return command
                running |= {pool.submit(passes, c): c for c in itertools.islice(left, 1)}
    return None


def builds(build):
    targets = ['loadpath', 'loadpath_tests']
    return subprocess.run(['cmake', '--build', build, '--target', *targets], capture_output=True).returncode == 0


def verdict_of(site, tests, jobs):
    """What becomes of a mutant: "killed by ...", "SURVIVED", "does not build"."""
    text = site.path.read_text()
    site.path.write_text(site.mutated(text))
    try:
        if not builds(tests.build):
            return 'does not build'
        killer = first_failure(tests.commands_for(site.path), jobs)
        return f"killed by {killer[-1].removeprefix('--test-suite=')}" if killer else 'SURVIVED'
    finally:
        site.path.write_text(text)


# --- the run ----------------------------------------------------------------------------------------------------------

def options():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument('--build', type=pathlib.Path, default=pathlib.Path('build/release'), help='folder of the build')
    p.add_argument('--count', type=int, default=50, help='mutants')
    p.add_argument('--seed', type=int, default=1, help='which ones; the same seed draws the same from the same sources')
    p.add_argument('--where', default='calculators,lib', help='folders, with commas between them')
    p.add_argument('--only', default='*', help="sources, by patterns with commas between them: 'lib/account/*'")
    p.add_argument('--rules', action='store_true', help='mutants of the rules alone, by their own operators')
    p.add_argument('--jobs', type=int, default=2, help='suites that run at a time')
    p.add_argument('--seconds', type=float, default=7200, help='no further mutant after so long')
    p.add_argument('--least', type=float, default=0, help='percent that must be killed, or it exits with 1')
    return p.parse_args()


def check_start(build):
    """Every test must pass before: a mutant would be killed for nothing otherwise."""
    if subprocess.run(['git', 'diff', '--quiet', '--', 'calculators', 'lib']).returncode:
        sys.exit('error: calculators or lib has changes: commit them first')
    if not builds(build):
        sys.exit(f'error: {build} does not build')


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that the place is put back
    o = options()
    paths = sources(o.where.split(','), RULES if o.rules and o.only == '*' else o.only.split(','))
    if not paths:
        sys.exit(f'error: no source in {o.where} fits --only {o.only}')
    check_start(o.build)
    tests = Tests.of(o.build)
    if failed := first_failure(tests.commands_for(pathlib.Path('calculators')), o.jobs):
        sys.exit(f"error: fails before anything is changed: {' '.join(failed)}")
    random.seed(o.seed)
    print(f'seed {o.seed}', flush=True)
    formulas, code = ([], [s for p in paths for s in rule_sites(p, p.read_text())]) if o.rules else all_sites(paths)
    print(f'{len(formulas)} places in formulas, {len(code)} in code', flush=True)
    killed = survived = 0
    begun = time.monotonic()
    for site in drawn(formulas, code, o.count):
        if time.monotonic() - begun > o.seconds:
            break
        described = site.described(site.path.read_text())
        verdict = verdict_of(site, tests, o.jobs)
        killed += verdict.startswith('killed')
        survived += verdict == 'SURVIVED'
        print(f'{verdict}: {described}', flush=True)
    share = 100 * killed / max(killed + survived, 1)
    print(f'{killed} of {killed + survived} mutants killed: {share:.1f} %; {time.monotonic() - begun:.0f} s')
    sys.exit(share < o.least)


main()
