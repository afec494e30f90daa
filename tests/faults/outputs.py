"""Files that the program makes: whether one is whole, and what it says but for times and facts of its making.

Whole means, by the ending: JSON that parses and has no NaN; rows of as many fields as the first and an end of line; an
EXR whose chunks lie behind each other up to its end, each of which inflates; netCDF that is as long as its superblock
says, with its seal; a PNG whose sections have their checksums up to the last; SVG that parses; HTML and PDF with their
last words;
what is kept of runs with the digest of its bytes at its end.
"""

import csv
import hashlib
import io
import json
import struct
import xml.etree.ElementTree
import zlib

FACTS = {
    "seconds",
    "cpu_seconds",
    "seed_seconds",
    "command_line",
    "provenance",
    "version",
    "warnings",
    "threads",
    "ess_per_second",
}
LINES_PER_CHUNK = {0: 1, 1: 1, 2: 1, 3: 16}  # by the number of an EXR's compression: none, run lengths, lines, blocks
SEAL = b"wanderlight-sha256 "


class Broken(Exception):
    """A file that is not whole, and why."""


def require(is_right, what):
    if not is_right:
        raise Broken(what)


def no_number(word):
    raise Broken(f"JSON with {word}")


def json_of(data):
    return json.loads(data.decode(), parse_constant=no_number)


def rows_of(data):
    require(data.endswith(b"\n"), "the last line has no end")
    rows = list(csv.reader(io.StringIO(data.decode())))
    require(rows and all(len(row) == len(rows[0]) for row in rows), "a row is cut short")
    return rows


def exr_of(data):
    """The channels and the bytes of each chunk, inflated."""
    require(data[:4] == b"\x76\x2f\x31\x01", "no EXR")
    at, attributes = 8, {}
    while data[at]:
        name_end = data.index(0, at)
        type_end = data.index(0, name_end + 1)
        size = struct.unpack_from("<i", data, type_end + 1)[0]
        attributes[data[at:name_end].decode()] = data[type_end + 5 : type_end + 5 + size]
        at = type_end + 5 + size
    _, top, _, bottom = struct.unpack("<4i", attributes["dataWindow"])
    lines = LINES_PER_CHUNK[attributes["compression"][0]]
    count = (bottom - top + lines) // lines
    offsets = struct.unpack_from(f"<{count}Q", data, at + 1)
    end, chunks = at + 1 + 8 * count, []
    for offset in sorted(offsets):
        require(offset == end, "a chunk is missing")
        size = struct.unpack_from("<ii", data, offset)[1]
        end = offset + 8 + size
        chunks.append(data[offset + 8 : end])
    require(end == len(data), f"it has {len(data)} bytes, and its chunks end at {end}")
    return attributes["channels"], [inflated(chunk) for chunk in chunks]


def inflated(chunk):
    try:
        return zlib.decompress(chunk)
    except zlib.error:
        return chunk  # one that does not become smaller is stored as it is


def netcdf_of(data):
    require(data[:8] == b"\x89HDF\r\n\x1a\n", "no netCDF-4")
    end = struct.unpack_from("<Q", data, 28 if data[8] >= 2 else 40)[0]
    require(len(data) >= end, f"it has {len(data)} bytes and says {end}")
    seal_of(data)


def png_of(data):
    require(data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG")
    at, word = 8, b""
    while word != b"IEND":
        size, word = struct.unpack_from(">I4s", data, at)
        (checksum,) = struct.unpack_from(">I", data, at + 8 + size)
        require(checksum == zlib.crc32(data[at + 4 : at + 8 + size]), "a section is damaged")
        at += 12 + size
    require(at == len(data), "something follows its end")
    return data


def svg_of(data):
    xml.etree.ElementTree.fromstring(data)
    return data


def seal_of(data):
    head, mark, digest = data.rpartition(SEAL)
    require(mark and digest.decode().strip() == hashlib.sha256(head).hexdigest(), "its seal is not that of its bytes")


def ending(*ends):
    def check(data):
        require(data.rstrip().endswith(ends), "its end is missing")
        return None

    return check


READERS = {
    ".json": json_of,
    ".csv": rows_of,
    ".exr": exr_of,
    ".nc": netcdf_of,
    ".png": png_of,
    ".svg": svg_of,
    ".html": ending(b"</html>"),
    ".pdf": ending(b"%%EOF"),
    ".obj": ending(b"", b"\n"),
    ".ply": ending(b""),
}


def reader_of(path):
    is_kept = path.name == "checkpoint" or path.parent.name == "kept" or path.suffix == ".runs"
    return seal_of if is_kept else READERS.get(path.suffix)


def fault_of(path):
    """Why a file is not whole; none if it is."""
    read = reader_of(path)
    data = path.read_bytes()
    try:
        require(data or path.suffix == ".tmp", "it is empty")
        if read:
            read(data)
    except (Broken, ValueError, KeyError, IndexError, struct.error, xml.etree.ElementTree.ParseError) as problem:
        return str(problem) or type(problem).__name__
    return None


def numbers(value):
    if isinstance(value, dict):
        return {key: numbers(entry) for key, entry in value.items() if key not in FACTS}
    return [numbers(entry) for entry in value] if isinstance(value, list) else value


def without_command(text):
    """What a comparison's table says of samples and errors."""
    kept = [i for i, word in enumerate(text[0]) if "seconds" not in word]
    return [[row[i] for i in kept] for row in text]


def content(path):
    """What is the same whenever and how often a file is made; none where nothing is."""
    data = path.read_bytes()
    if path.name == "compare.json":
        document = json_of(data)
        return {
            "complete": document["complete"],
            "reference": numbers(document["reference"]),
            "runs": [{key: numbers(run[key]) for key in ("seed", "samples", "film")} for run in document["runs"]],
        }
    if path.name == "compare.csv":
        return without_command(rows_of(data))
    if path.suffix == ".exr" and path.name != "figure.exr":
        return exr_of(data)
    if path.suffix == ".json":
        return numbers(json_of(data))
    if path.suffix in (".csv", ".png", ".obj", ".ply", ".xml"):
        return data
    return None
