"""The parts of a scene: materials, shapes and cameras.

Each is a record of what a scene file says (docs/scene-format.md), under the same words; what is left out is as usual.
Whether it makes sense is said where a `Scene` is made of it, with the messages that scene files get.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

__all__ = [
    "Arc",
    "Camera",
    "Circle",
    "Conductor",
    "Dielectric",
    "Diffuse",
    "Material",
    "Mesh",
    "Mirror",
    "Parallelogram",
    "Polyline",
    "RoughConductor",
    "RoughDielectric",
    "Segment",
    "Shape",
    "Sphere",
    "Texture",
    "Triangle",
]

Point = Sequence[float]
# One number, or red, green and blue.
Colour = Union[float, Sequence[float]]

# What Python has another word for.
_WORDS = {"start": "from", "end": "to", "start_degrees": "from_deg", "end_degrees": "to_deg", "fov_degrees": "fov_deg"}


def _plain(value: Any) -> Any:
    """As JSON has it."""
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return _fields(value)
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    return value


def _fields(part: Any) -> dict[str, Any]:
    said: dict[str, Any] = {}
    for field in dataclasses.fields(part):
        value = getattr(part, field.name)
        if value is not None and value is not False:
            said[_WORDS.get(field.name, field.name)] = _plain(value)
    return said


# ---- materials


@dataclass(frozen=True)
class Texture:
    """A picture as a reflectance, on a mesh that has texture coordinates.

    Parameters
    ----------
    texture : str
        The path of a PNG file, relative to the folder of the scene.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Diffuse(wl.Texture("wood.png")).reflectance.texture
    'wood.png'
    """

    texture: str


@dataclass(frozen=True)
class Diffuse:
    """A surface that scatters the same radiance everywhere, on both sides.

    Parameters
    ----------
    reflectance : float, (3,) sequence of float or Texture
        What of the light is reflected, from 0 to 1; in space also red, green and blue.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Diffuse(0.75).to_dict()
    {'type': 'diffuse', 'reflectance': 0.75}
    """

    reflectance: Colour | Texture
    _type = "diffuse"

    def to_dict(self) -> dict[str, Any]:
        """As scene files have it."""
        return {"type": self._type, **_fields(self)}


@dataclass(frozen=True)
class Mirror(Diffuse):
    """A mirror, on both sides.

    Parameters
    ----------
    reflectance : float or (3,) sequence of float
        What of the light is reflected, from 0 to 1.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Mirror(0.9).to_dict()["type"]
    'mirror'
    """

    _type = "mirror"


@dataclass(frozen=True)
class Conductor:
    """A smooth metal.

    Parameters
    ----------
    eta, k : float or (3,) sequence of float
        Its index of refraction and extinction coefficient (pure numbers).

    Examples
    --------
    >>> import wanderlight as wl
    >>> gold = wl.Conductor(eta=[0.143, 0.375, 1.442], k=[3.983, 2.386, 1.603])
    >>> gold.to_dict()["type"]
    'conductor'
    """

    eta: Colour
    k: Colour
    _type = "conductor"

    def to_dict(self) -> dict[str, Any]:
        """As scene files have it."""
        return {"type": self._type, **_fields(self)}


@dataclass(frozen=True)
class RoughConductor:
    """A rough metal: facets by GGX.

    Parameters
    ----------
    roughness : float
        Walter's α, above 0 and up to 1.
    reflectance : float or (3,) sequence of float, optional
        What the facets reflect; or say `eta` and `k`.
    eta, k : float or (3,) sequence of float, optional
        Of the metal.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.RoughConductor(0.1, reflectance=0.8).to_dict()
    {'type': 'rough_conductor', 'roughness': 0.1, 'reflectance': 0.8}
    """

    roughness: float
    reflectance: Colour | None = None
    eta: Colour | None = None
    k: Colour | None = None
    _type = "rough_conductor"

    def to_dict(self) -> dict[str, Any]:
        """As scene files have it."""
        return {"type": self._type, **_fields(self)}


@dataclass(frozen=True)
class Dielectric:
    """Glass: it reflects and refracts. The normal of its surface points out of it.

    Parameters
    ----------
    ior : float
        Its index of refraction.
    exterior_ior : float, optional
        That of what is outside; usually 1.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Dielectric(1.5).to_dict()
    {'type': 'dielectric', 'ior': 1.5}
    """

    ior: float
    exterior_ior: float | None = None
    _type = "dielectric"

    def to_dict(self) -> dict[str, Any]:
        """As scene files have it."""
        return {"type": self._type, **_fields(self)}


@dataclass(frozen=True)
class RoughDielectric:
    """Frosted glass: facets by GGX.

    Parameters
    ----------
    roughness : float
        Walter's α, above 0 and up to 1.
    ior : float
        Its index of refraction.
    exterior_ior : float, optional
        That of what is outside; usually 1.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.RoughDielectric(0.2, ior=1.5).roughness
    0.2
    """

    roughness: float
    ior: float
    exterior_ior: float | None = None
    _type = "rough_dielectric"

    def to_dict(self) -> dict[str, Any]:
        """As scene files have it."""
        return {"type": self._type, **_fields(self)}


Material = Union[Diffuse, Mirror, Conductor, RoughConductor, Dielectric, RoughDielectric]

# ---- shapes


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
        said = _fields(self)
        for common in ("material", "light", "sensor", "id"):
            said.pop(common, None)
        if self.light is not None:
            said["light"] = {"radiance": _plain(self.light)}
        if self.sensor is not None:
            counted = "bins" if isinstance(self.sensor, (int, np.integer)) else "resolution"
            said["sensor"] = {counted: _plain(self.sensor)}
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


@dataclass(frozen=True)
class Camera:
    """A perspective camera, with a thin lens if it has an aperture.

    Parameters
    ----------
    position, target : (dimension,) sequence of float
        Where it is, and what it looks at, in metres.
    fov_degrees : float
        The angle of what it sees, along the width of the picture.
    resolution : int or (int, int)
        Its bins; in space (width, height).
    up : (3,) sequence of float, optional
        What is up, in space.
    aperture_radius : float, optional
        Of its lens, in metres.
    focus_distance : float, optional
        At which its picture is sharp, in metres.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Camera((0, 0, -1), (0, 0, 0), 40, (64, 64)).to_dict()["type"]
    'perspective'
    """

    position: Point
    target: Point
    fov_degrees: float
    resolution: int | Sequence[int]
    up: Point | None = None
    aperture_radius: float | None = None
    focus_distance: float | None = None

    def to_dict(self) -> dict[str, Any]:
        """As scene files have it."""
        return {"type": "perspective", **_fields(self)}
