#!/usr/bin/env python3
"""An oracle from outside: Mitsuba 3 renders scenes of the gallery, and the films agree.

Skipped, with exit code 77, where Mitsuba is not installed (`pip install mitsuba`).  Per scene and method, both films
being estimates with errors: the mean of the film within 0.5 % or 4 standard errors, whichever is more, and the mean
square of the difference of a bin in its standard error near 1, over the bins that the program calls reliable, where
these are not few.
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
WIDTH = 48  # of the films
RUNS = 24   # of Mitsuba, for the error of its mean
SPP = 256   # of each
BUDGET = {"bdpt": "2M", "mlt": "8M"}
SCENES = ("cornell", "cornell-glass", "lamp", "mirrors", "furnace-sphere")
LEAST_SHARE = 0.3  # of the bins that must be reliable for their chi-square to say something

try:
    import mitsuba
    import numpy

    import mitsuba_scene
except ImportError as missing:
    print(f"skipped: {missing}; pip install mitsuba")
    sys.exit(SKIPPED)


def small(name, folder):
    """The scene with fewer pixels, in the folder: those are soon known."""
    document = mitsuba_scene.read(ROOT / "scenes" / f"{name}.json")
    width, height = document["camera"]["resolution"]
    document["camera"]["resolution"] = [WIDTH, WIDTH * height // width]
    path = folder / f"{name}.json"
    path.write_text(json.dumps(document))
    return path


def theirs(path):
    """Mean film of independent runs and its standard error, height x width x 3."""
    scene = mitsuba_scene.load(path, path.parent, mitsuba)
    films = numpy.array([mitsuba.render(scene, spp=SPP, seed=run) for run in range(1, RUNS + 1)], float)
    return films.mean(0), films.std(0, ddof=1) / RUNS ** 0.5


def channels(film, names):
    bitmap = mitsuba.Bitmap(str(film))
    order = [field.name for field in bitmap.struct_()]
    pixels = numpy.array(bitmap, float)
    return numpy.stack([pixels[:, :, order.index(name)] for name in names], axis=2)


def ours(path, method):
    """Film, standard error and what of it is reliable, height x width x channels; relative error of its mean."""
    folder = path.parent / f"{path.stem}-{method}"
    subprocess.run([PROGRAM, "render", path, "-m", method, "-b", BUDGET[method], "-o", folder, "-q"], check=True)
    run = json.loads((folder / "run.json").read_text())
    colours = ["R", "G", "B"] if len(run["film"]["shape"]) == 3 else ["Y"]
    parts = [channels(folder / "film.exr", [part + colour for colour in colours]) for part in ("", "standard_error.", "reliable.")]
    if "normalization" in run:
        known = run["normalization"]["standard_error"] / run["normalization"]["value"]
    else:
        known = relative_error_of_mean(parts[0], parts[1])
    return parts[0], parts[1], parts[2] > 0.5, known


def relative_error_of_mean(film, error):
    """Of pixels that are estimated apart; channels have the same samples."""
    return float(((error ** 2).sum((0, 1)) ** 0.5 / film.sum((0, 1))).max())


class Agreement(unittest.TestCase):
    def test_films(self):
        mitsuba.set_variant("scalar_rgb")
        for name in SCENES:
            with tempfile.TemporaryDirectory() as folder:
                path = small(name, Path(folder))
                reference = theirs(path)
                for method in BUDGET:
                    with self.subTest(scene=name, method=method):
                        self.agree(f"{name} {method}", reference, ours(path, method))

    def agree(self, what, reference, own):
        (mean, error), (film, film_error, reliable, own_error) = reference, own
        variance = error ** 2 + film_error ** 2
        known = reliable & (variance > 0)
        square = ((film - mean) ** 2 / numpy.where(known, variance, 1))[known].mean()
        offset = film.mean() / mean.mean() - 1
        bound = max(0.005, 4 * numpy.hypot(relative_error_of_mean(mean, error), own_error))
        print(f"{what}: mean off by {100 * offset:+.2f} % (bound {100 * bound:.2f} %), chi-square per bin {square:.3f} "
              f"over {100 * known.mean():.0f} % of the bins", flush=True)
        self.assertLess(abs(offset), bound)
        if known.mean() > LEAST_SHARE:
            self.assertLess(abs(square - 1), 0.3)


if __name__ == "__main__":
    unittest.main()
