"""The harness against programs that do wrong: each must be found, and a right one must not."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import outputs  # noqa: E402

# A program of one verb, `plot SCENE -o FILE`; the twins differ in how they write.
PROGRAM = """#!{python} -IS
import os, sys
out = sys.argv[sys.argv.index("-o") + 1] if "-o" in sys.argv else None
text = "<svg xmlns='http://www.w3.org/2000/svg'>" + "<g/>" * 20000 + "</svg>"
if out is None:
    sys.exit(0)
if os.path.exists(out) and "--force" not in sys.argv:
    print("error: it exists; add --force", file=sys.stderr)
    sys.exit(2)
def write(path):
    file = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    for at in range(0, len(text), 10000):
        piece = text[at:at + 10000].encode()
        while piece:
            piece = piece[os.write(file, piece):]
    os.close(file)
try:
{body}
except OSError as problem:
    print("error: cannot write", out, problem.strerror, file=sys.stderr)
    sys.exit(1)
"""
RIGHT = """
    here = ".wander-1-0.tmp"
    try:
        write(here)
        os.rename(here, out)
    except OSError:
        if os.path.exists(here):
            os.unlink(here)
        raise
"""
TWINS = {
    "in place": ("    write(out)", "half a file"),
    "removed first": ("    if os.path.exists(out):\n        os.unlink(out)\n" + RIGHT.strip("\n"), "lost"),
    "temporary left": (
        "    write('.wander-1-0.tmp' + str(os.getpid()))\n    os.rename('.wander-1-0.tmp' + str(os.getpid()), out)",
        "left over",
    ),
    "failure unsaid": (
        "    try:\n        write('.wander-1-0.tmp')\n        os.rename('.wander-1-0.tmp', out)\n"
        "    except OSError:\n        pass",
        "is missing",
    ),
}


def found(body, *kinds):
    """What the harness prints of a program with such a body, on the cases that it knows, and its exit code."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program"
        program.write_text(PROGRAM.format(python=sys.executable, body=body))
        program.chmod(0o755)
        only = [word for kind in kinds for word in ("--only", kind)]
        done = subprocess.run(
            [
                HERE / "run",
                program,
                "--count",
                "12",
                "--case",
                "plot scene, svg",
                "--case",
                "plot scene --force, svg",
                *only,
            ],
            capture_output=True,
            text=True,
        )
        return done.stdout + done.stderr, done.returncode


class Twins(unittest.TestCase):
    def test_a_right_program_passes(self):
        said, code = found(RIGHT, "disk full", "a call fails")
        self.assertEqual(code, 0, said)

    def test_each_wrong_one_is_found(self):
        for name, (body, words) in TWINS.items():
            with self.subTest(name):
                said, code = found(body, "disk full", "a call fails", "signal at a call")
                self.assertEqual(code, 1, said)
                self.assertIn(words, said)


class Whole(unittest.TestCase):
    """Files that are cut short anywhere are no whole ones."""

    def expect_seen(self, name, data):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            path.write_bytes(data)
            self.assertIsNone(outputs.fault_of(path))
            for size in (0, 1, len(data) // 2, len(data) - 2):
                path.write_bytes(data[:size])
                self.assertIsNotNone(outputs.fault_of(path), f"{name} cut to {size} of {len(data)} bytes")

    def test_of_text(self):
        self.expect_seen("a.json", json.dumps({"a": [1, 2, 3]}).encode())
        self.expect_seen("a.csv", b"a,b\n1,2\n3,4\n")
        self.expect_seen("a.svg", b"<svg xmlns='http://www.w3.org/2000/svg'><g/></svg>")
        self.expect_seen("a.pdf", b"%PDF-1.4\n%%EOF\n"[:-1])

    def test_no_number_is_no_json(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.json"
            path.write_text('{"a": NaN}')
            self.assertIn("NaN", outputs.fault_of(path))


if __name__ == "__main__":
    unittest.main()
