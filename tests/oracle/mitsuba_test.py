#!/usr/bin/env python3
"""An oracle from outside: Mitsuba 3 renders scenes of the gallery, and the films agree.

Skipped, with exit code 77, where Mitsuba is not installed (`pip install mitsuba`).  Per scene and method, both films
being estimates with errors: the mean of the film within 0.5 % or 4 standard errors, whichever is more, and the mean
square of the difference of a bin in its standard error near 1, over the bins that the program calls reliable.
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = os.environ.get("WANDER_PROGRAM", str(ROOT / "build/release/bin/wander"))
SKIPPED = 77
RUNS = 24  # of Mitsuba, for the error of its mean
SPP = 64   # of each
BUDGET = {"bdpt": "2M", "mlt": "8M"}

try:
    import mitsuba
    import numpy

    import mitsuba_scene
except ImportError as missing:
    print(f"skipped: {missing}; pip install mitsuba")
    sys.exit(SKIPPED)


def reference(path):
    """Mean film of independent runs and its standard error, height x width x 3."""
    with tempfile.TemporaryDirectory() as folder:
        scene = mitsuba_scene.load(path, Path(folder), mitsuba)
        films = numpy.array([mitsuba.render(scene, spp=SPP, seed=run) for run in range(1, RUNS + 1)], float)
    return films.mean(0), films.std(0, ddof=1) / RUNS ** 0.5


def channels(film, names):
    bitmap = mitsuba.Bitmap(str(film))
    order = [field.name for field in bitmap.struct_()]
    pixels = numpy.array(bitmap, float)
    return numpy.stack([pixels[:, :, order.index(name)] for name in names], axis=2)


def ours(name, method, folder):
    """Film, standard error and what of it is reliable, height x width x channels."""
    subprocess.run([PROGRAM, "render", f"gallery:{name}", "-m", method, "-b", BUDGET[method], "-o", folder, "-q"],
                   check=True)
    shape = json.loads((Path(folder) / "run.json").read_text())["film"]["shape"]
    colours = ["R", "G", "B"] if len(shape) == 3 else ["Y"]
    film = Path(folder) / "film.exr"
    parts = [channels(film, [part + colour for colour in colours]) for part in ("", "standard_error.", "reliable.")]
    return parts[0], parts[1], parts[2] > 0.5


class Agreement(unittest.TestCase):
    def test_films(self):
        mitsuba.set_variant("scalar_rgb")
        for name in ("cornell", "cornell-glass", "lamp", "mirrors", "furnace-sphere"):
            mean, error = reference(ROOT / "scenes" / f"{name}.json")
            for method in BUDGET:
                with self.subTest(scene=name, method=method), tempfile.TemporaryDirectory() as folder:
                    self.agree(f"{name} {method}", (mean, error), ours(name, method, folder))

    def agree(self, what, theirs, own):
        (mean, error), (film, film_error, reliable) = theirs, own
        variance = error ** 2 + film_error ** 2
        known = reliable & (variance > 0)
        squares = ((film - mean) ** 2 / numpy.where(known, variance, 1))[known]
        offset = film.mean() - mean.mean()
        bound = 4 * numpy.sqrt(variance.sum()) / variance.size
        print(f"{what}: mean off by {100 * offset / mean.mean():+.2f} % (bound {100 * bound / mean.mean():.2f} %), "
              f"chi-square per bin {squares.mean():.3f} over {100 * known.mean():.0f} % of the bins", flush=True)
        self.assertLess(abs(offset), max(0.005 * mean.mean(), bound))
        self.assertGreater(known.mean(), 0.5)
        self.assertLess(squares.mean(), 1.3)
        self.assertGreater(squares.mean(), 0.7)


if __name__ == "__main__":
    unittest.main()
