"""What a run computed: films with coordinates and units, their errors, and the records of its chains."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Mapping

import numpy as np
import pandas as pd
import xarray as xr

from . import _wander
from .errors import UsageError
from .scene import Scene, _again

__all__ = ["Normalization", "Result"]

_COLOURS = ["R", "G", "B"]


@dataclass(frozen=True)
class Normalization:
    """The constant b, by which a chain's histogram becomes a film: the light on the film as a whole.

    Attributes
    ----------
    value, standard_error : float
        In the units of the film times its measure.
    method : str
        Which of the estimates it is.
    estimates : pandas.DataFrame
        By ``seed_pass``, ``least_squares`` and ``bridge``: value, standard_error, samples and degrees_of_freedom.
    by_length : pandas.DataFrame
        Of paths of each number of vertices: value and standard_error.

    Examples
    --------
    >>> import wanderlight as wl
    >>> b = wl.render("gallery:furnace", "mlt", "50k").normalization
    >>> b.standard_error < b.value
    True
    """

    value: float
    standard_error: float
    method: str
    estimates: pd.DataFrame
    by_length: pd.DataFrame


def _number(x: Any) -> float:
    return float("nan") if x is None else float(x)


class Result:
    """What a run has computed so far; it does not change.

    Films are `xarray.DataArray` over the memory of the engine, which is not copied, and cannot be written to. In the
    plane their dimension is ``position``, in metres along the sensor (of a camera, the fraction of its width); images
    have ``y``, from the top, ``x`` and, in colour, ``channel``.

    Examples
    --------
    >>> import wanderlight as wl
    >>> run = wl.render("gallery:furnace", "bdpt", "100k")
    >>> run.film.dims, run.film.attrs["units"]
    (('position',), 'W/m')
    >>> bool((run.standard_error > 0).all())
    True
    """

    def __init__(self, record: _wander.Record, scene: Scene | None) -> None:
        self._record = record
        self._scene = scene
        self._json: dict[str, Any] | None = None
        self._axes: dict[str, Any] | None = None

    # ---- what it is of

    @property
    def record(self) -> dict[str, Any]:
        """run.json (docs/runs.md), but for the numbers of films."""
        if self._json is None:
            self._json = json.loads(self._record.json)
        return self._json

    @property
    def scene(self) -> Scene:
        """What was rendered."""
        if self._scene is None:
            self._scene = _again(self.record["scene"]["text"], self.record["scene"]["name"])
        return self._scene

    @property
    def name(self) -> str:
        """Of the scene."""
        return str(self.record["scene"]["name"])

    @property
    def method(self) -> str:
        """By which it was rendered."""
        return str(self.record["method"])

    @property
    def complete(self) -> bool:
        """False if the run was ended before its budget was."""
        return bool(self.record["complete"])

    @property
    def samples(self) -> int:
        """Independent samples, or mutations."""
        return int(self.record["samples"])

    @property
    def seed(self) -> int:
        """Of its random numbers; of merged runs the first."""
        return int(self.record["seed"])

    @property
    def seconds(self) -> float:
        """Wall time, from the building of the scene to the last number."""
        return float(self.record["seconds"])

    @property
    def warnings(self) -> list[str]:
        """What there is to doubt, in words."""
        return list(self.record["warnings"])

    @property
    def axes(self) -> dict[str, Any]:
        """What the film is of: ``value`` and, of a row of bins, ``position``, each with ``name`` and ``unit``."""
        if self._axes is None:
            self._axes = dict(self._record.axes())
        return self._axes

    # ---- films

    @property
    def film(self) -> xr.DataArray:
        """The estimate: mean irradiance of each bin, or mean radiance of a camera's."""
        return self._array(self._record.film.value, "film")

    @property
    def standard_error(self) -> xr.DataArray:
        """One standard deviation of `film`; NaN where it cannot be told."""
        return self._array(self._record.film.standard_error, "standard_error")

    @property
    def reliable(self) -> xr.DataArray:
        """True where the interval of a bin holds what it promises."""
        return self._array(self._record.film.reliable, "reliable")

    @property
    def by_length(self) -> xr.DataArray:
        """The film of paths of each number of vertices alone, along a dimension ``vertices``."""
        lengths = dict(self._record.film.by_length)
        if not lengths:
            raise ValueError("films by length were not kept: ask for them with by_length=True")
        films = [self._array(numbers, "film") for numbers in lengths.values()]
        return xr.concat(films, pd.Index(list(lengths), name="vertices"))

    @property
    def chains_film(self) -> xr.DataArray | None:
        """The film of the chains alone, where the film is pooled of chains and samples (docs/pooled-film.md)."""
        film = self._record.chains_film
        return None if film is None or film.value is None else self._array(film.value, "film")

    @property
    def film_of_samples(self) -> xr.DataArray | None:
        """What of a pooled film independent samples carry."""
        numbers = self._record.film_of_samples
        return None if numbers is None else self._array(numbers, "film")

    @property
    def relative_error(self) -> float:
        """Of the film as a whole: √(Σ standard_error² / Σ film²)."""
        return float(self._record.film.relative_error)

    @property
    def degrees_of_freedom(self) -> float:
        """Of the t-intervals around every bin."""
        return float(self._record.film.degrees_of_freedom)

    def interval(self, level: float = 0.95) -> tuple[xr.DataArray, xr.DataArray]:
        """The t-intervals of the film, bin by bin.

        Parameters
        ----------
        level : float
            The probability that a bin's interval holds its value, between 0 and 1.

        Returns
        -------
        low, high : xarray.DataArray
            Of the shape and in the units of the film.

        Raises
        ------
        UsageError
            If the level is no probability.

        Examples
        --------
        >>> import wanderlight as wl
        >>> low, high = wl.render("gallery:furnace", "bdpt", "100k").interval()
        >>> bool((low < high).all())
        True
        """
        from scipy.stats import t

        if not 0 < level < 1:
            raise UsageError(f"level {level}: a probability is above 0 and below 1, as in 0.95")
        freedom = self.degrees_of_freedom
        half = self.standard_error * float(t.ppf(0.5 + level / 2, freedom if np.isfinite(freedom) else 1e9))
        low, high = self.film - half, self.film + half
        return low.assign_attrs(self.film.attrs), high.assign_attrs(self.film.attrs)

    def to_dataset(self) -> xr.Dataset:
        """Film, error and reliability together.

        Examples
        --------
        >>> import wanderlight as wl
        >>> sorted(wl.render("gallery:furnace", "bdpt", "10k").to_dataset())
        ['film', 'reliable', 'standard_error']
        """
        layers = {"film": self.film, "standard_error": self.standard_error, "reliable": self.reliable}
        about = {key: self.record[key] for key in ("method", "samples", "seed", "command_line", "version")}
        return xr.Dataset(layers, attrs={"scene": self.record["scene"]["name"], **about})

    # ---- chains

    @property
    def normalization(self) -> Normalization | None:
        """Of chains; None of independent samples."""
        said = self.record.get("normalization")
        if said is None:
            return None
        estimates = pd.DataFrame(said["estimates"]).T
        return Normalization(
            value=_number(said["value"]),
            standard_error=_number(said["standard_error"]),
            method=said["method"],
            estimates=estimates,
            by_length=pd.DataFrame(said["by_length"]).set_index("vertices") if said["by_length"] else pd.DataFrame(),
        )

    @property
    def mutations(self) -> pd.DataFrame:
        """One row for each mutation: how often it was proposed and accepted, how far it moves, and what it costs.

        Columns are ``proposed``, ``accepted``, ``mean_acceptance``, ``seconds``, ``squared_jump`` (in units of the
        sensor's length or the picture's width, squared) and ``longest_rejection_run``.

        Examples
        --------
        >>> import wanderlight as wl
        >>> run = wl.render("gallery:slit", "mlt", "20k", mutations={"lens": 1, "primary": 2})
        >>> sorted(run.mutations.index)
        ['lens', 'primary_large', 'primary_small']
        """
        rows = {
            name: {key: value for key, value in row.items() if not isinstance(value, (dict, list))}
            for name, row in self.record.get("mutations", {}).items()
        }
        return pd.DataFrame(rows).T.convert_dtypes()

    @property
    def failures(self) -> pd.DataFrame:
        """Why proposals failed: how often, for each reason (row) and mutation (column)."""
        rows: Mapping[str, Any] = {name: row["failures"] for name, row in self.record.get("mutations", {}).items()}
        return pd.DataFrame(rows).fillna(0).astype(int)

    @property
    def diagnostics(self) -> pd.DataFrame:
        """Of functionals of the chains: r_hat, ess_bulk, ess_tail, and the autocorrelation in mutations."""
        chains = self.record.get("chains", {})
        if "r_hat" not in chains:
            return pd.DataFrame()
        table = {
            "r_hat": chains["r_hat"],
            "ess_bulk": {name: each["bulk"] for name, each in chains["ess"].items()},
            "ess_tail": {name: each["tail"] for name, each in chains["ess"].items()},
            "autocorrelation": chains["integrated_autocorrelation"],
        }
        return pd.DataFrame(table).astype(float)

    # ---- to look at, and to keep

    @property
    def summary(self) -> str:
        """What `wander render` prints at the end."""
        return str(self._record.summary)

    def svg(self, width: float | None = None) -> str:
        """The figure of `wander plot`, as an SVG document.

        Parameters
        ----------
        width : float, optional
            Of the page, in points.
        """
        return str(self._record.figure(width))

    def save(self, directory: str | Path, *, overwrite: bool = False, exposure: float = 0.0) -> None:
        """Writes the files of `wander render -o DIR`.

        Parameters
        ----------
        directory : str or Path
            New, or empty.
        overwrite : bool
            May it hold a run already?
        exposure : float
            Of the picture of an image, in stops.

        Raises
        ------
        UsageError, OutputError

        Examples
        --------
        >>> import pathlib, tempfile
        >>> import wanderlight as wl
        >>> directory = pathlib.Path(tempfile.mkdtemp(), "run")
        >>> wl.render("gallery:furnace", "bdpt", "10k").save(directory)
        >>> wl.open_run(directory).samples
        10000
        """
        self._record.write(str(directory), overwrite, exposure)

    def _array(self, numbers: Any, name: str) -> xr.DataArray:
        about = self.axes
        if numbers.ndim == 1:
            position = xr.Variable(("position",), np.asarray(about["centers"]), _attributes(about["position"]))
            coordinates: dict[str, Any] = {"position": position}
        else:
            coordinates = {"y": np.arange(numbers.shape[0]), "x": np.arange(numbers.shape[1])}
            if numbers.ndim == 3:
                coordinates["channel"] = _COLOURS
        attributes = {} if numbers.dtype == bool else _attributes(about["value"])
        return xr.DataArray(numbers, coords=coordinates, dims=list(coordinates), name=name, attrs=attributes)

    def __repr__(self) -> str:
        return self.summary.rstrip()

    def _repr_html_(self) -> str:
        from .view import result_html

        return result_html(self)


def _attributes(quantity: Mapping[str, str]) -> dict[str, str]:
    return {"long_name": quantity["name"], "units": quantity["unit"]}
