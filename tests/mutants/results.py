"""What became of the planted bugs: kept while they are tried, recorded in last_run.json, and said in docs/mutants.md."""
import hashlib
import json
import re
import subprocess
import time
from pathlib import Path

from behind_switches import run_program
from catalogue import REPOSITORY, TESTS, Fault

RECORD = Path(__file__).resolve().parent / "last_run.json"


def failures(commands, seconds, **environment):
    """Names of the tests that fail, crash or give no answer; that no test runs is a Fault."""
    failed, ran = [], 0
    for command in commands:
        code, printed = run_program([*command, "--gtest_fail_fast"], seconds, **environment)
        started = re.findall(r"^\[ RUN      \] (\S+)", printed, re.MULTILINE)
        ran += len(started)
        named = re.findall(r"^\[  FAILED  \] (\S+?),? .*\(\d+ ms\)$", printed, re.MULTILINE)
        last = started[-1] if started else Path(command[0]).name
        if code is None:
            failed.append(f"{last} (no answer within {seconds:.0f} s)")
        elif code != 0:
            failed += named or [f"{last} (crashed)"]
    if ran == 0 and not failed:
        raise Fault(f"no test ran: {' '.join(map(str, commands[0]))}")
    return failed


def timed(work):
    """(what it returns, seconds)"""
    begin = time.monotonic()
    return work(), time.monotonic() - begin


def digest(*texts):
    return hashlib.sha256(b"\0".join(texts)).hexdigest()[:16]


def of_patch(mutant):
    """Of what it changes, wherever that stands, and of the test that it names."""
    _, _, diff = mutant.path.read_text().partition("\n+++ ")
    changes = [line for line in diff.splitlines()[1:] if line.startswith(("+", "-"))]
    return digest(mutant.test.encode(), *(line.encode() for line in changes))


def of_tests(mutant):
    return digest(*((TESTS / file).read_bytes() for file in mutant.test_files()))


def of_program():
    """Of all that is compiled but the tests, which are those of single bugs: results are of no other program."""
    files = (path for room in sorted(REPOSITORY.iterdir()) if room.is_dir() and room.name not in ("build", ".git")
             for path in sorted(room.rglob("*")) if path.suffix in (".h", ".cpp"))
    return digest(*(path.read_bytes() for path in files if not path.name.endswith("_test.cpp")))


def commit():
    done = subprocess.run(["git", "-c", "safe.directory=*", "-C", REPOSITORY, "rev-parse", "--short", "HEAD"],
                          capture_output=True, text=True)
    return done.stdout.strip() or "unknown"


class Results:
    """In a file that is written at each result, so that a run that was stopped goes on where it was."""

    def __init__(self, path):
        self.path = path
        kept = json.loads(path.read_text()) if path.exists() else {}
        program = of_program()
        if kept.get("program") != program:
            kept = {"program": program, "commit": commit(), "bugs": {}}
        self.kept = kept
        self.asked = {}  # bugs as they were when they were asked for

    def of(self, mutant):
        """What is known of a bug as it is now planted and tested, or None."""
        asked = self.asked.setdefault(mutant.name, {"patch": of_patch(mutant), "tests": of_tests(mutant)})
        found = self.kept["bugs"].get(mutant.name, {})
        return found if asked.items() <= found.items() else None

    def add(self, mutant, way, caught, seconds):
        self.kept["bugs"][mutant.name] = {**self.asked[mutant.name], "way": way, "caught": caught,
                                          "seconds": round(seconds, 1)}
        self.kept["date"] = time.strftime("%Y-%m-%d", time.gmtime())
        half = self.path.with_suffix(".half")
        half.write_text(json.dumps(self.kept, indent=1) + "\n")
        half.replace(self.path)

    def record(self):
        if "date" not in self.kept:
            raise Fault(f"{self.path}: holds no results of this program")
        bugs = ",\n".join(f"  {json.dumps(name)}: {json.dumps({key: bug[key] for key in ('way', 'caught', 'patch')})}"
                         for name, bug in sorted(self.kept["bugs"].items()))
        RECORD.write_text(f'{{\n "date": "{self.kept["date"]}",\n "commit": "{self.kept["commit"]}",\n'
                          f' "bugs": {{\n{bugs}\n }}\n}}\n')


def sentence(mutants):
    """Of the last run that was recorded."""
    if not RECORD.exists():
        return "No run of all of them has been recorded."
    kept = json.loads(RECORD.read_text())
    known = {m.id: kept["bugs"][m.name] for m in mutants
             if m.name in kept["bugs"] and kept["bugs"][m.name]["patch"] == of_patch(m)}
    caught = [bug for bug in known.values() if bug["caught"]]
    apart = sum(bug["way"] == "planted" for bug in caught)
    alive = [id for id, bug in known.items() if not bug["caught"]]
    said = (f"The run of {kept['date']}, of commit `{kept['commit']}`, caught {len(caught)} of {len(mutants)}:"
            f" {len(caught) - apart} behind switches, {apart} in a build of their own")
    said += f"; {', '.join(alive)} survived" if alive else "; none survived"
    untried = len(mutants) - len(known)
    return said + (f", {untried} were not tried as they are now." if untried else ".")
