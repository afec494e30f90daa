"""Runs of `wander render`, each in a directory of its own: what is there and complete is kept.

A run that is there must be the run that is asked for: the same scene, method, seed and number of
samples.  Ctrl-C loses at most the run that is being made.

A Markov chain whose seed pass finds no light path has no film; such a run is passed over.
"""
import json
import math
import shlex
import signal
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

from study.film import InvalidInput, film_of, read_json

QUIET = ["-q", "--progress", "none"]

# Studied as methods: a method of the program, with options of render.  A film of `mlt` has the merits of
# independent samples, too; that of its chains alone has not.
VARIANTS = {"mlt-chains": ("mlt", ("--film", "chains"))}


class RunFailed(Exception):
    """The program failed; the text is what it said, the exit code that of the program."""

    def __init__(self, words, exit_code=1):
        super().__init__(words)
        self.exit_code = exit_code


class NoLightFound(RunFailed):
    """There may be light, but the program found none."""


@dataclass(frozen=True)
class Run:
    scene: str
    method: str
    samples: int
    seed: int
    directory: Path
    options: tuple = ()  # of render, beside these

    def record(self):
        """run.json, or None where the run has yet to be made.  Throws InvalidInput if it is another's."""
        file = self.directory / "run.json"
        if not file.exists():
            return None
        record = read_json(file)
        if record.get("complete") is not True:
            return None
        found = (record["scene"]["name"], record["method"], record["samples"], record["seed"])
        wanted = (self.scene, VARIANTS.get(self.method, (self.method,))[0], self.samples, self.seed)
        if found != wanted:
            raise InvalidInput(f"{file}: holds scene, method, samples, seed = {found}, where {wanted} is due; "
                               "move it away, or choose another --out")
        return record

    def film(self):
        record = self.record()
        return film_of(record) if record else None

    def command(self, program):
        method, own = VARIANTS.get(self.method, (self.method, ()))
        return [str(program), "render", f"gallery:{self.scene}", "-m", method, "-b", str(self.samples),
                "-s", str(self.seed), *own, *self.options]


def amount(text):
    """A number of samples: 1e7, 10M, 300k or 10000000.  Throws ValueError."""
    scale = {"k": 10**3, "M": 10**6, "G": 10**9}.get(text[-1:], 1)
    number = float(text if scale == 1 else text[:-1]) * scale
    if not 1 <= number <= 1e15 or number != int(number):
        raise ValueError(text)
    return int(number)


def short(samples):
    """10M for 10 000 000: names a directory."""
    for scale, letter in ((10**9, "G"), (10**6, "M"), (10**3, "k")):
        if samples % scale == 0:
            return f"{samples // scale}{letter}"
    return str(samples)


def duration(seconds):
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


def call(command):
    """Output of a command, which ends in peace on Ctrl-C.  Throws RunFailed with what it said."""
    if not Path(command[0]).exists():
        raise RunFailed(f"{command[0]}: no such program; build it: "
                        "cmake --preset release && cmake --build --preset release, or say --program")
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               start_new_session=True)
    try:
        out, said = process.communicate()
    except KeyboardInterrupt:
        process.send_signal(signal.SIGINT)
        process.communicate()
        raise
    if process.returncode != 0:
        failure = NoLightFound if "found no light path" in said else RunFailed
        raise failure(f"{shlex.join(command)}: exit {process.returncode}\n{said.strip()}", process.returncode)
    return out


class Rates:
    """Samples per second of each scene and method: as measured by the runs so far, else by a probe."""

    PROBE = 100_000

    def __init__(self, program):
        self.program = program
        self.rates = {}

    def learn(self, run, record):
        if record["seconds"] > 0:
            self.rates[run.scene, run.method] = record["samples"] / record["seconds"]

    def seconds(self, run):
        key = run.scene, run.method
        if key not in self.rates:
            self.probe(run)
        return run.samples / self.rates[key]

    def probe(self, run):
        small = Run(run.scene, run.method, min(self.PROBE, run.samples), run.seed, run.directory, run.options)
        self.rates[run.scene, run.method] = math.inf
        try:
            self.learn(small, json.loads(call(small.command(self.program) + ["--json", *QUIET])))
        except NoLightFound:
            pass  # a matter of an instant


def make(runs, program, minutes, say):
    """Makes the runs that are missing, in order; starts none after so many minutes (None: no limit)."""
    rates, missing = Rates(program), []
    for run in runs:
        record = run.record()
        if record:
            rates.learn(run, record)
        else:
            missing.append(run)
    say(f"{len(runs) - len(missing)} of {len(runs)} runs are there, {len(missing)} are missing")
    if not missing or minutes == 0:
        return
    left = sum(rates.seconds(run) for run in missing)
    say(f"they take about {duration(left)}" + (f", of which {minutes:g} min are allowed now" if minutes else ""))
    start = time.monotonic()
    for number, run in enumerate(missing, 1):
        if minutes is not None and time.monotonic() - start >= 60 * minutes:
            say(f"{minutes:g} min are over: {len(missing) - number + 1} runs remain; the same command goes on with them")
            return
        left = sum(rates.seconds(later) for later in missing[number - 1:])
        say(f"{number}/{len(missing)}  {run.scene} {run.method}, {short(run.samples)} samples, seed {run.seed}"
            f"  ({duration(left)} left)")
        try:
            call(run.command(program) + ["-o", str(run.directory), "--force", *QUIET])
            rates.learn(run, run.record())
        except NoLightFound:
            say("      found no light path: it has no film")
