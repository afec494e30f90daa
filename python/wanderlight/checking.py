"""Does each mutation leave the target invariant on a scene, and do the methods agree?"""

from __future__ import annotations

import json
from typing import Any

import pandas as pd

from . import _wander
from .progress import Bar, Progress
from .scene import SceneLike, load
from .words import Setting, counted, seeded, setting_texts

__all__ = ["Check", "check"]


class Check:
    """What a check found.

    Attributes
    ----------
    record : dict
        What `wander check --json` prints.

    Examples
    --------
    >>> import wanderlight as wl
    >>> bool(wl.check("gallery:furnace", samples=2000))
    True
    """

    def __init__(self, record: dict[str, Any], text: str) -> None:
        self.record = record
        self._text = text

    @property
    def passed(self) -> bool:
        """No test failed, and there was one."""
        return bool(self.record["passed"])

    def __bool__(self) -> bool:
        return self.passed

    @property
    def table(self) -> pd.DataFrame:
        """A row for each mutation and method: its verdict, in a word and in words."""
        rows = [*self.record["mutations"], *self.record["methods"]]
        return pd.DataFrame(rows)[["name", "verdict", "words"]].set_index("name")

    def __repr__(self) -> str:
        return self._text.rstrip()


def check(
    scene: SceneLike,
    *,
    samples: int = 200_000,
    seed: int = 1,
    threads: int = 0,
    progress: Progress = None,
    **dials: Setting,
) -> Check:
    """Tests every mutation of `mlt`, and every method, on a scene.

    Parameters
    ----------
    scene : str, Path, mapping or Scene
        As `render` takes it.
    samples : int
        Independent paths from which each mutation starts; each method makes four times as many samples.
    seed, threads, progress, **dials
        As `render` takes them.

    Returns
    -------
    Check
        True if no test failed; a correct program fails with a probability of 10⁻⁶.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.check("gallery:furnace", samples=2000).table.loc["mixture", "verdict"]
    'passed'
    """
    seed, threads = seeded(seed, threads)
    samples = counted("samples", samples)
    with Bar(progress) as bar:
        data, text = _wander.check(load(scene)._bound, setting_texts(dials), samples, seed, threads, bar.listener)
    return Check(json.loads(data), text)
