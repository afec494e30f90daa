"""Meshes at the edge, as files: rooms and lamps of needles, and of a million triangles."""
import struct


def ply(points, corners):
    head = ("ply\nformat binary_little_endian 1.0\n"
            f"element vertex {len(points)}\nproperty double x\nproperty double y\nproperty double z\n"
            f"element face {len(corners)}\nproperty list uchar int vertex_indices\nend_header\n")
    return (head.encode() + b"".join(struct.pack("<3d", *p) for p in points)
            + b"".join(struct.pack("<B3i", 3, *c) for c in corners))


def sheet(origin, along, across, cuts_along, cuts_across):
    """Points and triangles of a parallelogram that is cut so; its normal is along × across."""
    points = [tuple(o + a * u + b * v for o, a, b in zip(origin, along, across))
              for u in cuts_along for v in cuts_across]
    columns = len(cuts_across)
    corners = []
    for i in range(len(cuts_along) - 1):
        for j in range(columns - 1):
            first = i * columns + j
            corners += [(first, first + columns, first + columns + 1), (first, first + columns + 1, first + 1)]
    return points, corners


def box(cuts):
    """The inside of the unit cube, each face cut so both ways."""
    points, corners = [], []
    for axis in range(3):
        along, across = ([float(k == (axis + step) % 3) for k in range(3)] for step in (1, 2))
        for side, edges in ((0, (along, across)), (1, (across, along))):
            own, faces = sheet([float(side and k == axis) for k in range(3)], *edges, cuts, cuts)
            corners += [tuple(len(points) + k for k in face) for face in faces]
            points += own
    return ply(points, corners)


# Triangles 10⁻⁹ wide and as long as the room, and some that are small both ways.
NEEDLES = [0, 1e-9, 1e-6, 1e-3, 0.5, 0.5 + 1e-9, 1 - 1e-6, 1]


def even(parts):
    return [k / parts for k in range(parts + 1)]


FILES = {
    "needles.ply": lambda: box(NEEDLES),
    "million.ply": lambda: box(even(289)),  # 12 · 289²
    "lamp-of-needles.ply": lambda: ply(*sheet([0, 1, 0], [1, 0, 0], [0, 0, 1], NEEDLES, [0, 1])),
}
