"""What is known of a case before it is disturbed: what it makes, and what that takes of time, calls and memory."""

import shutil
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path

from cases import Case, write_scenes
from judging import files_of, is_kept, is_temporary, printed
from kinds import Fault
from outputs import content, fault_of


class Unfit(Exception):
    """A case that does not do undisturbed what it must do."""


@dataclass
class Known:
    case: Case
    template: Path
    before: dict  # name: bytes
    files: set = field(default_factory=set)
    contents: list = field(default_factory=list)  # of each seed that may be at work, name: content
    printed: object = None
    code: int = 0
    seconds: float = 0
    calls: int = 1
    largest_file: int = 1
    most_memory: int = 0
    least_memory: int = 0


def fresh(template, folder):
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(template, folder)
    return folder


def require_whole(case, folder):
    for name, path in files_of(folder).items():
        if why := fault_of(path):
            raise Unfit(f"{case.name}: {name}: half a file without any fault: {why}")


def undisturbed(machine, case, known, folder, options=()):
    """The outcome, and the contents of what it makes."""
    fresh(known.template, folder)
    outcome = machine.run((*case.command, *options), folder)
    if outcome.code not in (0, 4):
        raise Unfit(f"{case.name}: exit code {outcome.code} without any fault: {outcome.err}")
    require_whole(case, folder)
    made = {
        name: content(path)
        for name, path in files_of(folder).items()
        if not is_kept(name)
        and not is_temporary(name)
        and name not in known.before
        or name.startswith(case.place + "/")
        or name == case.place
    }
    return outcome, {name: said for name, said in made.items() if not is_kept(name)}


def know(machine, case, folder):
    """Runs it three times; numbers that differ between the first two are a fault of their own."""
    template = folder.with_name("template-" + folder.name)
    template.mkdir(parents=True)
    write_scenes(template)
    for command in case.before:
        outcome = machine.run(command, template)
        if outcome.code != 0:
            raise Unfit(f"{case.name}: {' '.join(command)}: exit code {outcome.code}: {outcome.err}")
    known = Known(case, template, {name: path.read_bytes() for name, path in files_of(template).items()})
    first, contents = undisturbed(machine, case, known, folder)
    known.files = set(files_of(folder))
    known.largest_file = max(
        (p.stat().st_size for n, p in files_of(folder).items() if n not in known.before), default=1
    )
    second, again = undisturbed(machine, case, known, folder)
    if contents != again and not case.has_chance:
        raise Unfit(f"{case.name}: two runs differ: {[n for n in contents if contents[n] != again[n]]}")
    known.contents = [{n: said if again[n] == said else None for n, said in contents.items()}]
    if case.has_chance:
        known.contents = [{}]
    known.printed = printed(first) if printed(first) == printed(second) else None
    known.code, known.seconds, known.calls = first.code, min(first.seconds, second.seconds), max(1, first.calls)
    known.most_memory = most_memory(machine, case, fresh(template, folder))
    known.least_memory = machine.least_memory
    return known


def know_seed(machine, known, folder, options):
    """Adds what a second process of another seed makes."""
    known.contents.append(undisturbed(machine, known.case, known, folder, options)[1])


def most_memory(machine, case, folder):
    process = machine.start(case.command, folder, Fault("nothing"))
    most = 0
    while process.poll() is None:
        try:
            status = Path(f"/proc/{process.pid}/status").read_text()
            most = max(
                [most] + [1024 * int(line.split()[1]) for line in status.splitlines() if line.startswith("VmPeak")]
            )
        except (OSError, ValueError):
            break
        time.sleep(0.001)
    process.communicate()
    return most


def least_memory(machine):
    """With less the program cannot even be loaded."""
    low, high = 1 << 20, 1 << 30
    while high - low > 1 << 18:
        middle = (low + high) // 2
        command = machine.command(("--version",), Fault("little memory", limits=[f"--as={middle}"]))
        done = subprocess.run(command, capture_output=True)
        low, high = (low, middle) if done.returncode == 0 else (middle, high)
    return high
