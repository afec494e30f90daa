"""Runs on a Dask cluster: the bits do not depend on the workers, nor on their deaths."""

from __future__ import annotations

import os
import signal

import numpy as np
import pytest

import wanderlight as wl

distributed = pytest.importorskip("distributed")

RUNS, BUDGET = 4, "400k"


@pytest.fixture(scope="module")
def alone(tmp_path_factory):
    """The same runs, made and merged here."""
    folder = tmp_path_factory.mktemp("runs")
    for seed in range(1, RUNS + 1):
        wl.render("gallery:slit", "mlt", "100k", seed=seed).save(folder / str(seed))
    return wl.merge([folder / str(seed) for seed in range(1, RUNS + 1)])


def cluster_of(workers: int):
    return distributed.LocalCluster(
        n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=50
    )


def same(a, b) -> bool:
    return np.array_equal(a.film, b.film) and np.array_equal(a.standard_error, b.standard_error, equal_nan=True)


@pytest.mark.parametrize("workers", [1, 2, 4])
def test_any_number_of_workers_makes_the_same_bits(alone, workers):
    with cluster_of(workers) as cluster, distributed.Client(cluster) as client:
        spread = wl.render("gallery:slit", "mlt", BUDGET, client=client, runs=RUNS, progress=False)
    assert spread.samples == 400_000 and spread.complete
    assert same(spread, alone)
    assert spread.normalization.value == alone.normalization.value


def test_a_killed_worker_changes_no_bit(alone):
    killed = []

    def kill_one(fraction, samples, seconds, phase):
        if not killed:
            killed.append(pids[0])
            os.kill(pids[0], signal.SIGKILL)

    with cluster_of(2) as cluster, distributed.Client(cluster) as client:
        pids = list(client.run(os.getpid).values())
        spread = wl.render("gallery:slit", "mlt", BUDGET, client=client, runs=RUNS, progress=kill_one)
    assert killed and same(spread, alone)


def test_a_comparison_on_a_cluster():
    here = wl.compare("gallery:furnace", ["pt", "mlt"], ["2k", "8k"], replicates=3)
    with cluster_of(2) as cluster, distributed.Client(cluster) as client:
        there = wl.compare("gallery:furnace", ["pt", "mlt"], ["2k", "8k"], replicates=3, client=client, progress=False)
    for mine, other in zip(here.record["cells"], there.record["cells"], strict=True):
        assert mine["relative_rmse"] == other["relative_rmse"]
        assert mine["samples"] == other["samples"]


def test_what_clusters_refuse():
    from wanderlight.cluster import budgets_of_runs

    with pytest.raises(wl.UsageError, match="error<1%"):
        budgets_of_runs("error<1%", 4)
    with pytest.raises(wl.UsageError, match="at least 8"):
        budgets_of_runs(5, 8)
    assert sum(int(part) for part in budgets_of_runs("1M", 7)) == 1_000_000


@pytest.mark.parametrize("work", ["render", "compare"])
def test_a_worker_with_another_mesh_is_told(tmp_path, wander, work):
    wander("gallery", "ring", "-o", tmp_path / "ring.json")
    scene = wl.load(tmp_path / "ring.json")
    (mesh,) = scene.files
    with (tmp_path / mesh).open("a") as other:
        other.write("# not the same\n")
    with cluster_of(1) as cluster, distributed.Client(cluster) as client:
        with pytest.raises(wl.SceneError, match=f"{mesh}: on the worker"):
            if work == "render":
                wl.render(scene, "bdpt", "2k", client=client, runs=2, progress=False)
            else:
                wl.compare(scene, ["bdpt", "pt"], ["1k"], replicates=2, client=client, progress=False)


def test_meshes_of_arrays_are_sent_along(tmp_path):
    cloth = wl.Mesh(points=[(-1, -1, 0), (1, -1, 0), (0, 1, 0)], faces=[(0, 1, 2)], material=wl.Diffuse(0.5))
    lamp = wl.Parallelogram((-1, -1, 4), [(0, 2, 0), (2, 0, 0)], light=5)
    scene = wl.Scene([cloth, lamp], camera=wl.Camera((0, 0, 3), (0, 0, 0), 60, (5, 4)))
    for seed in (1, 2):
        wl.render(scene, "bdpt", "2k", seed=seed).save(tmp_path / str(seed))
    with cluster_of(1) as cluster, distributed.Client(cluster) as client:
        spread = wl.render(scene, "bdpt", "4k", client=client, runs=2, progress=False)
        found = wl.compare(scene, ["bdpt", "pt"], ["1k"], replicates=2, client=client, progress=False)
    assert same(spread, wl.merge([tmp_path / "1", tmp_path / "2"]))
    assert len(found.record["runs"]) == 4


def test_faults_are_told_before_anything_is_sent():
    class Unreachable:
        def submit(self, *what, **how):
            raise AssertionError("sent")

    with pytest.raises(wl.UsageError):
        wl.render("gallery:slit", "mlt", BUDGET, client=Unreachable(), large_step=2)
    with pytest.raises(wl.UsageError, match="2\\^64"):
        wl.render("gallery:slit", "mlt", BUDGET, client=Unreachable(), seed=2**64 - 2, runs=3)
