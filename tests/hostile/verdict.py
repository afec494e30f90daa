"""What may come of a hostile scene: a documented exit code, clear words, finite numbers, bounded time and memory."""

import json
import math
import re

CPU_SECONDS, BYTES = 20, 1 << 30
CODES = {0, 1, 2, 3}
LARGE = 1 << 20
LIBRARY_WORDS = re.compile(
    r"terminate called|Aborted|core dumped|Segmentation|std::|what\(\)|basic_string|vector::|json\.exception|"
    r"nlohmann|parse_error|type_error|out_of_range|bad_alloc|map::at|_M_|Assertion|stoi|stod|pugi|tbb::|0x[0-9a-f]{6}"
)
PLACE = re.compile(r"^(scene\.json|[\w./-]+\.(obj|ply|png)):\d+(:\d+)?: ")
SAID = re.compile(r"^(error: |warning: |info: |  |\S+: )")
NO_NUMBER = re.compile(rb"(?<![\w.])-?(nan|inf|NaN|Infinity)(?![\w.])")


class NoNumber(Exception):
    pass


def no_number(word):
    raise NoNumber(word)


def document_of(data):
    """Of a large one no more than its first words and last, and that all is finite."""
    if len(data) < LARGE:
        return json.loads(data, parse_constant=no_number)
    if match := NO_NUMBER.search(re.sub(rb'"(?:[^"\\]|\\.)*"', b"", data)):
        raise NoNumber(match.group().decode())
    if not data.startswith(b"{") or not data.endswith(b"}\n"):
        raise ValueError("it is cut short")
    return {"error": None} if b'"error"' in data[:100] else {}


def of_json(command, code, out):
    if "--json" not in command:
        return []
    try:
        document = document_of(out)
    except (ValueError, NoNumber) as problem:
        return [f"stdout is no JSON: {type(problem).__name__} {problem}"]
    return [] if code in (0, 4) or "error" in document else ['no "error" in the document']


def of_words(code, err):
    found = [f"words of a library: {match.group(0)!r}" for match in [LIBRARY_WORDS.search(err)] if match]
    lines = [line for line in err.splitlines() if not line.startswith(("warning: ", "info: "))]
    if code in (1, 2, 3) and not lines:
        found.append(f"exit code {code}, and nothing is said")
    if code == 3 and not all(PLACE.match(line) for line in lines):
        found.append(f"no place is named: {next(line for line in lines if not PLACE.match(line))[:200]!r}")
    if (
        code in (1, 2)
        and (len(lines) != 1 or not lines[0].startswith("error: "))
        and not all(PLACE.match(x) or x.startswith("error: ") for x in lines)
    ):
        found.append(f"exit code {code}: {lines[:3]}")
    if any(len(line) > 2000 for line in lines):
        found.append(f"a line of {max(map(len, lines))} characters")
    return found


def of_files(folder):
    """Of films, figures and records; a standard error that is not known is nan in tables."""
    found = []
    for path in [*folder.rglob("*.json"), *folder.rglob("*.svg"), *folder.rglob("film.csv")]:
        data = path.read_bytes()
        if path.name == "scene.json":
            continue
        if path.suffix == ".json":
            try:
                document_of(data)
            except (ValueError, NoNumber) as problem:
                found.append(f"{path.name}: {type(problem).__name__} {problem}")
        elif path.suffix == ".csv":
            values = [line.split(",")[2] for line in data.decode().splitlines()[1:]]
            found += [f"{path.name}: {value}" for value in values if not math.isfinite(float(value))][:1]
        elif match := NO_NUMBER.search(re.sub(rb"<(title|text|desc|tspan)\b[^>]*>[^<]*<", b"<", data)):
            found.append(f"{path.name}: {data[max(0, match.start() - 40) : match.end()]!r}")
    return found


def findings(command, done, folder):
    allowed = CODES | ({4} if "check" in command else set())
    found = [] if done.code in allowed else [f"exit code {done.code}"]
    if done.cpu > CPU_SECONDS:
        found.append(f"{done.cpu:.1f} s of processor time")
    if found and done.code not in allowed:
        return found
    found += of_words(done.code, done.err) + of_json(command, done.code, done.out)
    if done.code == 3 and [p.name for p in folder.iterdir() if p.name not in ("scene.json", "meshes")]:
        found.append("an invalid scene, and something is written")
    return found + of_files(folder)
