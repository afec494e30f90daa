"""Materials and textures (docs/scene-format.md)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Union

from ._fields import Colour, fields

__all__ = ["Conductor", "Dielectric", "Diffuse", "Material", "Mirror", "RoughConductor", "RoughDielectric", "Texture"]


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
        return {"type": self._type, **fields(self)}


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
        return {"type": self._type, **fields(self)}


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
        return {"type": self._type, **fields(self)}


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
        return {"type": self._type, **fields(self)}


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
        return {"type": self._type, **fields(self)}


Material = Union[Diffuse, Mirror, Conductor, RoughConductor, Dielectric, RoughDielectric]
