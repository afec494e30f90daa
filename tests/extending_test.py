#!/usr/bin/env python3
"""The proof of docs/extending.md.

In a copy of the program, the examples of docs/examples become a mutation, a shape and a method by the
changes that the page shows, and `wander check` passes with each.  On the way a line of a density is
forgotten, as the page shows, and `wander check` must fail with exit code 4.  What the page says that
the program prints, it prints.

  tests/extending_test.py FOLDER [CMAKE_OPTION...]      builds in FOLDER, many minutes
"""

import pathlib
import re
import shutil
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent
PAGE = (SOURCE / "docs/extending.md").read_text()
EXAMPLES = SOURCE / "docs/examples"
PARTS = "CMakeLists.txt LICENSE CITATION.cff statistics work core mlt mutations scenes schema records lab draw tools"


def fail(what):
    sys.exit(f"extending_test: {what}")


def changes():
    """The changes of the page, by the file that they are to."""
    blocks = re.findall(r"^```diff\n(.*?)^```$", PAGE, re.M | re.S)
    return {re.search(r"^\+\+\+ b/(\S+)$", block, re.M)[1]: block for block in blocks}


def shown(command, number):
    """What the page shows of a command: its place among those of the same words."""
    blocks = re.findall(r"^```console\n(.*?)^```$", PAGE, re.M | re.S)
    found = re.findall(rf"^\$ wander {re.escape(command)}\n(.*?)(?=^\$|\Z)", "\n".join(blocks), re.M | re.S)
    return found[number]


class Copy:
    def __init__(self, folder, options):
        self.tree = folder / "source"
        self.build = self.tree / "build/release"  # with the paths that a compiler cache knows
        shutil.rmtree(self.tree, ignore_errors=True)
        self.tree.mkdir(parents=True)
        for part in PARTS.split():
            take = shutil.copytree if (SOURCE / part).is_dir() else shutil.copy2
            take(SOURCE / part, self.tree / part)
        self.options = options

    def add(self, example, room):
        shutil.copy2(EXAMPLES / example, self.tree / room)

    def change(self, change, *how):
        subprocess.run(["patch", "-s", "-p1", *how, "-d", self.tree], input=change, text=True, check=True)

    def make(self):
        flags = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON", "-DWANDER_TESTS=OFF",
                 "-DWANDER_BENCHMARKS=OFF"]
        quiet = {"check": True, "stdout": subprocess.DEVNULL}
        subprocess.run(["cmake", "-S", self.tree, "-B", self.build, *flags, *self.options], **quiet)
        subprocess.run(["cmake", "--build", self.build, "--target", "wander"], **quiet)

    def wander(self, arguments, exit_code=0):
        command = [self.build / "bin/wander", *arguments.split(), "-q"]
        done = subprocess.run(command, cwd=EXAMPLES, text=True, stdout=subprocess.PIPE)
        print(f"$ wander {arguments}\n{done.stdout}", flush=True)
        if done.returncode != exit_code:
            fail(f"exit code {done.returncode} instead of {exit_code}")
        return done.stdout


def main():
    folder, change = pathlib.Path(sys.argv[1]), changes()
    copy = Copy(folder, sys.argv[2:])
    slide = "check gallery:article-1 --mutations bidirectional=1,sensor_slide=1 --samples 50k"

    copy.add("sensor_slide.h", "mutations")
    copy.change(change["mutations/catalogue.h"])
    copy.make()
    passed = copy.wander(slide)
    copy.wander("check gallery:article-1 --mutations bidirectional=1,sensor_slide=1:reach=0.05 --samples 50k")

    copy.change(change["mutations/sensor_slide.h"])
    copy.make()
    caught = copy.wander(slide, exit_code=4)
    copy.change(change["mutations/sensor_slide.h"], "-R")
    for number, printed in enumerate([passed, caught]):
        if printed != shown(slide, number):
            fail("the page shows something else")

    copy.add("parabola.h", "core/geometry")
    copy.add("toss.h", "lab")
    for file in ("core/geometry/shape.h", "schema/scene.schema.json", "lab/method.cpp"):
        copy.change(change[file])
    copy.make()
    if not re.search(r"^  toss +agrees with bdpt", copy.wander(slide), re.M):
        fail("the method of the page is not checked")
    copy.wander("check dish.json --samples 50k")
    copy.wander(f"plot dish.json -o {folder.resolve()}/dish.svg --force")


main()
