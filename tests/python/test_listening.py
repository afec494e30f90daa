"""While the engine works, Python goes on: other threads, progress, and Ctrl-C."""

from __future__ import annotations

import subprocess
import sys
import threading
import time

import pytest

import wanderlight as wl

# Sends itself Ctrl-C once sampling has begun.
SCRIPT = """
import os, signal, sys
import wanderlight as wl

signal.signal(signal.SIGINT, signal.default_int_handler)  # which a shell in the background ignores

def stop(fraction, samples, seconds, phase):
    if phase == "sampling" and not stop.done:
        stop.done = True
        os.kill(os.getpid(), signal.SIGINT)
stop.done = False
try:
    wl.{call}
except wl.Interrupted as stopped:
    run = stopped.run
    print("interrupted", type(run).__name__, run is not None and {what})
    sys.exit(7)
"""


@pytest.mark.parametrize(
    "call, what, said",
    [
        ('render("gallery:slit", "mlt", "1000G", progress=stop)', "0 < run.samples < 10**12", "Run True"),
        ('render("gallery:slit", "bdpt", "3h", progress=stop)', "run.film.mean().item() > 0", "Run True"),
        (
            'trace("gallery:slit", steps=10_000_000, chains=1, progress=stop)',
            'run["posterior"].sizes["draw"] > 0',
            "True",
        ),
    ],
)
def test_ctrl_c_keeps_what_was_computed(call, what, said):
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT.format(call=call, what=what)], capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 7, done.stderr
    assert done.stdout.startswith("interrupted") and done.stdout.rstrip().endswith(said)


def test_the_lock_is_released():
    done = threading.Event()

    def work():
        wl.render("gallery:slit", "bdpt", "0.5s", threads=1)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    beats = 0
    while not done.is_set():
        time.sleep(0.005)
        beats += 1
    thread.join()
    assert beats > 5  # one, if the lock were held


def test_a_run_goes_on_in_one_thread_at_a_time():
    run = wl.begin("gallery:slit", "bdpt", "1s")
    refused = []

    def also(*what):
        try:
            run.advance()
        except wl.UsageError as error:
            refused.append(str(error))

    run.advance(progress=also)
    assert refused and "going on already" in refused[0]
    assert run.complete


def test_progress_is_told_in_order():
    told = []
    wl.render("gallery:slit", "mlt", "3M", progress=lambda *what: told.append(what), seed_share=0.5)
    fractions = [fraction for fraction, _, _, phase in told if phase == "sampling"]
    assert {phase for _, _, _, phase in told} <= {"seed pass", "sampling"}
    assert fractions and fractions == sorted(fractions) and 0 <= fractions[0] and fractions[-1] <= 1


def test_what_progress_raises_is_raised():
    def fail(*what):
        raise ZeroDivisionError("in the bar")

    with pytest.raises(ZeroDivisionError):
        wl.render("gallery:slit", "mlt", "20M", progress=fail)


def test_runs_beside_each_other():
    films = {}

    def work(seed):
        films[seed] = wl.render("gallery:slit", "mlt", "50k", seed=seed, threads=1).film.to_numpy()

    threads = [threading.Thread(target=work, args=(seed,)) for seed in (1, 2, 3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for seed, film in films.items():
        assert (film == wl.render("gallery:slit", "mlt", "50k", seed=seed).film.to_numpy()).all()
