"""Kinds of faults, each drawn by lot for a case: what it does to a process, and which exit codes may come of it."""

import errno
import math
import signal
from dataclasses import dataclass, field

FULL, BROKEN, QUOTA = errno.ENOSPC, errno.EIO, errno.EDQUOT
INTERRUPTED = {130, -signal.SIGINT, -signal.SIGTERM}  # before the program listens, the signal ends it


@dataclass
class Fault:
    """`codes` are allowed beside that of an undisturbed run; None: of the latter none is expected."""

    words: str
    codes: set = field(default_factory=set)
    environment: dict = field(default_factory=dict)
    without: tuple = ()  # variables of the environment
    limits: list = field(default_factory=list)  # options of prlimit
    signals: list = field(default_factory=list)  # (seconds after the last one, signal)
    streams: dict = field(default_factory=dict)  # "stdout" or "stderr": closed, full or gone
    second: tuple = None  # (seconds later, options of a second process)
    may_succeed: bool = True
    is_always_felt: bool = False


def call_struck(how, number, at, codes, words):
    return Fault(
        f"{words} at call {at}", codes, {"FAULTS_HOW": how, "FAULTS_NUMBER": str(int(number)), "FAULTS_AT": str(at)}
    )


def disk_full(known, lot):
    return call_struck(
        "stay", lot.choice((FULL, FULL, QUOTA)), lot.randint(1, known.calls), {1}, "no space from then on"
    )


def call_fails(known, lot):
    number = lot.choice((FULL, BROKEN, errno.EACCES))
    return call_struck("once", number, lot.randint(1, known.calls), {1}, errno.errorcode[number])


def short_write(known, lot):
    return call_struck("short", 0, lot.randint(1, known.calls), set(), "half a write")


def signal_at_call(known, lot):
    number = lot.choice((signal.SIGKILL, signal.SIGKILL, signal.SIGINT, signal.SIGTERM))
    codes = {-signal.SIGKILL} if number == signal.SIGKILL else INTERRUPTED
    return call_struck("signal", number, lot.randint(1, known.calls), codes, number.name)


def signal_at_moment(known, lot):
    number = lot.choice((signal.SIGKILL, signal.SIGINT, signal.SIGTERM))
    after = lot.uniform(0, 1.02 * known.seconds)
    codes = {-signal.SIGKILL} if number == signal.SIGKILL else INTERRUPTED
    return Fault(f"{number.name} after {after:.4f} s", codes, signals=[(after, number)])


def signals_in_a_row(known, lot):
    first, second = (lot.choice((signal.SIGINT, signal.SIGTERM)) for _ in range(2))
    after, between = lot.uniform(0, known.seconds), lot.choice((0, 0.001, 0.02, 0.6))
    return Fault(
        f"{first.name} after {after:.4f} s, {second.name} {between} s later",
        INTERRUPTED,
        signals=[(after, first), (between, second)],
    )


def read_only(known, lot):
    return Fault(
        "a folder in which nothing can be made",
        {1},
        {"FAULTS_HOW": "deny", "FAULTS_NUMBER": str(lot.choice((errno.EACCES, errno.EROFS)))},
    )


def stream(name, codes_of):
    def draw(known, lot):
        how = lot.choice(("closed", "full", "gone"))
        is_lost = name == "stdout" and known.case.prints
        return Fault(
            f"{name} is {how}", codes_of(is_lost), streams={name: how}, may_succeed=not is_lost, is_always_felt=True
        )

    return draw


def memory(known, lot):
    low, high = known.least_memory, max(1.05 * known.most_memory, 1.1 * known.least_memory)
    most = math.exp(lot.uniform(math.log(low), math.log(high)))
    # The netCDF library does not tell a lack of memory from a file that it cannot read.
    codes = {1, 3} if any(name.endswith(".nc") for name in known.before) else {1}
    return Fault(f"{most / 2**20:.1f} MB of addresses", codes, limits=[f"--as={int(most)}"])


def file_size(known, lot):
    most = int(math.exp(lot.uniform(0, math.log(2 * known.largest_file))))
    return Fault(f"files of {most} bytes at the most", {1}, limits=[f"--fsize={most}"])


def open_files(known, lot):
    most = lot.randint(4, 12)
    return Fault(f"{most} open files at the most", {1}, limits=[f"--nofile={most}"])


def threads(known, lot):
    most = lot.randint(0, 2)
    # The library that draws text gives up without a thread of its own.
    draws_text = known.case.verb == "plot" and known.case.place.endswith((".png", ".pdf"))
    codes = {1} if draws_text else set()
    return Fault(f"{most} threads at a time beside the first", codes, {"FAULTS_THREADS": str(most)})


def no_home(known, lot):
    how = lot.choice(("unset", "/proc/none", "relative", ""))
    homes = {} if how == "unset" else {"HOME": how}
    return Fault(f"HOME is {how or 'empty'}", set(), homes, without=("HOME", "XDG_CACHE_HOME"), is_always_felt=True)


def locale(known, lot):
    name = lot.choice(("tr_TR.UTF-8", "de_DE.UTF-8", "C", "no_SUCH", "\xff"))
    return Fault(f"LC_ALL={name!r}", set(), {"LC_ALL": name, "LANG": name, "LANGUAGE": name}, is_always_felt=True)


def two_at_once(known, lot):
    later = lot.uniform(0, 0.7 * known.seconds) * lot.choice((0, 1))
    seed = lot.choice((1, 2)) if known.case.verb in ("render", "compare", "trace") and not known.case.continues else 1
    return Fault(
        f"a second process {later:.4f} s later, of seed {seed}",
        {1, 2},
        second=(later, ("-s", str(seed)) if seed > 1 else ()),
        is_always_felt=True,
    )


# name: (draw, for which cases)
def any_case(case):
    return True


def made(case):
    return bool(case.place)


KINDS = {
    "disk full": (disk_full, made),
    "a call fails": (call_fails, made),
    "half a write": (short_write, made),
    "signal at a call": (signal_at_call, made),
    "signal at a moment": (signal_at_moment, any_case),
    "signals in a row": (signals_in_a_row, any_case),
    "read-only": (read_only, made),
    "stdout": (stream("stdout", lambda is_lost: {1} if is_lost else set()), any_case),
    "stderr": (stream("stderr", lambda is_lost: set()), any_case),
    "memory": (memory, any_case),
    "file size": (file_size, made),
    "open files": (open_files, any_case),
    "threads": (threads, any_case),
    "no home": (no_home, any_case),
    "locale": (locale, any_case),
    "two at once": (two_at_once, made),
}
SHARES = {
    "disk full": 4,
    "a call fails": 4,
    "signal at a call": 4,
    "signal at a moment": 4,
    "two at once": 2,
    "memory": 2,
    "file size": 2,
}
