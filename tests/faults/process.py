"""Runs a command with a fault, and says what came of it."""

import os
import re
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

from kinds import Fault

PATIENCE = 120  # seconds; the commands take tenths


@dataclass
class Outcome:
    code: int
    out: bytes
    err: str
    is_struck: bool
    seconds: float = 0
    calls: int = 0
    second: "Outcome" = None

    def codes(self):
        return [self.code] + ([self.second.code] if self.second else [])


class Machine:
    """The program, the library that disturbs it, and the environment in which it runs."""

    def __init__(self, program, library, locales):
        self.program, self.library, self.locales = str(program), str(library), locales
        self.least_memory = 0  # with which the program can be loaded

    def environment(self, folder, fault):
        kept = {name: value for name, value in os.environ.items() if not name.startswith(("LC_", "LANG", "FAULTS_"))}
        kept.update(HOME=str(folder), XDG_CACHE_HOME=str(folder / "cache"), LOCPATH=str(self.locales), NO_COLOR="1")
        for name in fault.without:
            kept.pop(name, None)
        kept.update({"FAULTS_FOLDER": str(folder), "FAULTS_LOG": str(log_of(folder))}, **fault.environment)
        return kept

    def command(self, arguments, fault):
        # LD_PRELOAD is set by env, so that nothing but the program is disturbed.
        limits = ["prlimit", *fault.limits] if fault.limits else []
        closed = [name for name, how in fault.streams.items() if how == "closed"]
        redirections = " ".join({"stdout": ">&-", "stderr": "2>&-"}[name] for name in closed)
        shell = ["sh", "-c", f'exec "$@" {redirections}', "sh"] if closed else []
        return [*shell, *limits, "env", f"LD_PRELOAD={self.library}", self.program, *arguments]

    def start(self, arguments, folder, fault):
        streams, ends = {}, []
        for name in ("stdout", "stderr"):
            how = fault.streams.get(name)
            if how == "full":
                streams[name] = open("/dev/full", "wb")
            elif how == "gone":
                read, write = os.pipe()
                os.close(read)
                streams[name] = os.fdopen(write, "wb")
            else:
                streams[name] = subprocess.PIPE
            ends += [streams[name]] if how in ("full", "gone") else []
        process = subprocess.Popen(
            self.command(arguments, fault),
            cwd=folder,
            stdin=subprocess.DEVNULL,
            env=self.environment(folder, fault),
            start_new_session=True,
            **streams,
        )
        for end in ends:
            end.close()
        return process

    def run(self, arguments, folder, fault=None):
        fault = fault or Fault("nothing")
        log_of(folder).unlink(missing_ok=True)
        begin = time.monotonic()
        process = self.start(arguments, folder, fault)
        second = None
        if fault.second:
            time.sleep(fault.second[0])
            second = self.start((*arguments, *fault.second[1]), folder, fault)
        is_hit = send(process, fault.signals)
        outcome = finished(process)
        outcome.second = finished(second) if second else None
        outcome.seconds = time.monotonic() - begin
        notes = log_of(folder).read_text().splitlines() if log_of(folder).exists() else []
        outcome.is_struck = is_hit or fault.is_always_felt or any(n.startswith("struck") for n in notes)
        # A limit on the size of files holds for the log, too.
        outcome.calls = max((int(n.split()[1]) for n in notes if re.fullmatch(r"calls \d+", n)), default=0)
        return outcome


def log_of(folder):
    return Path(f"{folder}.log")


def send(process, signals):
    """True if the first one found the process alive."""
    is_hit = False
    for i, (after, number) in enumerate(signals):
        time.sleep(after)
        is_alive = process.poll() is None
        is_hit = is_hit or (i == 0 and is_alive)
        if is_alive:
            process.send_signal(number)
    return is_hit


def finished(process):
    try:
        out, err = process.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()
        out, err = process.communicate()
        return Outcome(-1000, out or b"", f"it did not end within {PATIENCE} s", False)
    return Outcome(process.returncode, out or b"", (err or b"").decode(errors="replace"), False)
