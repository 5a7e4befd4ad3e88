"""The suites of the test program, and which of them notice a mutant."""
import itertools
import os
import pathlib
import re
import subprocess
import threading
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait

SUITE = re.compile(r'TEST_SUITE\("([^"]*)"')
LONGEST = 300  # seconds that a suite may take


class Suites:
    """Each suite with the folders that hold it, below tests."""

    def __init__(self):
        self.folders = {}
        for path in sorted(pathlib.Path('tests').rglob('*.cpp')):
            for name in SUITE.findall(path.read_text()):
                self.folders.setdefault(name, set()).add(path.parent.parts[1:])

    def nearness(self, suite, path):
        """How many folders lead to both the suite and the source; more if the suite has the name of the source."""
        shared = max(sum(1 for _ in itertools.takewhile(lambda pair: pair[0] == pair[1], zip(folder, path.parts)))
                     for folder in self.folders[suite])
        return shared + 2 * (path.stem in suite)


def command_of(program, suite):
    return [str(program), '--abort-after=1', f'--test-suite={suite}']


def ran(command, environment=None, seconds=LONGEST):
    """Whether a command passes within so many seconds of a processor; then how many it took."""
    limited = ['prlimit', f'--cpu={int(seconds) + 1}', '--core=0', *command]
    process = subprocess.Popen(limited, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment)
    timer = threading.Timer(4 * LONGEST, process.kill)  # it waits for something
    timer.start()
    _, status, used = os.wait4(process.pid, 0)
    timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode == 0, used.ru_utime + used.ru_stime


def first_failure(commands, jobs):
    """The first command that fails, with `jobs` at a time; nothing where all pass."""
    left = iter(commands)
    with ThreadPoolExecutor(jobs) as pool:
        running = {pool.submit(ran, c): c for c in itertools.islice(left, jobs)}
        while running:
            done, _ = wait(running, return_when=FIRST_COMPLETED)
            for result in done:
                command = running.pop(result)
                if not result.result()[0]:
                    return command
                running |= {pool.submit(ran, c): c for c in itertools.islice(left, 1)}
    return None


def times_of(program, suites, longest, jobs):
    """Seconds of a processor that each suite takes; those that fail or take longer are left out."""
    with ThreadPoolExecutor(jobs) as pool:
        results = pool.map(lambda suite: ran(command_of(program, suite), seconds=longest), suites)
        return {suite: seconds for suite, (passed, seconds) in zip(suites, results) if passed}
