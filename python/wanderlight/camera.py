"""Cameras (docs/scene-format.md)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

from ._fields import Point, fields

__all__ = ["Camera"]


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
        return {"type": "perspective", **fields(self)}
