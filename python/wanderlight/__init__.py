"""Wanderlight: a Metropolis light transport testbed.

>>> import wanderlight as wl
>>> run = wl.render("gallery:slit", "mlt", "100k")

`render` computes the film of a scene, with its errors; `begin` a run that is advanced by hand; `trace` records every
step of some chains for ArviZ; `compare` holds methods against each other; `check` tests every mutation on a scene;
`plot` draws them with matplotlib. Scenes are files, of the gallery (`gallery`), dictionaries, or built of `Segment`,
`Circle`, `Mesh`, `Diffuse` and others. All of it computes the bits of the program `wander`.
"""

from . import plot
from ._wander import version as _version
from .building import BuildError, build
from .camera import Camera
from .checking import Check, check
from .comparison import Comparison, compare
from .errors import (
    FileError,
    Interrupted,
    NoLightFound,
    OutputError,
    RunError,
    SceneError,
    UsageError,
    WanderlightError,
)
from .importing import import_mitsuba
from .materials import Conductor, Dielectric, Diffuse, Mirror, RoughConductor, RoughDielectric, Texture
from .result import Normalization, Result
from .run import Run, begin, merge, open_run, render
from .scene import Scene, gallery, load
from .shapes import Arc, Circle, Mesh, Parallelogram, Polyline, Segment, Shape, Sphere, Triangle
from .tables import dials, methods
from .tracing import Replay, replay, trace

__version__: str = _version()

__all__ = [
    "Arc",
    "BuildError",
    "Camera",
    "Check",
    "Circle",
    "Comparison",
    "Conductor",
    "Dielectric",
    "Diffuse",
    "FileError",
    "Interrupted",
    "Mesh",
    "Mirror",
    "NoLightFound",
    "Normalization",
    "OutputError",
    "Parallelogram",
    "Polyline",
    "Replay",
    "Result",
    "RoughConductor",
    "RoughDielectric",
    "Run",
    "RunError",
    "Scene",
    "SceneError",
    "Segment",
    "Shape",
    "Sphere",
    "Texture",
    "Triangle",
    "UsageError",
    "WanderlightError",
    "begin",
    "build",
    "check",
    "compare",
    "dials",
    "gallery",
    "import_mitsuba",
    "load",
    "merge",
    "methods",
    "open_run",
    "plot",
    "render",
    "replay",
    "trace",
]
