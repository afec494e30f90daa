"""Runs: made at once, or by hand, as far as one likes."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Iterable, Iterator, Union

from . import _wander
from .errors import Interrupted, SceneError, UsageError
from .progress import Bar, Progress
from .result import Result
from .scene import Scene, SceneLike, _own_meshes_in, load
from .words import Budget, Setting, budget_text, command_line, counted, seeded, setting_texts

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["Run", "begin", "merge", "open_run", "render"]

PathLike = Union[str, Path]


class Run(Result):
    """A run that goes on as often as it is asked: `begin` and `render` make one.

    It is also the `Result` of what it has computed so far. Iterated over, it gives a `Result` every second until its
    budget is reached::

        for preview in run:
            if preview.relative_error < 0.02:
                break

    However often it rests, its bits are those of `wander render` with the same budget; left early, it goes on later.

    Examples
    --------
    >>> import wanderlight as wl
    >>> run = wl.begin("gallery:slit", "mlt", budget="200k")
    >>> for preview in run.previews(every=0.05):
    ...     if preview.relative_error < 0.05:
    ...         break
    >>> run.advance("300k").samples
    300000
    """

    def __init__(self, engine: _wander.Run, scene: Scene, budget: Budget, threads: int) -> None:
        self._engine = engine
        self._scene = scene
        self._budget = budget
        self._threads = threads
        self._made: _wander.Record | None = None
        self._json = None
        self._axes = None

    @property
    def _record(self) -> _wander.Record:  # type: ignore[override]
        if self._made is None:
            raise UsageError("nothing is computed yet: advance() the run")
        return self._made

    @property
    def budget(self) -> Budget:
        """To which it goes on."""
        return self._budget

    def advance(self, budget: Budget | None = None, *, progress: Progress = None) -> Run:
        """Carries the run on.

        A pooled run of chains that was planned for few steps begins again beyond its budget (docs/runs.md); what it had
        is shown, and saved, until there is as much of the new one or the new one has ended.

        Parameters
        ----------
        budget : int or str, optional
            Of the whole run, as `render` takes it; none: its own. Of a number of samples that it has already nothing is
            left to do.
        progress : bool or callable, optional
            A bar; or what is called with (fraction, samples, seconds, phase).

        Returns
        -------
        Run
            Itself.

        Raises
        ------
        Interrupted
            After Ctrl-C; what was computed is there, and the run can go on.
        """
        if budget is not None:
            self._budget = budget
        self._go_on(None, progress)
        return self

    def previews(self, every: float = 1.0, *, progress: Progress = False) -> Iterator[Result]:
        """Carries the run on to its budget, and rests now and then to be looked at.

        Parameters
        ----------
        every : float
            Seconds of sampling between two rests.
        progress : bool or callable, optional
            As in `advance`.

        Yields
        ------
        Result
            All that has come out so far; the last is that of the whole budget.
        """
        while True:
            is_complete = self._go_on(every, progress)
            yield Result(self._record, self._scene)
            if is_complete:
                return

    def __iter__(self) -> Iterator[Result]:
        return self.previews()

    def save(self, directory: PathLike, *, overwrite: bool = False, exposure: float = 0.0) -> None:
        """Writes the files of `wander render -o DIR`, from which `wander render --continue` carries the run on.

        Parameters
        ----------
        directory : str or Path
            New, or empty.
        overwrite : bool
            May it hold a run already?
        exposure : float
            Of the picture of an image, in stops.
        """
        self._record  # there is one
        self._engine.write(str(directory), overwrite, exposure)
        if self._scene is not None:
            self._scene._save_meshes(Path(directory))

    def _go_on(self, rest: float | None, progress: Progress) -> bool:
        """True if the budget is reached."""
        with Bar(progress) as bar:
            ended = self._engine.go_on(budget_text(self._budget), self._threads, rest, bar.listener)
        self._made, self._json = self._engine.record, None
        if ended == "interrupted":
            done = f" after {self.samples:,} samples" if self._made else " before the first sample"
            raise Interrupted(f"interrupted{done}; the run goes on with advance()", self)
        return ended == "complete"

    def __repr__(self) -> str:
        return super().__repr__() if self._made else "<wanderlight.Run, nothing computed yet>"

    def _repr_html_(self) -> str:
        return super()._repr_html_() if self._made else repr(self)


def begin(
    scene: SceneLike,
    method: str = "mlt",
    budget: Budget = "5s",
    *,
    seed: int = 1,
    threads: int = 0,
    **dials: Setting,
) -> Run:
    """A run of which nothing is computed yet; the parameters are those of `render`.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.begin("gallery:furnace", "bdpt", "20k").advance().samples
    20000
    """
    seed, threads = seeded(seed, threads)
    read = load(scene)
    settings = setting_texts(dials)
    text = budget_text(budget)
    _wander.samples_of_budget(text)  # it is one
    words = ["render", read.source, "-m", method, "-b", text, "-s", seed]
    engine = _wander.Run(read._bound, method, settings, seed, command_line(words, settings))
    return Run(engine, read, budget, threads)


def render(
    scene: SceneLike,
    method: str = "mlt",
    budget: Budget = "5s",
    *,
    seed: int = 1,
    threads: int = 0,
    progress: Progress = None,
    client: Client | None = None,
    runs: int = 8,
    **dials: Setting,
) -> Run | Result:
    """The film of a scene by one method, with its errors: what `wander render` computes, to the bit.

    Parameters
    ----------
    scene : str, Path, mapping or Scene
        What to render: a file, ``"gallery:NAME"``, or the scene itself.
    method : str
        One of `methods`: ``"bdpt"``, ``"mlt"``, ...
    budget : int or str
        Samples (``2_000_000``, ``"2M"``), time (``"30s"``, ``"30cpu-s"``) or the error of the film (``"error<1%"``).
    seed : int
        Of its random numbers. The same seed and number of samples give the same bits, whatever the threads.
    threads : int
        0: all cores.
    progress : bool or callable, optional
        A bar; or what is called with (fraction, samples, seconds, phase). None: a bar where somebody watches.
    client : distributed.Client, optional
        A Dask cluster: `runs` runs with the seeds seed, seed + 1, ... share the budget, and are merged. The bits
        do not depend on the workers; `threads` are those of each run, one if it is 0.
    runs : int
        How many, on a cluster.
    **dials
        As `wander render --help` names them: ``large_step=0.1``, ``mutations={"lens": 1}``, ``by_length=True``;
        `dials` has them all.

    Returns
    -------
    Run
        On a cluster a `Result`.

    Raises
    ------
    SceneError, UsageError
        Before anything is computed.
    NoLightFound, RunError
    Interrupted
        After Ctrl-C; its ``run`` has what was computed, and can go on.

    Examples
    --------
    >>> import wanderlight as wl
    >>> run = wl.render("gallery:slit", "bdpt", "100k", seed=2)
    >>> float(run.film.mean()) > 0
    True
    """
    if client is not None:
        from .cluster import render_on

        seed, threads = seeded(seed, threads)
        runs = counted("runs", runs)

        return render_on(
            client,
            load(scene),
            method,
            budget,
            seed=seed,
            threads=threads or 1,
            runs=runs,
            progress=progress,
            dials=setting_texts(dials),
        )
    return begin(scene, method, budget, seed=seed, threads=threads, **dials).advance(progress=progress)


def open_run(path: PathLike, *, scene: PathLike | None = None) -> Result:
    """A run that was saved, by `Run.save` or by `wander render`.

    Parameters
    ----------
    path : str or Path
        Its directory, or its run.json, film.exr or film.nc.
    scene : str or Path, optional
        Where its scene is now, if that names meshes or textures that have moved.

    Returns
    -------
    Run or Result
        A `Run`, which goes on where it was, if its directory holds a checkpoint and the files of its scene are to be
        had; else a `Result`, and where it is for want of these a warning that says so.

    Raises
    ------
    FileError
        Where there is no run, or a damaged one.
    UsageError
        Where `scene` is another, or a file that it names has changed.
    SceneError
        Where `scene` is none.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import wanderlight as wl
    >>> directory = pathlib.Path(tempfile.mkdtemp(), "run")
    >>> wl.render("gallery:slit", "mlt", "50k").save(directory)
    >>> wl.open_run(directory).advance("60k").samples
    60000
    """
    record = _wander.Record.read(str(path))
    result = Result(record, None)
    if not (Path(path) / "checkpoint").is_file():
        return result
    try:
        engine, found, budget = _wander.Run.resumed(str(path), str(scene or ""))
    except SceneError as problem:
        if scene is not None:
            raise
        warnings.warn(f"{path} can be looked at, but not go on: {problem}", stacklevel=2)
        return result
    run = Run(engine, Scene._of(found, _own_meshes_in(Path(path), found.files)), budget, 0)
    run._made = record
    return run


def merge(runs: Iterable[PathLike], *, scene: PathLike | None = None, threads: int = 0) -> Result:
    """Runs of one scene and method with different seeds as one run of all their samples.

    Parameters
    ----------
    runs : iterable of str or Path
        Their directories, with their checkpoints, in any order.
    scene : str or Path, optional
        Where their scene is now, if that names meshes or textures that have moved.
    threads : int
        0: all cores.

    Returns
    -------
    Result
        To the bit what `wander merge` makes.

    Raises
    ------
    UsageError
        If they do not belong together.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import wanderlight as wl
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> for seed in (1, 2):
    ...     wl.render("gallery:furnace", "bdpt", "10k", seed=seed).save(folder / str(seed))
    >>> wl.merge([folder / "1", folder / "2"]).samples
    20000
    """
    if isinstance(runs, (str, os.PathLike)):
        raise UsageError(f"merge {runs}: give the directories of several runs, in a list")
    directories = list(runs)
    for run in directories:
        if not isinstance(run, (str, os.PathLike)):
            raise UsageError(f"merge takes the directories of runs that were saved, not a {type(run).__name__}")
    return Result(_wander.merge([str(run) for run in directories], str(scene or ""), threads), None)
