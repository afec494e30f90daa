"""Scenes, films, paths and comparisons on axes of matplotlib.

Each function draws on the axes that it is given, or on the current ones, and returns them. Colours are those of
`wander plot`: light is red, the sensor blue, what was accepted blue and solid, what was rejected orange and dashed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patches import Arc as ArcPatch

from . import _wander
from .scene import SceneLike, load

if TYPE_CHECKING:
    from .comparison import Comparison
    from .result import Result

__all__ = ["difference", "errors", "film", "image", "paths", "scene"]

_STYLE: dict[str, Any] = dict(_wander.style())


def _axes(ax: Axes | None) -> Axes:
    return plt.gca() if ax is None else ax


def _label(quantity: dict[str, str]) -> str:
    return f"{quantity['name']}, {quantity['unit']}" if quantity["unit"] else quantity["name"]


def scene(scene: SceneLike, ax: Axes | None = None) -> Axes:
    """A scene of the plane, lengths in metres.

    Parameters
    ----------
    scene : str, Path, mapping or Scene
        As `wanderlight.render` takes it.
    ax : matplotlib.axes.Axes, optional

    Returns
    -------
    matplotlib.axes.Axes

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.plot.scene("gallery:slit").get_xlabel()
    'x, m'
    """
    ax = _axes(ax)
    read = load(scene)
    if read.dimension != 2:
        raise ValueError(f"{read.name} is a scene in space: Scene.svg() draws it as its camera sees it")
    for _, curve in read.curves().iterrows():
        colour, width, style = _STYLE["wall"], 1.2, "-"
        if curve.radiance > 0:
            colour, width = _STYLE["light"], 2.5
        elif curve.is_sensor:
            colour, width = _STYLE["sensor"], 2.5
        elif curve.material in ("dielectric", "rough_dielectric"):
            colour = _STYLE["glass"]
        elif curve.material in ("mirror", "conductor", "rough_conductor"):
            style = (0, (4, 1))  # type: ignore[assignment]
        if curve.kind == "segment":
            ax.plot([curve.from_x, curve.to_x], [curve.from_y, curve.to_y], color=colour, lw=width, ls=style)
        else:
            span = (curve.to_degrees - curve.from_degrees) % 360 or 360
            size = 2 * curve.radius
            ax.add_patch(
                ArcPatch((curve.center_x, curve.center_y), size, size, theta1=curve.from_degrees,
                         theta2=curve.from_degrees + span, color=colour, lw=width, ls=style)
            )  # fmt: skip
    ax.set_aspect("equal", adjustable="datalim")
    ax.autoscale_view()
    ax.set(xlabel="x, m", ylabel="y, m", title=read.name)
    return ax


def film(
    *results: Result,
    ax: Axes | None = None,
    labels: Sequence[str] | None = None,
    reference: Result | None = None,
    level: float = 0.95,
) -> Axes:
    """Films of the plane over the sensor, each with the band of its intervals; what is not reliable is paler.

    Parameters
    ----------
    *results : Result
        Of scenes with one sensor.
    ax : matplotlib.axes.Axes, optional
    labels : sequence of str, optional
        Their methods, if not said.
    reference : Result, optional
        A thin black line.
    level : float
        Of the intervals.

    Returns
    -------
    matplotlib.axes.Axes

    Examples
    --------
    >>> import wanderlight as wl
    >>> runs = [wl.render("gallery:furnace", method, "20k") for method in ("pt", "bdpt")]
    >>> [text.get_text() for text in wl.plot.film(*runs).get_legend().get_texts()]
    ['pt', 'bdpt']
    """
    ax = _axes(ax)
    for k, result in enumerate(results):
        colour, dashes = _STYLE["films"][k % len(_STYLE["films"])]
        values = result.film
        if values.ndim != 1:
            raise ValueError("this is an image: plot.image draws it")
        position, numbers = values.coords["position"].to_numpy(), values.to_numpy()
        low, high = result.interval(level)
        label = labels[k] if labels is not None else result.method
        ax.step(position, numbers, where="mid", color=colour, lw=1.2, label=label,
                ls="-" if dashes == "none" else (0, tuple(float(x) for x in dashes.split())))  # fmt: skip
        ax.fill_between(position, low.to_numpy(), high.to_numpy(), step="mid", color=colour, alpha=0.25, lw=0)
        doubtful = ~result.reliable.to_numpy()
        ax.plot(position[doubtful], numbers[doubtful], "x", color=colour, ms=3, alpha=0.6)
    if reference is not None:
        line = reference.film
        ax.step(line.coords["position"], line, where="mid", color=_STYLE["ink"], lw=0.8, label="reference")
    if results:
        about = results[0].axes
        ax.set(xlabel=_label(about["position"]), ylabel=_label(about["value"]), title=results[0].name)
        ax.set_ylim(bottom=min(0.0, float(results[0].film.min())))
    ax.legend()
    return ax


def image(result: Result, ax: Axes | None = None, *, exposure: float = 0.0) -> Axes:
    """An image as film.png shows it.

    Parameters
    ----------
    result : Result
        Of a scene in space.
    ax : matplotlib.axes.Axes, optional
    exposure : float
        In stops: +1 is twice as bright. With 0, 99 % of the pixels that have light are not above white.

    Returns
    -------
    matplotlib.axes.Axes

    Examples
    --------
    >>> import wanderlight as wl
    >>> run = wl.render("gallery:furnace-sphere", "pt", "20k")
    >>> wl.plot.image(run).images[0].get_array().shape[:2] == run.film.shape[:2]
    True
    """
    ax = _axes(ax)
    if result.film.ndim == 1:
        raise ValueError("this is a row of bins: plot.film draws it")
    picture = result._record.film.srgb(exposure)
    ax.imshow(picture, cmap="gray" if picture.ndim == 2 else None, vmin=0, vmax=255, interpolation="nearest")
    ax.set(xticks=[], yticks=[], title=f"{result.name}, {result.method}")
    return ax


def difference(result: Result, other: Result, ax: Axes | None = None) -> Axes:
    """How far two films are from each other, in units of the error of both: N(0, 1), without structure, if they agree.

    Of films in colour the channels lie side by side. Where nothing is known of either film it is blank.

    Parameters
    ----------
    result, other : Result
        Of one shape.
    ax : matplotlib.axes.Axes, optional

    Returns
    -------
    matplotlib.axes.Axes

    Examples
    --------
    >>> import wanderlight as wl
    >>> a, b = (wl.render("gallery:furnace", "bdpt", "20k", seed=seed) for seed in (1, 2))
    >>> wl.plot.difference(a, b).get_ylabel()
    'difference, standard errors'
    """
    ax = _axes(ax)
    error = np.hypot(result.standard_error.to_numpy(), other.standard_error.to_numpy())
    with np.errstate(divide="ignore", invalid="ignore"):
        z = (result.film.to_numpy() - other.film.to_numpy()) / error
    if z.ndim == 1:
        ax.axhspan(-1.96, 1.96, color="0.9", lw=0)
        ax.step(result.film.coords["position"], z, where="mid", color=_STYLE["ink"], lw=0.8)
        ax.set(xlabel=_label(result.axes["position"]), ylabel="difference, standard errors")
        return ax
    channels = [z] if z.ndim == 2 else [z[..., k] for k in range(z.shape[2])]
    shown = ax.imshow(np.hstack(channels), cmap="RdBu_r", vmin=-4, vmax=4, interpolation="nearest")
    ax.figure.colorbar(shown, ax=ax, label="difference, standard errors")
    ax.set(xticks=[], yticks=[])
    if len(channels) > 1:
        width = z.shape[1]
        ax.set_xticks([width * (k + 0.5) - 0.5 for k in range(len(channels))], ["red", "green", "blue"])
    return ax


def _lines(group: Any, chosen: Any, chain: int) -> list[Any]:
    points = np.asarray(group["x"].isel(chain=chain).isel(draw=chosen))
    return [path[~np.isnan(path).any(axis=1)] for path in points]


def paths(
    trace: Any, scene: SceneLike | None = None, ax: Axes | None = None, *, chain: int = 0, draws: slice = slice(0, 50)
) -> Axes:
    """Proposals of a chain in the plane: what was accepted solid, what was rejected dashed.

    Parameters
    ----------
    trace : arviz.InferenceData or xarray.DataTree
        What `wanderlight.trace` gives.
    scene : str, Path, mapping or Scene, optional
        Drawn beneath.
    ax : matplotlib.axes.Axes, optional
    chain : int
    draws : slice
        Which of its steps.

    Returns
    -------
    matplotlib.axes.Axes

    Examples
    --------
    >>> import wanderlight as wl
    >>> data = wl.trace("gallery:slit", steps=50, chains=1)
    >>> [lines.get_label() for lines in wl.plot.paths(data, "gallery:slit").collections]
    ['rejected', 'accepted']
    """
    ax = _axes(ax)
    if trace["proposal"]["x"].shape[-1] != 2:
        raise ValueError("these paths are in space: `wander plot FILE.nc --figure paths` draws them as the camera sees them")
    if scene is not None:
        globals()["scene"](scene, ax)
    accepted = np.asarray(trace["sample_stats"]["accepted"].isel(chain=chain).isel(draw=draws)).astype(bool)
    lines = _lines(trace["proposal"], draws, chain)
    for wanted, name in ((False, "rejected"), (True, "accepted")):
        kind = [line for line, was in zip(lines, accepted) if was == wanted and len(line) > 1]
        colour, dashes = _STYLE[name]
        style: Any = "-" if dashes == "none" else (0, tuple(float(x) for x in dashes.split()))
        ax.add_collection(LineCollection(kind, colors=colour, linestyles=style, linewidths=0.7, alpha=0.7, label=name))
    ax.autoscale_view()
    ax.legend()
    return ax


def errors(comparison: Comparison, ax: Axes | None = None) -> Axes:
    """Relative error of each contender against time, with intervals of 95 %.

    Parameters
    ----------
    comparison : Comparison
        What `wanderlight.compare` gives.
    ax : matplotlib.axes.Axes, optional

    Returns
    -------
    matplotlib.axes.Axes

    Examples
    --------
    >>> import wanderlight as wl
    >>> found = wl.compare("gallery:furnace", ["pt", "bdpt"], ["1k", "4k"], replicates=2)
    >>> wl.plot.errors(found).get_yscale()
    'log'
    """
    ax = _axes(ax)
    table = comparison.table.reset_index()
    for k, label in enumerate(comparison.contenders):
        rows = table[table.contender == label].sort_values("seconds")
        colour, _ = _STYLE["films"][k % len(_STYLE["films"])]
        value = rows.relative_rmse.astype(float)
        low, high = (rows[f"relative_rmse_{end}"].astype(float).fillna(value) for end in ("low", "high"))
        bars = np.maximum(np.vstack([value - low, high - value]), 0)
        ax.errorbar(
            rows.seconds.astype(float), value, yerr=bars, color=colour, marker="o", ms=3, capsize=2, label=label
        )
    ax.set(xscale="log", yscale="log", xlabel="time, s", ylabel="relative RMSE")
    ax.legend()
    return ax
