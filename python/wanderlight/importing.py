"""Scenes of Mitsuba."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any, Mapping

from . import _wander
from .scene import Scene, load

__all__ = ["import_mitsuba"]


def import_mitsuba(
    file: str | Path, out: str | Path, *, approximate: bool = False, parameters: Mapping[str, Any] | None = None
) -> Scene:
    """Makes a scene file of a scene of Mitsuba 3 or 0.6, and puts its meshes beside it: `wander import`.

    Parameters
    ----------
    file : str or Path
        The XML file.
    out : str or Path
        The scene file; its meshes go into a folder beside it. What is there is replaced.
    approximate : bool
        Import the nearest thing where there is no exact one; each is told as a warning.
    parameters : mapping, optional
        The values of ``$NAME`` in the file.

    Returns
    -------
    Scene

    Raises
    ------
    SceneError
        With all that cannot be said exactly, each with its line.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import wanderlight as wl
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> _ = (folder / "box.xml").write_text('''<scene version="3.0.0">
    ...   <sensor type="perspective"><float name="fov" value="40"/>
    ...     <film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="8"/>
    ...       <rfilter type="box"/></film>
    ...     <transform name="to_world"><lookat origin="0,0,4" target="0,0,0" up="0,1,0"/></transform></sensor>
    ...   <shape type="rectangle"><emitter type="area"><rgb name="radiance" value="1"/></emitter></shape>
    ... </scene>''')
    >>> wl.import_mitsuba(folder / "box.xml", folder / "box.json").dimension
    3
    """
    given = {name: str(value) for name, value in (parameters or {}).items()}
    for note in _wander.import_mitsuba(str(file), str(out), given, approximate):
        warnings.warn(note, stacklevel=2)
    return load(out)
