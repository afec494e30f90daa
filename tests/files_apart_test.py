#!/usr/bin/env python3
"""Does each file include what it needs?  The presets compile the files of a folder together, and with
precompiled headers: there a file may live on what its neighbours include.  Here the compiler reads each alone.

  tests/files_apart_test.py FOLDER [--only REGEX] [CMAKE OPTION...]     FOLDER is configured, and nothing built in it
"""
import argparse
import json
import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parent.parent


def commands(folder, options):
    """The compiler's, by source file, for sources that are not generated."""
    subprocess.run(["cmake", "-S", REPOSITORY, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_UNITY_BUILD=OFF", "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON", *options],
                   check=True, stdout=subprocess.DEVNULL)
    entries = json.loads((folder / "compile_commands.json").read_text())
    return {entry["file"]: entry for entry in entries if Path(entry["file"]).exists()}


def complaint(entry):
    """Of the compiler, about one file; empty if it has none."""
    done = subprocess.run([*shlex.split(entry["command"]), "-fsyntax-only"], cwd=entry["directory"],
                          capture_output=True, text=True)
    return "" if done.returncode == 0 else done.stderr[:2000] or "the compiler failed"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", metavar="REGEX", default="", help="files whose path matches")
    arguments, options = parser.parse_known_args()
    found = {file: entry for file, entry in commands(arguments.folder.resolve(), options).items()
             if re.search(arguments.only, file)}
    if not found:
        sys.exit(f"no file matches {arguments.only}")
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        complaints = dict(zip(found, pool.map(complaint, found.values())))
    faults = {file: text for file, text in complaints.items() if text}
    for file, text in faults.items():
        print(f"{file} does not compile alone:\n{text}\n")
    print(f"{len(found)} files, {len(faults)} that do not compile alone")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
