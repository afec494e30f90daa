"""What may be there after a fault, and after the same command was run again without one."""

import json
import re

from outputs import content, fault_of, numbers

RAW = re.compile(
    r"terminate called|Aborted|core dumped|Segmentation|std::|what\(\)|basic_|vector::|json\.exception|"
    r"bad_alloc|backtrace|_M_|Assertion|0x[0-9a-f]{6}",
    re.I,
)
DEADLY = {-9, -2, -15}
LAST = ("run.json", "compare.json")  # of what a command makes, written after all else


def files_of(folder):
    return {str(p.relative_to(folder)): p for p in folder.rglob("*") if p.is_file()}


def is_temporary(name):
    return any(part.startswith(".") for part in name.split("/"))


def is_kept(name):
    return name.split("/")[0] == "cache" or "/kept/" in f"/{name}" or name.endswith("checkpoint")


def of_exit(known, fault, outcome):
    """Findings about the codes and what was said."""
    codes, ends = outcome.codes(), [outcome] + ([outcome.second] if outcome.second else [])
    allowed = fault.codes | ({known.code} if fault.may_succeed or not outcome.is_struck else set())
    found = [f"exit code {code}" for code in codes if code not in allowed]
    if outcome.second and known.code not in codes:
        found.append(f"none of two came to its end: {codes}")
    if "stderr" not in fault.streams:
        for end in ends:
            found += of_words(known, end)
    return found


def of_words(known, end):
    found = [f"raw words: {match.group(0)!r}" for match in [RAW.search(end.err)] if match]
    is_failed = end.code not in DEADLY | {known.code, 130}
    errors = [line for line in end.err.splitlines() if line.startswith("error: ")]
    if is_failed and len(errors) != 1:
        found.append(f"{len(errors)} lines of error, not one")
    if "--json" in known.case.command and end.code not in DEADLY and end.out:
        try:
            document = json.loads(end.out)
            if is_failed and "error" not in document:
                found.append('no "error" in the document')
        except ValueError:
            found.append("stdout is no JSON")
    return found


def of_files(known, outcome, folder):
    """Findings about each file as it stands after the fault, and whether a place holds old and new together."""
    now, before = files_of(folder), known.before
    found = [
        f"{name}: half a file: {why}"
        for name, path in now.items()
        if not is_temporary(name) and (why := fault_of(path))
    ]
    gone = [name for name in before if name not in now and not is_kept(name) and not is_temporary(name)]
    if outcome.code != known.code:
        found += [f"{name}: lost" for name in gone]
    is_new = {
        name: name not in before or path.read_bytes() != before[name]
        for name, path in now.items()
        if not is_temporary(name) and not is_kept(name) and name in known.files
    }
    found += [
        f"{name}: changed, and no output"
        for name, path in now.items()
        if name in before and name not in known.files and not is_kept(name) and path.read_bytes() != before[name]
    ]
    last = next(
        (name for name in is_new if name.split("/")[-1] in LAST and name.split("/")[0] == known.case.place), None
    )
    is_mixed = False
    if last:
        inside = [new for name, new in is_new.items() if name != last and name.startswith(known.case.place + "/")]
        is_mixed = not is_new[last] and any(inside)
        if is_new[last] and outcome.code == -9:
            found += of_results(known, folder, "the record is written last")
    return found, is_mixed


def of_results(known, folder, when):
    """Findings where results must be those of an undisturbed run, of one seed or the other where two were at work."""
    now = files_of(folder)
    found = [f"{when}: {name} is missing" for name in known.contents[0] if name not in now]
    if found:
        return found
    others = [
        [name for name, wanted in contents.items() if content(now[name]) != wanted] for contents in known.contents
    ]
    differing = min(others, key=len)
    return [f"{when}: {', '.join(differing)}: other numbers"] if differing else []


def of_print(known, outcome, fault):
    if outcome.code != known.code or known.printed is None or "stdout" in fault.streams:
        return []
    return [] if printed(outcome) == known.printed else ["other numbers are printed"]


def printed(outcome):
    try:
        return numbers(json.loads(outcome.out))
    except ValueError:
        return outcome.out


def of_leftovers(known, folder):
    now = files_of(folder)
    empty = [str(p.relative_to(folder)) for p in folder.rglob(".*") if p.is_dir()]
    return [
        f"left over: {name}"
        for name in [*now, *empty]
        if name not in known.files and (is_temporary(name) or not is_kept(name))
    ]
