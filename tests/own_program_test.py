#!/usr/bin/env python3
"""The proof that a mutation can live outside the tree: docs/examples/own_program against the installed package.

Installs the build, configures the example with find_package, builds it, and `check` passes with its mutation; with a line of its
density forgotten, as docs/extending.md shows, `check` must fail with exit code 4.

  tests/own_program_test.py BUILD FOLDER [CMAKE_OPTION...]      builds in FOLDER, some minutes
"""
import pathlib
import shutil
import subprocess
import sys

EXAMPLES = pathlib.Path(__file__).resolve().parent.parent / "docs/examples"
FORGOTTEN = "density /= window_of(u).size();"
CHECK = "check gallery:article-1 --mutations bidirectional=1,sensor_slide=1 --samples 50k -q"


def run(*words, exit_code=0):
    done = subprocess.run([str(word) for word in words], text=True, stdout=subprocess.PIPE)
    print(f"$ {' '.join(map(str, words))}\n{done.stdout}", flush=True)
    if done.returncode != exit_code:
        sys.exit(f"own_program_test: exit code {done.returncode} instead of {exit_code}")
    return done.stdout


def main():
    build, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(EXAMPLES, folder / "examples")
    prefix, made, header = folder / "prefix", folder / "made", folder / "examples/sensor_slide.h"
    run("cmake", "--install", build, "--prefix", prefix)
    run("cmake", "-S", folder / "examples/own_program", "-B", made, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
        *sys.argv[3:])
    run("cmake", "--build", made)
    program = made / "wander-slide"
    run(program, *CHECK.split())
    assert "sensor_slide" in run(program, *"render gallery:article-1 -m mlt -b 50k --json -q".split())

    text = header.read_text()
    assert FORGOTTEN in text
    header.write_text(text.replace(FORGOTTEN, "density /= window_of(u).size() / window_of(u).size();"))
    run("cmake", "--build", made)
    run(program, *CHECK.split(), exit_code=4)


if __name__ == "__main__":
    main()
