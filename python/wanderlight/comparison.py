"""Methods against each other: error against time and samples, with intervals."""

from __future__ import annotations

import json
import shlex
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Sequence, Union

import pandas as pd

from . import _wander
from .errors import Interrupted
from .progress import Bar, Progress
from .scene import SceneLike, load
from .words import Budget, Setting, budget_text, counted, seeded, setting_text

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["Comparison", "compare"]


class Comparison:
    """What `compare` found.

    Attributes
    ----------
    record : dict
        compare.json (docs/conventions.md).
    directory : Path
        Where its files are: report.html, compare.json, compare.csv.

    Examples
    --------
    >>> import wanderlight as wl
    >>> found = wl.compare("gallery:furnace", ["pt", "bdpt"], ["1k", "2k"], replicates=2)
    >>> found.table.shape[0]
    4
    """

    def __init__(self, record: dict[str, Any], directory: Path, kept: Any = None) -> None:
        self.record = record
        self.directory = directory
        self._kept = kept

    @property
    def verdict(self) -> list[str]:
        """Who is ahead, from when on, and whether it is more than chance."""
        return list(self.record["verdict"])

    @property
    def warnings(self) -> list[str]:
        """What there is to doubt."""
        return list(self.record["warnings"])

    @property
    def contenders(self) -> list[str]:
        """Their labels."""
        return [contender["label"] for contender in self.record["contenders"]]

    @property
    def report(self) -> Path:
        """An HTML file, to be opened in a browser."""
        return self.directory / "report.html"

    @property
    def table(self) -> pd.DataFrame:
        """A row for each contender and budget; of what is measured, value, ``_low`` and ``_high`` of 95 %.

        ``relative_rmse`` is √(Σ(x−I)² / Σ I²), ``seconds`` are of the clock that budgets are in, and ``efficiency`` is
        1 / (relative MSE × seconds).
        """
        rows = []
        for cell in self.record["cells"]:
            row: dict[str, Any] = {
                "contender": self.contenders[cell["contender"]],
                "budget": self.record["budgets"][cell["budget"]],
            }
            for name, value in cell.items():
                if isinstance(value, Mapping):
                    row[name], row[f"{name}_low"], row[f"{name}_high"] = value["value"], value["low"], value["high"]
                elif name not in row:
                    row[name] = value
            rows.append(row)
        return pd.DataFrame(rows).set_index(["contender", "budget"])

    @property
    def runs(self) -> pd.DataFrame:
        """A row for each run: its contender, budget, replicate, seed, samples, seconds and errors."""
        rows = []
        for run in self.record["runs"]:
            row = {key: value for key, value in run.items() if not isinstance(value, (dict, list))}
            row["contender"] = self.contenders[run["contender"]]
            row["budget"] = self.record["budgets"][run["budget"]]
            rows.append({**row, **run["errors"]})
        return pd.DataFrame(rows)

    def __repr__(self) -> str:
        return "\n".join(self.verdict)

    def _repr_html_(self) -> str:
        from .view import comparison_html

        return comparison_html(self)


def compare(
    scene: SceneLike,
    methods: Sequence[str] = ("bdpt", "mlt"),
    budgets: Sequence[Budget] = ("0.25s", "1s", "4s"),
    *,
    replicates: int = 8,
    reference: str | Path = "auto",
    target: float | None = None,
    sweep: Mapping[str, Iterable[Setting]] | None = None,
    dials: Mapping[str, Setting] | None = None,
    seed: int = 1,
    threads: int = 0,
    progress: Progress = None,
    out: Union[str, Path, None] = None,
    overwrite: bool = False,
    client: Client | None = None,
) -> Comparison:
    """Runs every method several times at every budget, and says who is ahead: `wander compare`.

    Parameters
    ----------
    scene : str, Path, mapping or Scene
        As `render` takes it.
    methods : sequence of str
        Who takes part.
    budgets : sequence of int or str
        All of samples, all of wall time, or all of processor time.
    replicates : int
        Runs of each contender at each budget.
    reference : str or Path
        The directory of an earlier run; ``"auto"``: the exact film where there is one, or else long runs.
    target : float, optional
        The relative error to which times are told.
    sweep : mapping of str to iterable, optional
        Contenders at these values of a dial, such as ``{"large_step": [0.1, 0.3]}``.
    dials : mapping, optional
        Turned for all methods that have them.
    seed, threads, progress
        As `render` takes them.
    out : str or Path, optional
        Where report.html, compare.json and compare.csv go, and from where `wander compare --continue` carries it on;
        none: to a folder that lives as long as the comparison.
    overwrite : bool
        May `out` hold something?
    client : distributed.Client, optional
        A Dask cluster, whose workers make the runs, with `threads` each, one if it is 0; the reference is made here.
        Films and errors do not depend on the workers, times do.

    Returns
    -------
    Comparison

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.compare("gallery:furnace", ["pt", "bdpt"], ["2k"], replicates=2).contenders
    ['pt', 'bdpt']
    """
    seed, threads = seeded(seed, threads)
    replicates = counted("replicates", replicates, 2, 10_000)
    target = None if target is None else _wander.share_of("target", repr(target))
    kept = tempfile.TemporaryDirectory(prefix="wanderlight-") if out is None else None
    folder = Path(kept.name if kept else str(out))
    read = load(scene)
    words = {
        "methods": ",".join(methods),
        "budgets": ",".join(budget_text(budget) for budget in budgets),
        "reference": str(reference),
    }
    fixed = [f"{name}={setting_text(value)}" for name, value in (dials or {}).items()]
    sweeps = [
        f"{name}=" + "".join(setting_text(value) + ";" for value in values) for name, values in (sweep or {}).items()
    ]
    line = shlex.join(
        ["wander", "compare", read.source, "-m", words["methods"], "-b", words["budgets"], "-s", str(seed)]
    )
    engine = _wander.Comparison(
        read._bound, words, fixed, sweeps, replicates, seed, target, str(folder), overwrite, threads, line
    )
    try:
        if client is not None:
            from .cluster import make_turns

            make_turns(client, read, engine, threads or 1, progress)
        with Bar(progress) as bar:
            data = engine.finish(bar.listener)
    finally:
        engine.close()  # not when what was raised is forgotten
    found = Comparison(json.loads(data), folder, kept)
    if not found.record["complete"]:
        raise Interrupted("interrupted; `run` has the runs that are complete", found)
    return found
