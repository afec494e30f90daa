"""Scenes: read, or built of parts."""

from __future__ import annotations

import hashlib
import json
import re
import tempfile
from pathlib import Path
from typing import Any, Iterable, Mapping, Union

import pandas as pd

from . import _wander
from .camera import Camera
from .materials import Material
from .shapes import Mesh, Shape

__all__ = ["Scene", "SceneLike", "gallery", "load"]

FORMAT = "wanderlight-scene/1"
_OWN_MESH = "mesh-[0-9a-f]{12}[.]obj"


class Scene:
    """A valid scene.

    Parameters
    ----------
    shapes : iterable of Shape
        All of the plane, or all of space.
    camera : Camera, optional
        If no shape is a sensor.
    max_vertices : int, optional
        The most vertices of a path, both ends counted.
    name, description : str, optional
        What it is, and why.
    folder : str or Path, optional
        Where the files of meshes and textures lie.

    Raises
    ------
    SceneError
        With all its faults, as `wander inspect` tells them.

    Examples
    --------
    >>> import wanderlight as wl
    >>> plaster = wl.Diffuse(0.5)
    >>> scene = wl.Scene([
    ...     wl.Polyline([(0, 0), (2, 0), (2, 2), (0, 2)], closed=True, material=plaster),
    ...     wl.Segment((1.1, 1.9), (0.9, 1.9), light=1),
    ...     wl.Segment((0.5, 0.1), (1.5, 0.1), sensor=20)], name="a room")
    >>> scene
    <wanderlight.Scene 'a room', 2D, at most 8 vertices>
    """

    def __init__(
        self,
        shapes: Iterable[Shape],
        *,
        camera: Camera | None = None,
        max_vertices: int | None = None,
        name: str | None = None,
        description: str | None = None,
        folder: str | Path | None = None,
    ) -> None:
        document = _Writer(list(shapes), camera)
        about = {"name": name, "description": description, "max_vertices": max_vertices}
        self._meshes = _OwnMeshes(document.meshes) if document.meshes else None
        if self._meshes:
            if folder is not None:
                raise ValueError("meshes of arrays lie in a folder of their own: leave out folder=, or save them there")
            folder = self._meshes.folder
        self._bound = _parsed(document.as_dict(about), name or "scene", folder)

    @classmethod
    def _of(cls, bound: _wander.Scene, meshes: _OwnMeshes | None = None) -> Scene:
        scene = cls.__new__(cls)
        scene._meshes = meshes
        scene._bound = bound
        return scene

    @property
    def name(self) -> str:
        """Of the scene file."""
        return self._bound.name

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return self._bound.dimension

    @property
    def max_vertices(self) -> int:
        """The most vertices of a path, both ends counted."""
        return self._bound.max_vertices

    @property
    def source(self) -> str:
        """Where it is from: a file, ``gallery:NAME``, or what it was called."""
        return self._bound.source

    @property
    def sha256(self) -> str:
        """Of its text."""
        return self._bound.sha256

    @property
    def files(self) -> dict[str, str]:
        """The SHA-256 of each mesh and texture that its text names, by its path there."""
        return self._bound.files

    @property
    def text(self) -> str:
        """The scene file."""
        return self._bound.text

    @property
    def warnings(self) -> list[str]:
        """Doubts about its geometry, each with its place."""
        return list(self._bound.warnings)

    def curves(self) -> pd.DataFrame:
        """The segments and arcs of a scene of the plane, for drawing: one row each, lengths in metres.

        Examples
        --------
        >>> import wanderlight as wl
        >>> wl.load("gallery:slit").curves().kind.value_counts().to_dict()
        {'segment': 8}
        """
        columns = dict(self._bound.curves())
        columns["kind"] = ["segment" if kind == 0 else "arc" for kind in columns["kind"]]
        for name in ("from", "to", "center"):
            pairs = columns.pop(name)
            columns[f"{name}_x"], columns[f"{name}_y"] = pairs[::2], pairs[1::2]
        return pd.DataFrame(columns)

    def svg(self, width: float = 480) -> str:
        """The drawing of `wander plot`, as an SVG document that is so many points wide."""
        return self._bound.figure(width)

    def save(self, path: str | Path) -> None:
        """Writes the scene file, and beside it the meshes that are made of arrays; files of meshes stay where they are."""
        self._save_meshes(Path(path).parent)
        _wander.write_file(str(path), self.text.encode("utf-8"))

    def _save_meshes(self, folder: Path) -> None:
        if self._meshes:
            self._meshes.save(folder)

    def __repr__(self) -> str:
        return f"<wanderlight.Scene {self.name!r}, {self.dimension}D, at most {self.max_vertices} vertices>"

    def _repr_html_(self) -> str:
        return self.svg()

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.text, self.source, self._meshes.texts if self._meshes else {})


def _own_meshes_in(directory: Path, files: Iterable[str]) -> _OwnMeshes | None:
    """Those that were saved there, of these files of a scene."""
    own = [name for name in files if re.fullmatch(_OWN_MESH, name) and (directory / name).is_file()]
    return _OwnMeshes({name: (directory / name).read_text(encoding="ascii") for name in own}) if own else None


SceneLike = Union[Scene, str, Path, Mapping[str, Any]]


def _again(text: str, source: str, meshes: Mapping[str, str] | None = None) -> Scene:
    if not meshes:
        return Scene._of(_wander.Scene.parse(text, source))
    own = _OwnMeshes(meshes)
    return Scene._of(_wander.Scene.parse(text, str(Path(own.folder, Path(source).name))), own)


class _OwnMeshes:
    """The OBJ files of meshes that are made of arrays, by name, in a folder that lasts as long as they."""

    def __init__(self, texts: Mapping[str, str]) -> None:
        self.texts = dict(texts)
        self._place = tempfile.TemporaryDirectory(prefix="wanderlight-")
        self.folder = self._place.name
        self.save(Path(self.folder))

    def save(self, folder: Path) -> None:
        for file, text in self.texts.items():
            _wander.write_file(str(Path(folder, file)), text.encode("ascii"))


def _parsed(document: Mapping[str, Any], name: str, folder: str | Path | None) -> _wander.Scene:
    text = json.dumps(document, indent=1, ensure_ascii=False)
    return _wander.Scene.parse(text, str(Path(folder or ".", f"<{name.replace('/', '-')}>")))


class _Writer:
    """Gives materials and meshes their names."""

    def __init__(self, shapes: list[Shape], camera: Camera | None) -> None:
        self.materials: dict[str, dict[str, Any]] = {}
        self.meshes: dict[str, str] = {}  # the text of each, by its file
        self.dimension = 2
        self.shapes = [self._shape(shape) for shape in shapes]
        self.camera = camera.to_dict() if camera else None
        if camera and len(camera.position) == 3:
            self.dimension = 3

    def as_dict(self, about: Mapping[str, Any]) -> dict[str, Any]:
        said = {key: value for key, value in about.items() if value is not None}
        whole: dict[str, Any] = {"format": FORMAT, **said, "dimension": self.dimension}
        whole["materials"] = self.materials
        whole["shapes"] = self.shapes
        if self.camera:
            whole["camera"] = self.camera
        return whole

    def _shape(self, shape: Shape) -> dict[str, Any]:
        said = shape.to_dict()
        if said["type"] in ("triangle", "parallelogram", "sphere", "mesh"):
            self.dimension = 3
        if shape.material is not None:
            said["material"] = self._name_of(shape.material)
        if isinstance(shape, Mesh) and shape.file is None:
            text = shape.to_obj()
            said["file"] = f"mesh-{hashlib.sha256(text.encode()).hexdigest()[:12]}.obj"
            self.meshes[said["file"]] = text
        return said

    def _name_of(self, material: Material) -> str:
        said = material.to_dict()
        for name, known in self.materials.items():
            if known == said:
                return name
        name = f"{said['type']}-{len(self.materials) + 1}"
        self.materials[name] = said
        return name


def load(scene: SceneLike) -> Scene:
    """A scene of a file, of the gallery, or of a dictionary that says what a scene file does.

    Parameters
    ----------
    scene : str, Path, mapping or Scene
        A path, ``"gallery:NAME"`` (`gallery` has the names), or the scene itself.

    Raises
    ------
    SceneError
        With all faults of the scene, each with its place and remedy.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.load("gallery:slit")
    <wanderlight.Scene 'slit', 2D, at most 8 vertices>
    """
    if isinstance(scene, Scene):
        return scene
    if isinstance(scene, Mapping):
        return Scene._of(_parsed(scene, str(scene.get("name", "scene")), None))
    return Scene._of(_wander.Scene.open(str(scene)))


def gallery() -> list[str]:
    """The names of the scenes that come with the program; docs/gallery.md says why each is hard.

    Examples
    --------
    >>> import wanderlight as wl
    >>> "slit" in wl.gallery()
    True
    """
    return list(_wander.gallery())
