"""A run in Python has the bits of the run on the command line, however it is made."""

from __future__ import annotations

import os
import shlex
import signal

import numpy as np
import pytest

import wanderlight as wl

CASES = [
    ("slit", "bdpt", "30k", {}),
    ("slit", "mlt", "50k", {"large_step": 0.2, "mutations": {"lens": 1, "primary": 2}}),
    ("slit", "mlt", "50k", {"film": "chains", "precision": "float"}),
    ("lens", "mmlt", "40k", {"by_length": True, "max_vertices": 6}),
    ("lens", "pssmlt", "error<20%", {"kernel": 2}),
    ("cornell-glass", "mlt", "40k", {}),
    ("cornell-glass", "pt", "20k", {"max_vertices": 4}),
]


def options_of(dials: dict) -> list[str]:
    words = []
    for name, value in dials.items():
        words.append("--" + name.replace("_", "-"))
        if isinstance(value, dict):
            words.append(",".join(f"{key}={weight}" for key, weight in value.items()))
        elif value is not True:
            words.append(str(value))
    return words


def same_films(a, b) -> bool:
    return all(
        np.array_equal(one.to_numpy(), other.to_numpy(), equal_nan=True)
        for one, other in ((a.film, b.film), (a.standard_error, b.standard_error), (a.reliable, b.reliable))
    )


@pytest.mark.parametrize("scene, method, budget, dials", CASES)
def test_python_and_the_program_compute_the_same(wander, tmp_path, scene, method, budget, dials):
    wander.run(tmp_path / "run", f"gallery:{scene}", "-m", method, "-b", budget, "-s", 3, *options_of(dials))
    theirs = wl.open_run(tmp_path / "run")
    ours = wl.render(f"gallery:{scene}", method, budget, seed=3, threads=1, **dials)
    assert same_films(ours, theirs)
    unequal = {"seconds", "cpu_seconds", "seed_seconds", "threads", "command_line", "provenance", "chains", "mutations"}
    for key in ours.record.keys() - unequal:
        assert ours.record[key] == theirs.record[key], key
    again = wander.run(tmp_path / "again", *shlex.split(ours.record["command_line"])[2:])
    assert again["samples"] == ours.samples
    assert same_films(ours, wl.open_run(tmp_path / "again"))


def test_another_seed_is_another_film():
    assert not same_films(wl.render("gallery:slit", "bdpt", "30k"), wl.render("gallery:slit", "bdpt", "30k", seed=2))


@pytest.mark.parametrize(
    "scene, method, samples",
    [("slit", "mlt", 3_000_000), ("slit", "bdpt", 1_000_000), ("lens", "mmlt", 2_000_000), ("cornell", "mlt", 300_000)],
)
def test_rests_change_no_bit(scene, method, samples):
    whole = wl.render(f"gallery:{scene}", method, samples)
    rested = wl.begin(f"gallery:{scene}", method, samples)
    previews = list(rested.previews(every=0.001))
    assert not previews[0].complete and previews[-1].complete
    assert previews[0].samples < previews[-1].samples == samples
    assert same_films(whole, rested)


class Stop(KeyboardInterrupt):
    pass


@pytest.mark.parametrize("phase", ["seed pass", "sampling"])
def test_ctrl_c_changes_no_bit(phase):
    whole = wl.render("gallery:slit", "mlt", "2M", seed_share=0.5)
    run = wl.begin("gallery:slit", "mlt", "2M", seed_share=0.5)
    stops = []

    def stop(fraction, samples, seconds, now):
        if now == phase and not stops:
            stops.append(fraction)
            raise KeyboardInterrupt

    with pytest.raises(wl.Interrupted) as caught:
        run.advance(progress=stop)
    assert caught.value.run is run
    assert not run.complete
    run.advance()
    assert run.complete and same_films(whole, run)


def test_a_run_goes_on_as_the_program_carries_it_on(wander, tmp_path):
    wander.run(tmp_path / "run", "gallery:slit", "-m", "mlt", "-b", "50k")
    wander("render", "--continue", "-o", tmp_path / "run", "-b", "90k", "-q")
    ours = wl.render("gallery:slit", "mlt", "50k").advance("90k")
    assert same_films(ours, wl.open_run(tmp_path / "run"))


def test_a_saved_run_goes_on_in_the_program_and_in_python(wander, tmp_path):
    wl.render("gallery:slit", "mlt", "50k").save(tmp_path / "run")
    here = wl.open_run(tmp_path / "run").advance("70k")
    wander("render", "--continue", "-o", tmp_path / "run", "-b", "70k", "-q")
    assert same_films(here, wl.open_run(tmp_path / "run"))


def interrupting_in(phase: str):
    def stop(fraction, samples, seconds, now):
        if now == phase:
            os.kill(os.getpid(), signal.SIGINT)

    return stop


# Few steps, so beyond them it begins again.  Where the new run has come further before it hears of the interruption, it is
# shown.
@pytest.mark.parametrize("phase", ["seed pass", "sampling"])
def test_what_there_is_stays_until_a_run_that_begins_again_has_as_much(tmp_path, phase):
    signal.signal(signal.SIGINT, signal.default_int_handler)
    few, more = 400_000, 3_000_000
    run = wl.render("gallery:slit", "mlt", few)
    before = wl.render("gallery:slit", "mlt", few)
    with pytest.raises(wl.Interrupted):
        run.advance(more, progress=interrupting_in(phase))
    assert run.samples >= few
    if run.samples == few:
        assert same_films(run, before)
        run.save(tmp_path / "run")
        assert same_films(wl.open_run(tmp_path / "run").advance(few), before)
    counts = [preview.samples for preview in run.previews(every=0)]
    assert counts[0] >= few and counts == sorted(counts) and counts[-1] == more
    assert same_films(run, wl.render("gallery:slit", "mlt", more))


def test_a_budget_that_is_met_is_not_begun_again(tmp_path):
    run = wl.render("gallery:slit", "mlt", "50k")
    before = wl.render("gallery:slit", "mlt", "50k")
    for met in ("20k", "50000", "0.001s"):
        assert same_films(run.advance(met), before)


def test_a_run_is_opened_from_any_folder(tmp_path, wander, monkeypatch):
    here, there = tmp_path / "here", tmp_path / "there"
    here.mkdir()
    there.mkdir()
    wander("gallery", "ring", "-o", here / "ring.json")
    monkeypatch.chdir(here)
    wl.render("ring.json", "bdpt", "2k").save("run")
    monkeypatch.chdir(there)
    opened = wl.open_run(here / "run")
    assert opened.scene.files == wl.load(here / "ring.json").files
    assert same_films(opened.advance("4k"), wl.render(here / "ring.json", "bdpt", "4k"))


def test_scenes_with_meshes_are_saved_merged_and_opened(tmp_path):
    for seed in (1, 2):
        wl.render("gallery:bidir-room", "bdpt", "5k", seed=seed).save(tmp_path / str(seed))
    both = wl.merge([tmp_path / "1", tmp_path / "2"])
    assert both.film.shape == (96, 128, 3)
    both.save(tmp_path / "both")
    assert same_films(both, wl.open_run(tmp_path / "both"))
    assert wl.open_run(tmp_path / "1").advance("8k").samples == 8000
    (tmp_path / "1" / "checkpoint").unlink()
    assert wl.open_run(tmp_path / "1").film.attrs["units"] == "W/(m²·sr)"


def test_a_run_that_was_opened_is_saved_as_it_is(tmp_path):
    wl.render("gallery:slit", "mlt", "50k").save(tmp_path / "one")
    wl.open_run(tmp_path / "one").save(tmp_path / "two")
    assert same_films(
        wl.open_run(tmp_path / "two").advance("70k"), wl.render("gallery:slit", "mlt", "50k").advance("70k")
    )


def test_merged_runs(wander, tmp_path):
    for seed in (1, 2, 3):
        wl.render("gallery:slit", "mlt", "20k", seed=seed).save(tmp_path / str(seed))
    folders = [tmp_path / str(seed) for seed in (3, 1, 2)]
    wander("merge", *folders, "-q", "-o", tmp_path / "all")
    ours = wl.merge(folders)
    assert ours.samples == 60_000
    assert same_films(ours, wl.open_run(tmp_path / "all"))
    with pytest.raises(wl.UsageError, match="same seed 1"):
        wl.merge([tmp_path / "1", tmp_path / "1"])
