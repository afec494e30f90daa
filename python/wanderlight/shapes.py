"""Shapes of the plane and of space (docs/scene-format.md)."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Sequence

import numpy as np
from numpy.typing import ArrayLike

from ._fields import Colour, Point, fields, plain
from .materials import Material

__all__ = ["Arc", "Circle", "Mesh", "Parallelogram", "Polyline", "Segment", "Shape", "Sphere", "Triangle"]


@dataclass(frozen=True, kw_only=True)
class Shape:
    """What all shapes can say of themselves; a shape without a material is black.

    Parameters
    ----------
    material : Diffuse, Mirror, ..., optional
        What it is made of.
    light : float or (3,) sequence of float, optional
        The radiance that it emits from its front, in W/(m·rad) in the plane and W/(m²·sr) in space.
    sensor : int or (int, int), optional
        The bins that it counts light in on its front; in space (width, height).
    id : str, optional
        How messages call it.

    Examples
    --------
    >>> import wanderlight as wl
    >>> isinstance(wl.Circle((0, 0), 1), wl.Shape)
    True
    """

    material: Material | None = None
    light: Colour | None = None
    sensor: int | Sequence[int] | None = None
    id: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """As scene files have it, but for the name of its material."""
        said = fields(self)
        for common in ("material", "light", "sensor", "id"):
            said.pop(common, None)
        if self.light is not None:
            said["light"] = {"radiance": plain(self.light)}
        if self.sensor is not None:
            counted = "bins" if isinstance(self.sensor, (int, np.integer)) else "resolution"
            said["sensor"] = {counted: plain(self.sensor)}
        if self.id is not None:
            said["id"] = self.id
        return {"type": type(self).__name__.lower(), **said}


@dataclass(frozen=True)
class Segment(Shape):
    """A segment in the plane. Its front is at the left of the way from `start` to `end`.

    Parameters
    ----------
    start, end : (2,) sequence of float
        In metres.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Segment((0, 0), (1, 0), sensor=100).to_dict()
    {'type': 'segment', 'from': [0, 0], 'to': [1, 0], 'sensor': {'bins': 100}}
    """

    start: Point
    end: Point


@dataclass(frozen=True)
class Polyline(Shape):
    """Segments one after the other, in the plane.

    Parameters
    ----------
    points : (n, 2) array_like of float
        In metres.
    closed : bool
        Does the last lead back to the first?

    Examples
    --------
    >>> import wanderlight as wl
    >>> room = wl.Polyline([(0, 0), (4, 0), (4, 2), (0, 2)], closed=True, material=wl.Diffuse(0.75))
    >>> len(room.points)
    4
    """

    points: Sequence[Point] | ArrayLike
    closed: bool = False


@dataclass(frozen=True)
class Circle(Shape):
    """A circle in the plane. Its front is outside.

    Parameters
    ----------
    center : (2,) sequence of float
        In metres.
    radius : float
        In metres.
    flip : bool
        Its front is inside.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Circle((1, 0), 0.5, light=10).to_dict()["light"]
    {'radiance': 10}
    """

    center: Point
    radius: float
    flip: bool = False


@dataclass(frozen=True)
class Arc(Shape):
    """A part of a circle in the plane, counter-clockwise from one angle to the other. Its front is outside.

    Parameters
    ----------
    center : (2,) sequence of float
        In metres.
    radius : float
        In metres.
    start_degrees, end_degrees : float
        From the x axis.
    flip : bool
        Its front is inside.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Arc((0, 0), 1, 0, 90, flip=True, material=wl.Mirror(0.9)).end_degrees
    90
    """

    center: Point
    radius: float
    start_degrees: float
    end_degrees: float
    flip: bool = False


@dataclass(frozen=True)
class Triangle(Shape):
    """A triangle in space. Seen from its front its points run counter-clockwise.

    Parameters
    ----------
    points : (3, 3) array_like of float
        In metres.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Triangle([(0, 0, 0), (1, 0, 0), (0, 1, 0)], light=(17, 12, 4)).to_dict()["light"]
    {'radiance': [17, 12, 4]}
    """

    points: Sequence[Point] | ArrayLike


@dataclass(frozen=True)
class Parallelogram(Shape):
    """A parallelogram in space. Its normal is the cross product of its edges.

    Parameters
    ----------
    origin : (3,) sequence of float
        A corner, in metres.
    edges : (2, 3) array_like of float
        From there, in metres.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Parallelogram((0, 0, 0), [(1, 0, 0), (0, 1, 0)], sensor=(8, 8)).to_dict()["sensor"]
    {'resolution': [8, 8]}
    """

    origin: Point
    edges: Sequence[Point] | ArrayLike


@dataclass(frozen=True)
class Sphere(Shape):
    """A sphere in space. Its front is outside.

    Parameters
    ----------
    center : (3,) sequence of float
        In metres.
    radius : float
        In metres.
    flip : bool
        Its front is inside.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Sphere((0, 0, 1), 0.2, material=wl.Dielectric(1.5)).radius
    0.2
    """

    center: Point
    radius: float
    flip: bool = False


@dataclass(frozen=True)
class Mesh(Shape):
    """Triangles in space, of a file or of arrays.

    Parameters
    ----------
    file : str or Path, optional
        An OBJ or PLY file, relative to the folder of the scene.
    points : (n, 3) array_like of float, optional
        The vertices, in metres; the scene keeps them in a file of its own.
    faces : (m, 3) array_like of int, optional
        The vertices of each triangle, from 0.
    transform : (4, 4) or (3, 4) array_like of float, optional
        From the mesh to the scene.
    normals : {"flat", "smooth"}, optional
        Whether shading follows the normals of the file.

    Examples
    --------
    >>> import wanderlight as wl
    >>> tetrahedron = wl.Mesh(points=[(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
    ...                       faces=[(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
    >>> len(tetrahedron.faces)
    4
    """

    file: str | Path | None = None
    points: ArrayLike | None = None
    faces: ArrayLike | None = None
    transform: ArrayLike | None = None
    normals: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """As scene files have it, but for the names of its material and of the file of its arrays."""
        said = super().to_dict()
        said.pop("points", None)
        said.pop("faces", None)
        if self.file is not None:
            said["file"] = str(self.file)
        return said

    def to_obj(self) -> str:
        """Its arrays as the text of an OBJ file."""
        points = np.asarray(self.points, dtype=float).reshape(-1, 3)
        faces = np.asarray(self.faces, dtype=int).reshape(-1, 3) + 1
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
        lines += [f"f {a} {b} {c}" for a, b, c in faces.tolist()]
        return "\n".join(lines) + "\n"
