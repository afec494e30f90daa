"""Wanderlight: a Metropolis light transport testbed.

>>> import wanderlight as wl
>>> run = wl.render("gallery:slit", "mlt", "100k")

`render` computes the film of a scene, with its errors; `begin` a run that is advanced by hand; `trace` records every
step of some chains for ArviZ; `compare` holds methods against each other; `check` tests every mutation on a scene;
`plot` draws them with matplotlib. Scenes are files, of the gallery (`gallery`), dictionaries, or built of `Segment`,
`Circle`, `Mesh`, `Diffuse` and others. All of it computes the bits of the program `wander`.
"""

from wanderlight import plot
from wanderlight._wander import version as _version
from wanderlight.checking import Check, check
from wanderlight.comparison import Comparison, compare
from wanderlight.errors import (
    FileError,
    Interrupted,
    NoLightFound,
    OutputError,
    RunError,
    SceneError,
    UsageError,
    WanderlightError,
)
from wanderlight.importing import import_mitsuba
from wanderlight.parts import (
    Arc,
    Camera,
    Circle,
    Conductor,
    Dielectric,
    Diffuse,
    Mesh,
    Mirror,
    Parallelogram,
    Polyline,
    RoughConductor,
    RoughDielectric,
    Segment,
    Shape,
    Sphere,
    Texture,
    Triangle,
)
from wanderlight.result import Normalization, Result
from wanderlight.run import Run, begin, merge, open_run, render
from wanderlight.scene import Scene, gallery, load
from wanderlight.tables import dials, methods
from wanderlight.tracing import Replay, replay, trace

__version__: str = _version()

__all__ = [
    "Arc",
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
