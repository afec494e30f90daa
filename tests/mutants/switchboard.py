"""The catalogue behind switches: all bugs that fit in one build, and each then costs its tests alone."""
import json
import re
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from fnmatch import fnmatchcase
from pathlib import Path

from behind_switches import build, error_blocks, run_program, synchronize
from catalogue import REPOSITORY, Fault
from results import failures, of_patch, timed
from switched import rewritten, ways_of

SWITCH = re.compile(r"::wander_bugs::(?:on\(|chosen\(\) == )(\d+)")


class Switchboard:
    """The catalogue in `folder`; the number of a bug's switch is its place in it."""

    def __init__(self, folder, mutants, jobs, seconds):
        self.folder, self.mutants, self.jobs, self.seconds = folder, mutants, jobs, seconds
        self.copy = folder / "tree"
        self.ways = [ways_of(mutant) for mutant in mutants]
        self.kept = folder / "failed.json"  # how often each bug did not compile
        known = json.loads(self.kept.read_text()) if self.kept.exists() else {}
        self.failed = Counter({k: known.get(self.key(k), 0) for k in range(len(mutants))})
        self.written = {}  # the texts with switches
        self.limits = {}   # seconds that a filter may take

    def key(self, number):
        return f"{self.mutants[number].name} {of_patch(self.mutants[number])}"

    def fits(self, number):
        return self.failed[number] < len(self.ways[number])

    def plant(self, failed):
        by_file = {}
        for number, ways in enumerate(self.ways):
            if self.fits(number):
                for name, edits in ways[failed[number]].items():
                    by_file.setdefault(name, []).extend((number, edit) for edit in edits)
        self.kept.parent.mkdir(parents=True, exist_ok=True)
        self.kept.write_text(json.dumps({self.key(k): times for k, times in failed.items() if times}, indent=1))
        self.written = {name: rewritten((REPOSITORY / name).read_bytes(), wanted)
                        for name, wanted in by_file.items()}
        synchronize(self.copy, self.written)

    def blamed(self, log):
        """Bugs before whose switch the compiler found errors; or, if there are none, those it mentions at all."""
        found = set()
        for block in error_blocks(log):
            for what in (": error:", ""):
                places = re.findall(rf"{self.copy}/([^:\s]+):(\d+):(\d+){what}", block)
                blamed = {self.at(*place) for place in places} - {None}
                if blamed:
                    break
            found |= blamed
        for number in sorted(found):
            print(f"  {self.mutants[number].name}: does not compile behind its switch", flush=True)
        return found

    def at(self, name, line, column):
        """The bug whose switch is the last before a place, on its line."""
        lines = self.written.get(name, "").encode().split(b"\n")
        text = lines[int(line) - 1][:int(column) - 1].decode(errors="replace") if int(line) <= len(lines) else ""
        before = SWITCH.findall(text)
        return int(before[-1]) if before else None

    def build(self):
        self.copy.mkdir(parents=True, exist_ok=True)
        files = {str(file.with_suffix("")) for mutant in self.mutants for file in mutant.test_files()}
        self.failed = build(self.folder, self.plant, self.blamed, self.jobs,
                            rf"/tests/({'|'.join(sorted(files))})\.cpp$", self.failed)
        self.tests = {}
        for program in sorted((self.folder / "build/bin").glob("wander_*tests")):
            _, printed = run_program([program, "--gtest_list_tests"], 60)
            self.tests[program] = listed(printed)

    def commands(self, test):
        """Of the programs that hold tests of a filter."""
        holders = [program for program, names in self.tests.items()
                   if any(fnmatchcase(name, pattern) for name in names for pattern in test.split(":"))]
        if not holders:
            raise Fault(f"no test matches {test}")
        return [[program, f"--gtest_filter={test}"] for program in holders]

    def check_without_bugs(self, tests):
        """Tests must pass before a bug is on, or their failure says nothing; how long they take limits them later."""
        def one(test):
            failed, seconds = timed(lambda: failures(self.commands(test), self.seconds))
            self.limits[test] = min(self.seconds, 30 + 10 * seconds)
            return test, failed

        with ThreadPoolExecutor(self.jobs) as pool:
            bad = [f"{test}: {failed[0]}" for test, failed in pool.map(one, tests) if failed]
        if bad:
            raise Fault("fail without any bug\n" + "\n".join(bad))

    def attempt(self, number):
        """Names of the tests that fail with a bug."""
        test = self.mutants[number].test
        return failures(self.commands(test), self.limits[test], WANDER_BUG=str(number))


def listed(printed):
    """Full names in what --gtest_list_tests prints."""
    suite, names = "", []
    for line in printed.splitlines():
        name = line.split("#")[0].strip()
        if line.startswith("  "):
            names.append(suite + name)
        elif name.endswith("."):
            suite = name
    return names
