"""The catalogue of planted bugs: reads the patches, checks them, and writes docs/mutants.md."""
import functools
import os
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
REPOSITORY = FOLDER.parent.parent
# Whoever owns the checkout: patches are applied to files, not to the repository.
GIT_APPLY = ["git", "-c", "safe.directory=*", "apply"]
TESTS = REPOSITORY / "tests"


class Fault(Exception):
    """What is wrong, with its place and remedy."""


@functools.cache
def test_texts():
    """{test file, below TESTS: its text}."""
    return {path.relative_to(TESTS): path.read_text() for path in sorted(TESTS.rglob("*_test.cpp"))}


@dataclass(frozen=True)
class Mutant:
    path: Path
    id: str
    what: str
    test: str
    files: str
    changed: str  # the file that the bug is planted in

    @property
    def name(self):
        return self.path.stem

    def test_files(self):
        return [name for name in test_texts() if re.search(self.files, str(name))]


def read(path):
    head, _, diff = path.read_text().partition("\n--- ")
    fields = dict(re.findall(r"^(\w+): +(.*)$", head, re.MULTILINE))
    for field in ("id", "what", "test", "files"):
        if not fields.get(field):
            raise Fault(f"{path}: has no line '{field}:' before its diff")
    changed = re.match(r"a/(\S+)", diff)
    if not changed:
        raise Fault(f"{path}: holds no diff with the names a/… and b/…")
    if not path.stem.startswith(fields["id"] + "-"):
        raise Fault(f"{path}: its name does not begin with its id, {fields['id']}")
    return Mutant(path, *(fields[f] for f in ("id", "what", "test", "files")), changed[1])


def load():
    mutants = [read(path) for path in sorted(FOLDER.glob("*.patch"))]
    for one, next_one in zip(mutants, mutants[1:]):
        if one.id == next_one.id:
            raise Fault(f"{one.path} and {next_one.path.name}: have the same id")
    return mutants


def what_does_not_apply(mutants):
    """What git says of their patches together, which touch no file twice; empty if all apply."""
    # Git must not take the tree for a part of a repository around it.
    environment = {**os.environ, "GIT_CEILING_DIRECTORIES": str(REPOSITORY.parent)}
    done = subprocess.run([*GIT_APPLY, "--check", *(m.path for m in mutants)], cwd=REPOSITORY,
                          env=environment, capture_output=True, text=True)
    return done.stderr.strip() if done.returncode != 0 else ""


def batches_of(mutants):
    """Of patches that touch no file twice: git starts a few times, not once for each."""
    batches = []  # the files that are touched, and the mutants
    for mutant in mutants:
        files = set(re.findall(r"^--- a/(.+)$", mutant.path.read_text(), re.MULTILINE))
        batch = next((b for b in batches if b[0].isdisjoint(files)), None)
        if batch is None:
            batches.append(batch := (set(), []))
        batch[0].update(files)
        batch[1].append(mutant)
    return [batch for _, batch in batches]


def check_apply(mutants):
    for batch in batches_of(mutants):
        if not what_does_not_apply(batch):
            continue
        for mutant in batch:
            if words := what_does_not_apply([mutant]):
                raise Fault(f"{mutant.path}: does not apply; plant the bug in the text as it is now\n{words}")


def tests_of(mutant):
    """(suite, test) of each name in the filter, without the parts that name parameters."""
    for name in mutant.test.split(":"):
        match = re.fullmatch(r"(?:\*/|\*)?(\w+)(?:/\*)?\.(\w+)(?:/\*|\*)?", name)
        if not match:
            raise Fault(f"{mutant.path}: '{name}' is not of the form Suite.Test or */Suite.Test/*")
        yield match.groups()


def check_tests_exist(mutant):
    text = "".join(test_texts()[file] for file in mutant.test_files())
    for suite, test in tests_of(mutant):
        if not re.search(rf"TEST\w*\(\s*{suite},\s*{test}\s*\)", text):
            raise Fault(f"{mutant.path}: no test file that matches {mutant.files} holds {suite}.{test}")


LEFT_OUT_ID = re.compile(r"^\| ([A-Z]\d+) ", re.MULTILINE)


def check_left_out(mutants):
    twice = {m.id for m in mutants} & set(LEFT_OUT_ID.findall((FOLDER / "left_out.md").read_text()))
    if twice:
        raise Fault(f"{FOLDER / 'left_out.md'}: leaves out what is planted: {', '.join(sorted(twice))}")


def check(mutants, said):
    check_left_out(mutants)
    check_apply(mutants)
    for mutant in mutants:
        check_tests_exist(mutant)
    if (REPOSITORY / "docs/mutants.md").read_text() != document(mutants, said):
        raise Fault("docs/mutants.md: is out of step with tests/mutants; run tests/mutants/run --docs")


AREAS = {
    "A": "Geometry, measures, scattering",
    "B": "Techniques, weights, seeds",
    "C": "Metropolis–Hastings",
    "D": "Bidirectional mutation",
    "E": "Lens, caustic and multi-chain perturbations",
    "F": "Primary sample space",
    "G": "Deposits, normalization, film",
    "H": "Robustness",
    "I": "Importing",
    "M": "Materials",
    "N": "Random numbers and arithmetic",
    "O": "Output",
    "S": "Shapes, rays, cameras",
}


def table(mutants):
    lines = ["| id | planted bug | test that catches it |", "|---|---|---|"]
    for m in mutants:
        names = ", ".join(f"`{suite}.{test}`" for suite, test in tests_of(m))
        lines.append(f"| [{m.id}](../tests/mutants/{m.path.name}) | {m.what} | {names} |")
    return "\n".join(lines)


def document(mutants, said):
    """The page; `said` is the sentence on the last run."""
    left_out = (FOLDER / "left_out.md").read_text().strip()
    left_out_count = len(LEFT_OUT_ID.findall(left_out))
    parts = [
        "# Planted bugs\n",
        "<!-- Written by tests/mutants/run --docs; do not edit. -->\n",
        "A test that has never failed proves little.  Each bug below is a patch in `tests/mutants/`;"
        " `tests/mutants/run` plants them in a copy of the tree, and the test named beside a bug must fail."
        "  Nearly all share one build of the copy, in which the environment says which one is on, so that a bug"
        " costs its test and no compiling; those that no switch can hold are planted and built one by one."
        "  The program itself has no switch for any of them.  The command also runs as the test `mutants`"
        ", labelled `campaign`; the quick suite checks that every patch still applies and that this page is in step.\n",
        f"{len(mutants)} bugs are planted; {left_out_count} more are left out, with"
        " their reasons below.\n",
        said + "\n",
    ]
    for letter, title in AREAS.items():
        of_area = [m for m in mutants if m.id[0] == letter]
        if of_area:
            parts += [f"## {title}\n", table(of_area) + "\n"]
    return "\n".join(parts + [left_out]) + "\n"
