"""The script that holds two builds against each other: silent on one and the same, loud on another seed."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from place import PROGRAM, ROOT

SCRIPT = ROOT / "tests/benchmarks/same_bits"


def compare(new):
    return subprocess.run([SCRIPT, PROGRAM, new, "article-1", "--samples", "2k", "--methods", "pt,mlt"],
                          capture_output=True, text=True)


class SameBits(unittest.TestCase):
    def test_a_program_makes_the_bits_that_it_makes(self):
        done = compare(PROGRAM)
        self.assertEqual((done.returncode, done.stdout), (0, "2 runs, 0 different\n"))

    def test_another_seed_is_heard(self):
        with tempfile.TemporaryDirectory() as folder:
            twin = Path(folder) / "wander"
            twin.write_text(f'#!/bin/sh\ncase $1 in render) exec {PROGRAM} "$@" -s 2;; esac\nexec {PROGRAM} "$@"\n')
            os.chmod(twin, 0o755)
            done = compare(twin)
        self.assertEqual(done.returncode, 1)
        self.assertIn("article-1 pt: /seed: 1 and 2", done.stdout)
        self.assertTrue(done.stdout.endswith("2 runs, 2 different\n"))


if __name__ == "__main__":
    unittest.main()
