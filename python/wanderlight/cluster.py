"""Runs spread over a Dask cluster, and merged to the bit."""

from __future__ import annotations

import socket
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator, Mapping, NamedTuple, Sequence

from . import _wander
from .errors import Interrupted, NoLightFound, SceneError, UsageError
from .progress import Bar, Progress
from .result import Result
from .run import merge
from .scene import Scene, _again
from .words import Budget, budget_text, command_line

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["budgets_of_runs", "make_turns", "render_on"]

# What of a run's directory is sent: the rest is made of it, or is a picture.
_MERGED = ("checkpoint", "run.json")
_READ = ("run.json", "film.nc")


class _Job(NamedTuple):
    text: str
    source: str
    meshes: Mapping[str, str]
    files: Mapping[str, str]
    method: str
    dials: Mapping[str, str]
    seed: int
    budget: str
    threads: int
    kept: tuple[str, ...]


def budgets_of_runs(budget: Budget, runs: int) -> list[str]:
    """What each of the runs computes: its part of the samples, or all of the time.

    Examples
    --------
    >>> from wanderlight.cluster import budgets_of_runs
    >>> budgets_of_runs("1k", 3)
    ['334', '333', '333']
    >>> budgets_of_runs("30s", 2)
    ['30s', '30s']
    """
    text = budget_text(budget)
    samples = _wander.samples_of_budget(text)
    if samples is None:
        if "<" in text:
            raise UsageError(f"budget {text}: a cluster takes samples or a time, for no run knows the error of all")
        return [text] * runs
    if samples < runs:
        raise UsageError(f"budget {text}: {runs} runs share at least {runs} samples")
    return [str(samples // runs + (1 if k < samples % runs else 0)) for k in range(runs)]


def _sent(scene: Scene) -> tuple[str, str, Mapping[str, str], Mapping[str, str]]:
    return scene.text, scene.source, scene._meshes.texts if scene._meshes else {}, scene.files


def _scene_of(job: _Job) -> Scene:
    """On a worker; raises SceneError where a file that the scene names is not the one that was sent for."""
    scene = _again(job.text, job.source, job.meshes)
    changed = [name for name, digest in job.files.items() if scene.files.get(name) != digest]
    if changed:
        raise SceneError(
            f"{', '.join(changed)}: on the worker {socket.gethostname()} this is another file than where the scene "
            "was read; give all workers the same"
        )
    return scene


def _files_of(job: _Job) -> dict[str, bytes]:
    """On a worker: makes a run, and gives the files of it that are wanted."""
    scene = _scene_of(job)
    line = command_line(["render", job.source, "-m", job.method, "-b", job.budget, "-s", job.seed], job.dials)
    engine = _wander.Run(scene._bound, job.method, dict(job.dials), job.seed, line)
    engine.go_on(job.budget, job.threads, None, None)
    with tempfile.TemporaryDirectory(prefix="wanderlight-") as folder:
        engine.write(folder, True, 0.0)
        return {name: Path(folder, name).read_bytes() for name in job.kept if Path(folder, name).exists()}


def _write(files: Mapping[str, bytes], folder: Path) -> Path:
    folder.mkdir()
    for name, content in files.items():
        (folder / name).write_bytes(content)
    return folder


def _gather(client: Client, jobs: Sequence[_Job], progress: Progress) -> Iterator[tuple[int, Any]]:
    """The number of each job, and its files or what it raised, as they come."""
    from distributed import as_completed

    # A worker that dies takes its run with it; Dask has another make it anew.
    futures: dict[Any, int] = {client.submit(_files_of, job, pure=False): number for number, job in enumerate(jobs)}
    done = 0
    try:
        with Bar(progress) as bar:
            for future in as_completed(list(futures)):
                failure = future.exception()
                yield futures[future], failure if failure is not None else future.result()
                future.release()
                done += 1
                if bar.listener is not None:
                    bar.listener(done / len(jobs), 0, 0.0, f"{done} of {len(jobs)} runs")
    finally:
        if done < len(jobs):
            client.cancel(list(futures))


def render_on(
    client: Client,
    scene: Scene,
    method: str,
    budget: Budget,
    *,
    seed: int,
    threads: int,
    runs: int,
    progress: Progress,
    dials: Mapping[str, str],
) -> Result:
    """What `wanderlight.render` does with a client.

    Returns
    -------
    Result
        That of `runs` runs with the seeds seed, seed + 1, ..., merged: whichever workers made them, the same bits.

    Examples
    --------
    >>> import wanderlight as wl
    >>> from distributed import Client                                                      # doctest: +SKIP
    >>> wl.render("gallery:slit", "mlt", "8M", client=Client("tcp://scheduler:8786"))       # doctest: +SKIP
    """
    if seed + runs - 1 >= 2**64:
        raise UsageError(f"seed {seed}: the last of {runs} runs would have one that is not below 2^64")
    seeds = range(seed, seed + runs)
    # What is wrong is said here, before anything is sent.
    _wander.Run(scene._bound, method, dict(dials), seed, "")
    jobs = [
        _Job(*_sent(scene), method, dict(dials), each, part, threads, _MERGED)
        for each, part in zip(seeds, budgets_of_runs(budget, runs))
    ]
    with tempfile.TemporaryDirectory(prefix="wanderlight-") as folder:
        parts: list[Path] = []
        try:
            for number, files in _gather(client, jobs, progress):
                if isinstance(files, BaseException):
                    raise files
                parts.append(_write(files, Path(folder, f"run-{number}")))
                scene._save_meshes(parts[-1])
        except KeyboardInterrupt as stop:
            so_far = merge(parts) if parts else None
            raise Interrupted(f"interrupted after {len(parts)} of {runs} runs", so_far) from stop
        return merge(parts)


def make_turns(client: Client, scene: Scene, engine: _wander.Comparison, threads: int, progress: Progress) -> None:
    """Makes the runs of a comparison on a cluster.

    Examples
    --------
    >>> import wanderlight as wl
    >>> from distributed import Client                                                      # doctest: +SKIP
    >>> wl.compare("gallery:slit", client=Client("tcp://scheduler:8786"))                   # doctest: +SKIP
    """
    jobs = [
        _Job(
            *_sent(scene),
            turn["method"],
            turn["dials"],
            turn["seed"],
            turn["budget"],
            threads,
            _READ,
        )
        for turn in engine.turns()
    ]
    with tempfile.TemporaryDirectory(prefix="wanderlight-") as folder:
        for number, files in _gather(client, jobs, progress):
            if isinstance(files, NoLightFound):
                engine.take_failure(number, str(files))
            elif isinstance(files, BaseException):
                raise files
            else:
                engine.take(number, _wander.Record.read(str(_write(files, Path(folder, str(number))))))
