"""One build of a copy of the tree whose bugs are behind switches (machine/switches.h), and runs with one of them on.

The bugs of a machine (machine/run) and those of the catalogue (run) are built and tried in the same way.
"""
import os
import re
import shutil
import subprocess
import tempfile
from collections import Counter
from pathlib import Path

from catalogue import REPOSITORY, Fault

SWITCHES = Path(__file__).resolve().parent / "machine/switches.h"
TARGETS = ["wander", "quick_tests"]
IGNORED = (".cache", ".git", "build", "results")


def files_below(folder):
    for place, folders, names in os.walk(folder):
        ignored = {"__pycache__", *(IGNORED if Path(place) == folder else ())}
        folders[:] = [f for f in folders if f not in ignored]
        for name in set(names) - ignored:
            yield (Path(place) / name).relative_to(folder)


def synchronize(copy, instead=None):
    """Makes `copy` equal to the tree but for the texts of `instead`; files that are equal already keep their times."""
    tree = set(files_below(REPOSITORY))
    for name in tree:
        source, target = REPOSITORY / name, copy / name
        text = (instead or {}).get(str(name))
        wanted = source.read_bytes() if text is None else text.encode()
        if target.is_file() and target.read_bytes() == wanted:
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(wanted)
        shutil.copymode(source, target)
    for name in set(files_below(copy)) - tree:
        (copy / name).unlink()


def build(folder, plant, blamed, jobs, test_files=".", failed=None):
    """Builds folder/tree, which `plant(failed)` writes, until it compiles; `failed` counts how often each bug did not.

    `test_files`: regular expression of those that are built.  `blamed(log)`: the bugs whose places a compiler's log
    names, without those that have been left out.
    """
    copy, made, failed = folder / "tree", folder / "build", Counter() if failed is None else failed
    log = folder / "build.log"
    long_tests = "_long_test" in test_files
    targets = [*TARGETS, "wander_long_tests"] if long_tests else TARGETS
    while True:
        plant(failed)
        configured = subprocess.run(
            ["cmake", "-S", copy, "-B", made, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
             f"-DWANDER_LONG_TESTS={'ON' if long_tests else 'OFF'}", "-DWANDER_BENCHMARKS=OFF",
             f"-DWANDER_TEST_FILES={test_files}",
             f"-DCMAKE_CXX_FLAGS=-std=c++20 -w -include {SWITCHES}"], text=True, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT)
        if configured.returncode != 0:
            raise Fault(f"{copy}: cannot be configured\n{configured.stdout[-4000:]}")
        with open(log, "w") as written:
            done = subprocess.run(["ninja", "-C", made, "-k0", f"-j{jobs}", *targets], stdout=written,
                                  stderr=subprocess.STDOUT)
        if done.returncode == 0:
            return failed
        failing = blamed(log.read_text(errors="replace"))
        if not failing:
            raise Fault(f"{copy}: does not compile, and no bug is to blame: {log}")
        failed.update(failing)


def error_blocks(log):
    """What a log says of each file that does not compile."""
    return [block for block in re.split(r"\n(?=FAILED: )", log) if "error:" in block]


def run_program(command, seconds, **environment):
    """(what it returns, or None if it lasts too long, and what it prints), in a folder of its own."""
    with tempfile.TemporaryDirectory() as place, open(Path(place) / "printed", "w+b") as printed:
        process = subprocess.Popen(command, cwd=place, stdout=printed, stderr=subprocess.STDOUT,
                                   start_new_session=True, env={**os.environ, **environment})
        try:
            code = process.wait(seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            process.wait()
            code = None
        printed.seek(0)
        return code, printed.read().decode(errors="replace")
