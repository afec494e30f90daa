"""The catalogue one by one: each bug is planted in a copy of the tree, and the test programs that it names built."""
import os
import shutil
import subprocess

from behind_switches import synchronize
from catalogue import GIT_APPLY, Fault
from results import failures


class Workshop:
    """A copy of the tree with one test program per test file."""

    def __init__(self, copy, jobs, seconds):
        self.copy, self.jobs, self.seconds = copy, jobs, seconds
        self.build_folder = copy / "build"
        self.environment = {**os.environ, "CCACHE_BASEDIR": str(copy), "CCACHE_NOHASHDIR": "1",
                            "GIT_CEILING_DIRECTORIES": str(copy.parent)}

    def configure(self):
        self.copy.mkdir(parents=True, exist_ok=True)
        synchronize(self.copy)
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        self.call(["cmake", "-S", self.copy, "-B", self.build_folder, "-G", "Ninja",
                   "-DCMAKE_BUILD_TYPE=", "-DCMAKE_CXX_FLAGS=-O1 -DNDEBUG -w", "-DWANDER_BENCHMARKS=OFF",
                   "-DWANDER_TESTS_APART=ON", *launcher], "cannot be configured")

    def call(self, command, complaint):
        done = subprocess.run(command, cwd=self.copy, env=self.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            raise Fault(f"{self.copy}: {complaint}\n{done.stdout[-4000:]}")

    def programs(self, mutant):
        return [str(file.with_suffix("")).replace("/", "-") for file in mutant.test_files()]

    def build(self, programs):
        self.call(["ninja", "-C", self.build_folder, f"-j{self.jobs}", *programs], "does not compile")

    def plant(self, mutant, *options):
        self.call([*GIT_APPLY, *options, mutant.path], "the patch does not apply")

    def failures(self, mutant):
        return failures([[self.build_folder / "bin" / program, f"--gtest_filter={mutant.test}"]
                         for program in self.programs(mutant)], self.seconds)

    def check_without_bugs(self, mutants):
        """The tests must pass before a bug is planted, or their failure says nothing."""
        self.build(sorted({program for m in mutants for program in self.programs(m)}))
        for mutant in {(m.test, m.files): m for m in mutants}.values():
            if failed := self.failures(mutant):
                raise Fault(f"{', '.join(failed)}: fails without any bug")

    def attempt(self, mutant):
        """Names of the tests that fail with a bug."""
        self.plant(mutant)
        try:
            self.build(self.programs(mutant))
            return self.failures(mutant)
        finally:
            self.plant(mutant, "--reverse")
