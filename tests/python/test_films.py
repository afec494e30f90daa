"""Films as arrays: their memory, coordinates, units and intervals."""

from __future__ import annotations

import csv
import gc

import numpy as np
import pytest
import xarray as xr
from scipy.stats import t

import wanderlight as wl


def test_films_are_not_copied_and_cannot_be_written_to():
    run = wl.render("gallery:slit", "bdpt", "10k")
    first, again = run.film.to_numpy(), run.film.to_numpy()
    assert np.shares_memory(first, again)
    with pytest.raises(ValueError):
        first[0] = 1


def test_a_film_outlives_its_run():
    run = wl.render("gallery:slit", "bdpt", "10k")
    film, before = run.film, run.film.to_numpy().copy()
    del run
    gc.collect()
    others = [wl.render("gallery:slit", "bdpt", "10k", seed=seed) for seed in range(2, 6)]
    assert np.array_equal(film.to_numpy(), before)
    assert not any(np.shares_memory(film.to_numpy(), other.film.to_numpy()) for other in others)


def test_a_preview_stays_as_it_was():
    run = wl.begin("gallery:slit", "bdpt", "2M")
    previews = run.previews(every=0.01)
    first = next(previews)
    before = first.film.to_numpy().copy()
    for _ in previews:
        pass
    assert np.array_equal(first.film.to_numpy(), before)
    assert not np.array_equal(run.film.to_numpy(), before)


def test_rows_of_bins_are_those_of_film_csv(tmp_path):
    run = wl.render("gallery:slit", "mlt", "50k")
    run.save(tmp_path / "run")
    rows = list(csv.DictReader((tmp_path / "run" / "film.csv").open()))
    assert run.film.dims == ("position",)
    assert [float(row["center"]) for row in rows] == run.film.coords["position"].to_numpy().tolist()
    assert [float(row["value"]) for row in rows] == run.film.to_numpy().tolist()
    assert [float(row["standard_error"]) for row in rows] == run.standard_error.to_numpy().tolist()
    assert [row["reliable"] == "1" for row in rows] == run.reliable.to_numpy().tolist()
    assert run.film.attrs["units"] == "W/m" and run.film.coords["position"].attrs["units"] == "m"


def test_images_have_rows_columns_and_channels(tmp_path):
    run = wl.render("gallery:cornell", "bdpt", "30k")
    run.save(tmp_path / "run")
    stored = xr.open_dataset(tmp_path / "run" / "film.nc")
    assert run.film.dims == ("y", "x", "channel")
    assert run.film.coords["channel"].to_numpy().tolist() == ["R", "G", "B"]
    assert np.array_equal(stored["value"].to_numpy(), run.film.to_numpy())
    assert run.film.attrs["units"] == "W/(m²·sr)"
    reopened = wl.open_run(tmp_path / "run")
    assert np.array_equal(reopened.standard_error.to_numpy(), run.standard_error.to_numpy(), equal_nan=True)


def test_differences_of_colours_are_those_of_each_channel():
    floor = wl.Parallelogram((-2, -2, 0), [(4, 0, 0), (0, 4, 0)], material=wl.Diffuse(0.5))
    lamp = wl.Parallelogram((-1, -1, 4), [(0, 2, 0), (2, 0, 0)], light=(5, 0, 5))
    scene = wl.Scene([floor, lamp], camera=wl.Camera((0, 0, 3), (0, 0, 0), 60, (12, 10)))
    one, two = (wl.render(scene, "bdpt", "100k", seed=seed) for seed in (1, 2))
    shown = wl.plot.difference(one, two).images[0].get_array()
    assert shown.shape == (10, 36)
    red, green, blue = np.hsplit(np.ma.filled(shown, np.nan), 3)
    assert np.isnan(green).all() and np.isfinite(red).all()
    # 120 values of N(0, 1), for both channels are of one light: their mean square is within 0.5 of 1 but for 4e-4.
    assert abs(np.mean(np.hstack([red, blue]) ** 2) - 1) < 0.5


def test_intervals_are_those_of_student():
    run = wl.render("gallery:furnace", "mlt", "100k")
    low, high = run.interval(0.9)
    half = t.ppf(0.95, run.degrees_of_freedom) * run.standard_error.to_numpy()
    assert np.allclose((high - low).to_numpy(), 2 * half, rtol=1e-12)
    assert np.allclose(((high + low) / 2).to_numpy(), run.film.to_numpy(), rtol=1e-12)


def test_lengths_add_up():
    run = wl.render("gallery:slit", "bdpt", "50k")
    assert run.by_length.dims == ("vertices", "position")
    assert np.allclose(run.by_length.sum("vertices").to_numpy(), run.film.to_numpy(), rtol=1e-9)
    # A length left out must not pass.
    assert not np.allclose(run.by_length[:-2].sum("vertices").to_numpy(), run.film.to_numpy(), rtol=1e-9)


def test_parts_of_a_pooled_film():
    run = wl.render("gallery:frosted", "mlt", "200k")
    assert run.chains_film is not None and run.film_of_samples is not None
    assert float(run.film_of_samples.sum()) <= float(run.film.sum()) * (1 + 1e-9)
    alone = wl.render("gallery:frosted", "mlt", "200k", film="chains")
    assert alone.film_of_samples is None


def test_records_of_chains():
    run = wl.render("gallery:slit", "mlt", "100k")
    assert run.mutations.proposed.sum() == run.samples
    assert (run.mutations.accepted <= run.mutations.proposed).all()
    assert run.normalization.value == pytest.approx(run.normalization.estimates.value["bridge"])
    assert (run.diagnostics.r_hat.dropna() > 0.9).all()
    refused = run.failures.sum() + run.mutations.accepted
    assert (refused == run.mutations.proposed).all()


def test_independent_samples_have_no_chains():
    run = wl.render("gallery:slit", "bdpt", "10k")
    assert run.normalization is None and run.mutations.empty and run.diagnostics.empty


def test_views_are_whole():
    run = wl.render("gallery:slit", "mlt", "50k")
    text = run._repr_html_()
    assert "data:image/svg+xml;base64," in text and "relative error" in text and "lens" in text
    assert repr(run).startswith("mlt: 50 k samples")
