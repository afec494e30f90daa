"""Which lines of light transport and of its chains serve which dimension.

A file that is about one dimension is listed here; in all others, a specialisation for a dimension
(`struct Dimension<2>`, `struct ShapesOf<W, 3>` …) is of that dimension to its closing brace, and
everything else is shared.  Counted are lines that are neither blank nor comment alone.
"""
import re
from dataclasses import dataclass
from pathlib import Path

SHAPES = ("core/geometry/*", "core/curves.*", "core/surfaces.*")
ORACLE = ("core/exact/*",)  # exact films of the plane: what is measured against, no light transport of its own
PLANE, SPACE, SHARED = "plane", "space", "shared"
FILES = {
    PLANE: ("core/curves.*", "core/geometry/shapes_flat.*", "core/geometry/plane_grid.h", "core/light_walks.*"),
    SPACE: ("core/surfaces.*", "core/geometry/shapes_space.*", "core/geometry/triangle.h", "core/geometry/triangles.h",
            "core/geometry/mesh.*", "core/geometry/wide_bvh.*"),
}
SPECIALISATION = re.compile(r"^(?:struct|class) \w+<(?:\w+, )?([23])(?:, \w+)?> ?(?::.*)?\{$")


@dataclass
class Count:
    shared: int = 0
    plane: int = 0
    space: int = 0

    def add(self, to, lines=1):
        setattr(self, to, getattr(self, to) + lines)

    def total(self):
        return self.shared + self.plane + self.space

    def share(self):
        return self.shared / self.total()


def is_code(line):
    text = line.strip()
    return bool(text) and not text.startswith("//")


def count_text(text, count):
    """Adds the lines of a file that no dimension owns."""
    owner = SHARED
    for line in text.splitlines():
        if owner == SHARED and (found := SPECIALISATION.match(line)):
            owner = PLANE if found[1] == "2" else SPACE
        if is_code(line):
            count.add(owner)
        if line.startswith("}"):
            owner = SHARED


def matches(name, patterns):
    return any(name.match(pattern) for pattern in patterns)


def part_of(name):
    """The row of the table that a file belongs to."""
    if matches(name, ORACLE):
        return None
    if matches(name, SHAPES):
        return "shapes"
    return {"core": "light transport", "mlt": "chains", "mutations": "mutations"}[name.parts[0]]


def owner_of(name):
    return next((owner for owner, patterns in FILES.items() if matches(name, patterns)), SHARED)


def count(root):
    """Counts by part."""
    counts = {part: Count() for part in ("light transport", "chains", "mutations", "shapes")}
    paths = [path for room in ("core", "mlt", "mutations") for path in sorted((root / room).rglob("*"))]
    for path in paths:
        name = path.relative_to(root)
        if path.suffix not in (".h", ".cpp") or (part := part_of(name)) is None:
            continue
        text, owner = path.read_text(encoding="utf-8"), owner_of(name)
        if owner == SHARED:
            count_text(text, counts[part])
        else:
            counts[part].add(owner, sum(map(is_code, text.splitlines())))
    return counts


def total(counts):
    whole = Count()
    for part in counts:
        for owner in vars(part):
            whole.add(owner, getattr(part, owner))
    return whole
