"""What the tests of the package share: the installed program beside it."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import pytest  # noqa: E402


class Program:
    """The program that came with the package."""

    path = shutil.which("wander", path=str(Path(sys.executable).parent))

    def __call__(self, *words: object, expected: int = 0) -> subprocess.CompletedProcess[str]:
        assert self.path, "the package was installed without its program"
        done = subprocess.run([self.path, *map(str, words)], capture_output=True, text=True)
        assert done.returncode == expected, done.stderr
        return done

    def run(self, directory: Path, *words: object) -> dict:
        """Renders into the directory; its run.json."""
        self("render", *words, "-q", "-o", directory)
        return json.loads((directory / "run.json").read_text())


@pytest.fixture(scope="session")
def wander() -> Program:
    return Program()


@pytest.fixture(autouse=True)
def no_figures():
    yield
    plt.close("all")
