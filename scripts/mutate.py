#!/usr/bin/env python3
"""Mutation test: does a test notice when a formula or a rule is wrong?

Changes one sign, constant or comparison at a random place of the sources, builds, runs the tests until one fails, and
puts the place back. A mutant that every test passes is a hole in the tests, unless it computes the same. Two of three
mutants are made in the formulas of STEP, the others in plain code. Ctrl-C and SIGTERM leave the sources as they were.

With --rules, all are made in the fold of verdicts and in the rules of kinds, which are conditions and tables: a
condition negated, an early return left out, a row dropped, an enumerator in place of another one. One build in
build/release/mutants holds them all, each behind a question whether it runs (mutants/schemata.py), and the sources stay
as they are. The suites of tests/lib and tests/found have to notice them, for --patience seconds a mutant.

Run it in a clean checkout after scripts/check.sh, whose build it takes:
  scripts/mutate.py --seed 1
  scripts/mutate.py --rules --count 300
  scripts/mutate.py --rules --only 'lib/project/references/*'
"""
import argparse
import collections
import os
import pathlib
import random
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

from mutants.places import code_sites, formula_sites, sources
from mutants.program import Program
from mutants.suites import Suites, command_of, first_failure, ran, times_of

RULES = ('lib/account/*', 'lib/quantity/kinds.cpp', 'lib/quantity/expression/kinds.cpp',
         'lib/quantity/expression/conversions.hpp', 'lib/project/references/kinds.cpp')
# The suites that see every calculator, split by element (tests/parts.hpp).
NOTICING = ('contract', 'contract: evaluation', 'contract: formulas', 'contract: overload', 'laws', 'limits', 'limit cases')


def builds(build):
    targets = ['loadpath', 'loadpath_tests']
    return subprocess.run(['cmake', '--build', build, '--target', *targets], capture_output=True).returncode == 0


# --- a build for each mutant ------------------------------------------------------------------------------------------

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


def commands_for(path, suites, build):
    """The likeliest to notice a change of this source first: its own folder's, then those of every calculator."""
    program, verify = build / 'tests/loadpath_tests', [str(build / 'cli/loadpath'), 'verify']
    is_calculator = path.parts[0] == 'calculators'
    order = sorted(suites.folders, key=lambda s: (
        -max(suites.nearness(s, path), 1.5 if is_calculator and s in NOTICING else 0), s))
    own = [command_of(program, suite) for suite in order]
    if not is_calculator:
        return [*own, verify]
    part = ['env', f'LOADPATH_PART={path.parts[1]}']  # its own element takes a tenth of the time
    near = [[*part, *command_of(program, suite)] for suite in NOTICING] if len(path.parts) > 2 else []
    return [verify, *near, *own]


def verdict_of(site, suites, build, jobs):
    """What becomes of a mutant: "killed by ...", "SURVIVED", "does not build"."""
    text = site.path.read_text()
    site.path.write_text(site.mutated(text))
    try:
        if not builds(build):
            return 'does not build'
        killer = first_failure(commands_for(site.path, suites, build), jobs)
        return f"killed by {killer[-1].removeprefix('--test-suite=')}" if killer else 'SURVIVED'
    finally:
        site.path.write_text(text)


def judged_by_builds(o, paths):
    """The verdict of each mutant."""
    if subprocess.run(['git', 'diff', '--quiet', '--', 'calculators', 'lib']).returncode:
        sys.exit('error: calculators or lib has changes: commit them first')
    if not builds(o.build):
        sys.exit(f'error: {o.build} does not build')
    suites = Suites()
    if failed := first_failure(commands_for(pathlib.Path('calculators'), suites, o.build), o.jobs):
        sys.exit(f"error: fails before anything is changed: {' '.join(failed)}")
    formulas, code = all_sites(paths)
    print(f'{len(formulas)} places in formulas, {len(code)} in code', flush=True)
    for site in drawn(formulas, code, o.count):
        yield site, verdict_of(site, suites, o.build, o.jobs)


# --- one build for all mutants ----------------------------------------------------------------------------------------

class Judge:
    """Runs the suites of the libraries with a mutant: near ones first, then those that are quick or have noticed one."""

    def __init__(self, program, patience, jobs):
        self.program, self.patience, self.suites = program, patience, Suites()
        names = [s for s, folders in self.suites.folders.items() if {f[0] for f in folders if f} & {'lib', 'found'}]
        self.times = times_of(program.file, names, patience, jobs)
        for name in sorted(set(names) - set(self.times)):
            print(f'left out, for it fails or takes long without a mutant: {name}', flush=True)
        self.noticed, self.lock = collections.Counter(), threading.Lock()

    def cost(self, suite, path):
        return self.times[suite] / (1 + self.noticed[suite, path]) / 30 ** self.suites.nearness(suite, path)

    def verdict_of(self, number):
        """What becomes of a mutant: "killed by ...", "SURVIVED"."""
        path, seconds = self.program.mutants[number].path, 0.0
        environment = {**os.environ, 'LOADPATH_MUTANT': str(number)}
        with self.lock:
            order = sorted(self.times, key=lambda suite: self.cost(suite, path))
        for suite in order:
            if seconds + self.times[suite] > self.patience:
                continue
            seconds += self.times[suite]
            if not ran(command_of(self.program.file, suite), environment, 5 + 5 * self.times[suite])[0]:
                with self.lock:
                    self.noticed[suite, path] += 1
                return f'killed by {suite}'
        return 'SURVIVED'


def judged_at_once(o, paths):
    """The verdict of each mutant."""
    if not builds(o.build):
        sys.exit(f'error: {o.build} does not build')
    program = Program(o.build, paths, o.jobs)
    count = len(program.mutants)
    print(f'{count} mutants of {len(paths)} sources; {program.places - count} more do not compile', flush=True)
    judge = Judge(program, o.patience, o.jobs)
    numbers = sorted(program.mutants)
    chosen = random.sample(numbers, min(o.count, len(numbers)))
    pool = ThreadPoolExecutor(o.jobs)
    try:
        for number, verdict in zip(chosen, pool.map(judge.verdict_of, chosen)):
            yield program.mutants[number], verdict
    finally:
        pool.shutdown(cancel_futures=True)  # where the time is over


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
    p.add_argument('--patience', type=float, default=30, help='with --rules: seconds of suites until a mutant survives')
    p.add_argument('--least', type=float, default=0, help='percent that must be killed, or it exits with 1')
    return p.parse_args()


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that the place is put back
    o = options()
    paths = sources(o.where.split(','), RULES if o.rules and o.only == '*' else o.only.split(','))
    if not paths:
        sys.exit(f'error: no source in {o.where} fits --only {o.only}')
    random.seed(o.seed)
    print(f'seed {o.seed}', flush=True)
    begun, by_source = time.monotonic(), collections.defaultdict(collections.Counter)
    verdicts = (judged_at_once if o.rules else judged_by_builds)(o, paths)
    for site, verdict in verdicts:
        print(f'{verdict}: {site.described(site.path.read_text())}', flush=True)
        by_source[site.path.as_posix()][verdict.split(' by ')[0]] += 1
        if time.monotonic() - begun > o.seconds:
            break
    verdicts.close()
    all_ = sum(by_source.values(), collections.Counter())
    for source, counts in [*sorted(by_source.items()), ('all', all_)]:
        print(f"{source}: {counts['killed']} of {counts['killed'] + counts['SURVIVED']} mutants killed")
    share = 100 * all_['killed'] / max(all_['killed'] + all_['SURVIVED'], 1)
    print(f'{share:.1f} % killed; {time.monotonic() - begun:.0f} s')
    sys.exit(share < o.least)


main()
