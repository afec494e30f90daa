"""Chains whose every step is recorded, and steps that are taken apart."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path
from typing import Any

from . import _wander
from .errors import Interrupted, UsageError
from .progress import Bar, Progress
from .scene import SceneLike, load
from .words import Setting, command_line, counted, seeded, setting_texts

__all__ = ["Replay", "replay", "trace"]


def trace(
    scene: SceneLike,
    method: str = "mlt",
    *,
    steps: int = 1000,
    chains: int = 4,
    every: int = 1,
    window: tuple[int, int] | None = None,
    seed: int = 1,
    threads: int = 0,
    progress: Progress = None,
    out: str | Path | None = None,
    **dials: Setting,
) -> Any:
    """Runs some chains and records every step: what was proposed, every term of its acceptance, and the state after.

    Parameters
    ----------
    scene : str, Path, mapping or Scene
        As `render` takes it.
    method : {"mlt", "mmlt"}
        A chain whose state is one path.
    steps : int
        Of each chain.
    chains : int
        The first of those that `render` runs with the same seed.
    every : int
        One step of so many is recorded.
    window : (int, int), optional
        Steps ``window[0]`` to ``window[1] - 1`` are recorded; else all of `steps`.
    seed, threads, progress
        As `render` takes them.
    out : str or Path, optional
        Where the netCDF file goes, too; what `wander trace -o` writes.
    **dials
        As `render` takes them.

    Returns
    -------
    arviz.InferenceData or xarray.DataTree
        What the installed ArviZ works with: groups ``posterior`` (``sensor_u`` or ``raster_x`` and ``raster_y``,
        ``n_vertices``, ``log_f``), ``sample_stats`` (``accepted``, ``acceptance_rate``, ``mutation``, ``reason``, ...),
        ``paths``, ``proposal`` and others (docs/trajectories.md), with dimensions (chain, draw, ...).

    Raises
    ------
    SceneError, UsageError, NoLightFound, Interrupted

    Examples
    --------
    >>> import wanderlight as wl
    >>> data = wl.trace("gallery:slit", steps=100, chains=2)
    >>> dict(data["posterior"].sizes)["draw"]
    100
    """
    import arviz

    seed, threads = seeded(seed, threads)
    steps, every, chains = counted("steps", steps), counted("every", every), counted("chains", chains)
    read = load(scene)
    settings = setting_texts(dials)
    if window is not None and len(window) != 2:
        raise UsageError(f"window {window}: give the first step and the one after the last")
    first, end = (counted("window", at, 0) for at in (window if window is not None else (0, steps)))
    words: list[Any] = ["trace", read.source, "-m", method, "--chains", chains, "--window", f"{first}:{end}"]
    words += ["--every", every, "-s", seed]
    with Bar(progress) as bar:
        file, is_complete = _wander.trace(
            read._bound, method, settings, seed, threads, chains, (first, end), every,
            command_line(words, settings), bar.listener,
        )  # fmt: skip
    if not file:
        raise Interrupted("interrupted before the first step")
    with tempfile.TemporaryDirectory(prefix="wanderlight-") as folder:
        place = Path(out) if out is not None else Path(folder, "trace.nc")
        _wander.write_file(str(place), file)
        data = arviz.from_netcdf(str(place))
        _load(data)
    if not is_complete:
        raise Interrupted("interrupted; `run` has the steps that all chains have", data)
    return data


def _load(data: Any) -> None:
    """Into memory, before its file is gone."""
    if hasattr(data, "groups") and callable(data.groups):
        for group in data.groups():
            data[group].load()
    else:
        data.load()


class Replay:
    """One step of a chain, made again and taken apart.

    Attributes
    ----------
    factors : dict
        Every factor of the acceptance ratio, of the paths and of the proposal, as `wander trace --replay --json`
        prints them.

    Examples
    --------
    >>> import wanderlight as wl
    >>> step = wl.replay("gallery:slit", chain=0, step=17)
    >>> step.factors["mutation"], step.factors["acceptance_rate"]
    ('primary_large', 0.0)
    """

    def __init__(self, factors: dict[str, Any], text: str) -> None:
        self.factors = factors
        self._text = text

    def __repr__(self) -> str:
        return self._text.rstrip()


def replay(scene: SceneLike, chain: int, step: int, *, seed: int = 1, threads: int = 0, **dials: Setting) -> Replay:
    """Takes a step of `mlt` apart: every factor of its acceptance ratio.

    Parameters
    ----------
    scene : str, Path, mapping or Scene
        As `render` takes it.
    chain, step : int
        Of those that `trace` records with the same seed, from 0.
    seed, threads, **dials
        As `trace` takes them.

    Returns
    -------
    Replay

    Examples
    --------
    >>> import wanderlight as wl
    >>> print(str(wl.replay("gallery:slit", chain=0, step=17)).splitlines()[0])
    chain 0, step 17: primary_large, rejected: zero_contribution
    """
    seed, threads = seeded(seed, threads)
    chain, step = counted("chain", chain, 0), counted("step", step, 0)
    data, text = _wander.replay(load(scene)._bound, setting_texts(dials), seed, threads, chain, step)
    return Replay(json.loads(data), text)
