"""The test program with all mutants of some sources, from a build tree that is up to date."""
import pathlib
import re
import shlex
import subprocess
from concurrent.futures import ThreadPoolExecutor

from mutants import places
from mutants.schemata import HEADER, Schema

UNITY = re.compile(r'#include "([^"]*)"')


class Program:
    """The mutants by their numbers, and the program that runs them."""

    def __init__(self, build, paths, jobs):
        self.build, self.root = build.resolve(), pathlib.Path.cwd()
        self.folder = self.build / 'mutants'
        texts = {path: path.read_text() for path in paths}
        sites = [site for path, text in texts.items() for site in dict.fromkeys(places.rule_sites(path, text))]
        self.sources = {path: text for path, text in texts.items() if any(site.path == path for site in sites)}
        self.mutants = dict(enumerate(sites, 1))
        self.places = len(sites)
        self.file = self.folder / 'loadpath_tests'
        self.compile_all(jobs)

    def compile_all(self, jobs):
        self.folder.mkdir(exist_ok=True)
        (self.folder / 'mutants.hpp').write_text(HEADER)
        commands = subprocess.run(['ninja', '-C', self.build, '-t', 'commands', 'loadpath_tests'], capture_output=True,
                                  text=True, check=True).stdout.splitlines()
        units = [u for u in map(self.unit_of, commands) if u]
        failed = units
        while failed:
            self.write_sources()
            with ThreadPoolExecutor(jobs) as pool:
                results = list(pool.map(lambda unit: self.compiled(*unit), failed))
            failed = [unit for unit, errors in zip(failed, results) if errors]
            if failed:
                self.drop('\n'.join(results))
        link = shlex.split(commands[-1].split(' && ')[1])
        link[link.index('-o') + 1] = str(self.file)
        link[1:1] = ['-Wl,--allow-multiple-definition', *(str(o) for _, o in units)]  # the first definition counts
        subprocess.run(link, cwd=self.build, check=True)

    def unit_of(self, command):
        """The command that compiles a unit with mutants, and its object; nothing if it has none."""
        if not re.search(r' -o lib/.* -c ', command) or 'loadpath_written.dir' in command:  # what is written decides nothing
            return None
        words = shlex.split(command)
        source = pathlib.Path(words[-1])
        included = [pathlib.Path(p) for p in UNITY.findall(source.read_text())] if source.suffix == '.cxx' else [source]
        if not any(self.has_mutants(path) for path in included):
            return None
        target = self.folder / (source.relative_to(self.root).as_posix().replace('/', '_'))
        mutated = self.folder / 'sources'
        target.write_text(''.join(f'#include "{self.mutated(path) or path}"\n' for path in included))
        words = [w for w in words[:words.index('-MD')] if w != '-Winvalid-pch']
        words[1:1] = [f'-I{mutated}', '-include', str(self.folder / 'mutants.hpp')]
        return [*words, '-O0', '-w', '-c', str(target), '-o', f'{target}.o'], f'{target}.o'

    def mutated(self, path):
        relative = path.relative_to(self.root) if path.is_relative_to(self.root) else None
        return self.folder / 'sources' / relative if relative in self.sources else None

    def has_mutants(self, path):
        """Itself, or a header that it or its own header includes."""
        texts = [p.read_text() for p in (path, path.with_suffix('.hpp')) if p.exists()]
        return self.mutated(path) or any(pathlib.Path(h) in self.sources for text in texts for h in UNITY.findall(text))

    def write_sources(self):
        numbers = {site: number for number, site in self.mutants.items()}
        held = set()
        for path, text in self.sources.items():
            schema = Schema(path, text, {site: n for site, n in numbers.items() if site.path == path})
            held |= schema.held
            place = self.folder / 'sources' / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(schema.source)
        self.mutants = {number: site for number, site in self.mutants.items() if number in held}

    @staticmethod
    def compiled(command, _):
        return subprocess.run(command, capture_output=True, text=True).stderr

    def drop(self, errors):
        """Leaves out what does not compile: the mutants that errors name, or else the lists of the lines that they name."""
        wrong = {int(n) for n in re.findall(r'^mutant:(\d+):\d+: error', errors, re.M)} & set(self.mutants)
        for path, line in re.findall(r'^([^\s:]+):(\d+):\d+: error', errors, re.M) if not wrong else []:
            wrong |= self.rows_near(pathlib.Path(path), int(line))
        if not wrong:
            raise SystemExit(f'error: the mutants do not compile:\n{errors[:4000]}')
        self.mutants = {number: site for number, site in self.mutants.items() if number not in wrong}

    def rows_near(self, path, line):
        """The rows of the list that begins last before a line."""
        text = self.sources.get(path, '')
        begun = [f.start() for f, _, _ in places.lists(places.bare(path, text)) if text.count('\n', 0, f.start()) < line]
        return {n for n, site in self.mutants.items()
                if site.path == path and not site.new and begun and site.start >= begun[-1]}
