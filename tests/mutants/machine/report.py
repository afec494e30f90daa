"""The page of what became of the bugs that a machine made."""
import json
import math
import time
from collections import Counter
from pathlib import Path

EXPLAINED = Path(__file__).resolve().parent / "explained.json"
HEAD = """# Bugs made by machine

Written by `tests/mutants/machine/run FOLDER --report`; its results are of {date}.

A place of the program is drawn by lot and spoilt: another operator, a comparison turned over or off at its boundary, an operand of `&&` or `||`
dropped, a number off by one (an eighth, if it is no integer), a sign dropped, a statement deleted. All bugs are compiled into one program, and
the environment says which is on, so that a bug costs the tests that come by its place and no compiling. The quick tests are run in order
of their time, up to {seconds} s for each bug, until one fails. `tests/mutants/machine/sites.py` says where bugs are made; constants that the compiler
computes are out of its reach. Planted by hand: [mutants.md](mutants.md).

| room | drawn | no test comes by | tried | caught | since | the program as before | survive | score at first | score |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|
{rows}

*The program as before* are survivors that change no result; *since* are those that a test catches which was written for them, each tried with its
bug and that test alone. The score is of all that are not as before, with its interval (Wilson, 95 %), *at first* without the new tests.

## Survivors

| place | what | text | why |
|---|---|---|---|
{survivors}
"""


def wilson(caught, tried):
    """Share and 95 % interval."""
    if tried == 0:
        return "–"
    z, p = 1.96, caught / tried
    middle = (p + z * z / (2 * tried)) / (1 + z * z / tried)
    half = z * math.sqrt(p * (1 - p) / tried + z * z / (4 * tried * tried)) / (1 + z * z / tried)
    return f"{100 * p:.0f} % ({100 * (middle - half):.0f}–{100 * (middle + half):.0f})"


def explanation(result, explained):
    """What is known of a survivor, by file, kind and text, which outlive a change of lines."""
    return explained.get(f"{result['file']}: {result['kind']}: {result['text']}", {"why": ""})


def escaped(text):
    return text.replace("|", "\\|")


def write_report(folder, repository, seconds):
    results = list(json.loads((folder / "results.json").read_text()).values())
    explained = json.loads(EXPLAINED.read_text()) if EXPLAINED.exists() else {}
    rows, survivors = [], []
    for room in dict.fromkeys(r["file"].split("/")[0] for r in results):
        count = Counter()
        for r in (r for r in results if r["file"].startswith(room + "/")):
            count["drawn"] += 1
            if "untried" in r:
                count[r["untried"]] += 1
                continue
            count["tried"] += 1
            if r["caught"]:
                count["caught"] += 1
                continue
            known = explanation(r, explained)
            count["since" if "since" in known else "equivalent" if "equivalent" in known else "survive"] += 1
            why = f"since: `{known['since']}`" if "since" in known else known["why"]
            if "equivalent" in known:
                why = f"as before: {why}"
            survivors.append(f"| `{r['file']}:{r['line']}` | {r['kind']} | `{escaped(r['text'])}` | {why} |")
        real = count["tried"] - count["equivalent"]
        rows.append(f"| `{room}` | {count['drawn']} | {count['no test comes by']} | {count['tried']} | {count['caught']} "
                    f"| {count['since']} | {count['equivalent']} | {count['survive']} | {wilson(count['caught'], real)} "
                    f"| {wilson(count['caught'] + count['since'], real)} |")
    date = time.strftime("%Y-%m-%d", time.gmtime((folder / "results.json").stat().st_mtime))
    page = HEAD.format(date=date, seconds=f"{seconds:g}", rows="\n".join(rows), survivors="\n".join(survivors))
    (repository / "docs/mutants-by-machine.md").write_text(page)
