"""What can go wrong, with the messages of the program: each says where, and what to do about it.

================  =====================================================================
class             raised where
================  =====================================================================
SceneError        a scene, or a scene to be imported, is not valid
UsageError        what is asked for does not exist, or makes no sense
FileError         another input file is not what it should be
OutputError       an output cannot be written
RunError          a run fails
NoLightFound      no light reaches the sensor, so that no chain can start
Interrupted       Ctrl-C ended a run; what was computed is in its ``run``
================  =====================================================================
"""

from __future__ import annotations

from typing import Any

__all__ = [
    "FileError",
    "Interrupted",
    "NoLightFound",
    "OutputError",
    "RunError",
    "SceneError",
    "UsageError",
    "WanderlightError",
]


class WanderlightError(Exception):
    """All of them but `Interrupted`.

    Examples
    --------
    >>> import wanderlight as wl
    >>> try:
    ...     wl.render("gallery:slit", "no-such-method", 1000)
    ... except wl.WanderlightError as error:
    ...     print(type(error).__name__)
    UsageError
    """


class UsageError(WanderlightError, ValueError):
    """What is asked for does not exist, or makes no sense.

    Examples
    --------
    >>> import wanderlight as wl
    >>> try:
    ...     wl.load("gallery:slitt")
    ... except wl.UsageError as error:
    ...     print(str(error).split("?")[0])
    unknown scene "slitt"; did you mean "slit"
    """


class SceneError(WanderlightError, ValueError):
    """A scene is not valid.

    Attributes
    ----------
    faults : list of (int, int, str, str)
        Line and column, from 1, the JSON pointer (of an imported scene, the path of the element), and what is wrong
        there.

    Examples
    --------
    >>> import wanderlight as wl
    >>> try:
    ...     wl.Scene([wl.Segment((0, 0), (1, 0), light=-1), wl.Segment((0, 1), (1, 1), sensor=10)])
    ... except wl.SceneError as error:
    ...     print(error.faults[0][2:])
    ('/shapes/0/light/radiance', '-1 is not allowed; a radiance is > 0, from 1e-36 to 1e36')
    """

    faults: list[tuple[int, int, str, str]] = []


class FileError(WanderlightError, ValueError):
    """An input file other than a scene is not what it should be.

    Examples
    --------
    >>> import wanderlight as wl
    >>> import pathlib, tempfile
    >>> file = pathlib.Path(tempfile.mkdtemp(), "run.json")
    >>> _ = file.write_text("{}")
    >>> try:
    ...     wl.open_run(file)
    ... except wl.FileError:
    ...     print("no run")
    no run
    """


class OutputError(WanderlightError, OSError):
    """An output cannot be written.

    Examples
    --------
    >>> import wanderlight as wl
    >>> run = wl.render("gallery:furnace", "bdpt", 1000)
    >>> try:
    ...     run.save("/dev/null/run")
    ... except wl.OutputError:
    ...     print("nothing can be written there")
    nothing can be written there
    """


class RunError(WanderlightError, RuntimeError):
    """A run fails: it would take more memory than there is, for example.

    Examples
    --------
    >>> import wanderlight as wl
    >>> issubclass(wl.RunError, RuntimeError)
    True
    """


class NoLightFound(RunError):
    """No light reaches the sensor, so that no chain can start.

    Examples
    --------
    >>> import wanderlight as wl
    >>> lamp = wl.Segment((0, 0), (1, 0), light=1)
    >>> away = wl.Segment((0, -1), (1, -1), sensor=4)
    >>> try:
    ...     wl.render(wl.Scene([lamp, away], max_vertices=2), "mlt", 1000)
    ... except wl.NoLightFound:
    ...     print("the lamp shines up, and the sensor looks up from below it")
    the lamp shines up, and the sensor looks up from below it
    """


class Interrupted(KeyboardInterrupt):
    """Ctrl-C ended a run; nothing of it is lost.

    Attributes
    ----------
    run : Run or None
        What was computed; ``run.advance()`` carries it on. In a notebook, after the cell was interrupted, it is
        ``sys.last_value.run``.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.Interrupted("after 3 s").run is None
    True
    """

    def __init__(self, message: str = "interrupted", run: Any = None) -> None:
        super().__init__(message)
        self.run = run
