#!/usr/bin/env python3
"""An oracle from outside: Mitsuba 3 renders scenes of the gallery and one of smooth meshes and metals; the films agree.

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
SCENES = ("smooth", "cornell", "cornell-glass", "lamp", "mirrors", "furnace-sphere")
LEAST_SHARE = 0.3  # of the bins that must be reliable for their chi-square to say something
ROWS = 128         # of a smooth ball: on the rim of a coarser one Mitsuba lets pass what disagrees about the side

try:
    import mitsuba
    import numpy

    import mitsuba_scene
except ImportError as missing:
    print(f"skipped: {missing}; pip install mitsuba")
    sys.exit(SKIPPED)


def write_ball(path):
    """A unit ball of longitudes and latitudes, with the normals of the sphere."""
    theta = numpy.pi * numpy.arange(ROWS + 1) / ROWS
    phi = numpy.pi * numpy.arange(2 * ROWS) / ROWS
    points = [(numpy.sin(t) * numpy.cos(p), numpy.sin(t) * numpy.sin(p), numpy.cos(t)) for t in theta for p in phi]
    lines = [f"{key} {x:.9f} {y:.9f} {z:.9f}" for key in ("v", "vn") for x, y, z in points]
    for row in range(ROWS):
        for column in range(2 * ROWS):
            a, b = (row * 2 * ROWS + k % (2 * ROWS) + 1 for k in (column, column + 1))
            faces = [(a, a + 2 * ROWS, b + 2 * ROWS), (a, b + 2 * ROWS, b)]
            faces = faces[:1] if row == 0 else faces[1:] if row == ROWS - 1 else faces
            lines += ["f " + " ".join(f"{corner}//{corner}" for corner in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def smooth(folder):
    """A room with smooth balls of plaster, copper and glass, and a copper sphere."""
    write_ball(folder / "ball.obj")

    def sheet(origin, edges, **more):
        return {"type": "parallelogram", "origin": origin, "edges": edges, **more}

    def ball(x, z, radius, material):
        rows = [[radius, 0, 0, x], [0, radius, 0, radius], [0, 0, radius, z]]
        return {"type": "mesh", "file": "ball.obj", "normals": "smooth", "transform": rows, "material": material}

    document = {
        "format": "wanderlight-scene/1", "dimension": 3, "max_vertices": 6,
        "materials": {
            "white": {"type": "diffuse", "reflectance": 0.6}, "red": {"type": "diffuse", "reflectance": [0.6, 0.2, 0.1]},
            "glass": {"type": "dielectric", "ior": 1.5},
            "copper": {"type": "conductor", "eta": [0.2, 0.92, 1.1], "k": [3.9, 2.45, 2.14]}},
        "shapes": [
            sheet([-1, 0, -1], [[0, 0, 2], [2, 0, 0]], material="white"),
            sheet([-1, 2, -1], [[2, 0, 0], [0, 0, 2]], material="white"),
            sheet([-1, 0, -1], [[2, 0, 0], [0, 2, 0]], material="white"),
            sheet([-1, 0, -1], [[0, 2, 0], [0, 0, 2]], material="red"),
            sheet([1, 0, -1], [[0, 0, 2], [0, 2, 0]], material="white"),
            sheet([-0.6, 1.98, -0.6], [[1.2, 0, 0], [0, 0, 1.2]], light={"radiance": [5, 4, 3]}),
            ball(-0.5, -0.4, 0.4, "red"), ball(0.45, -0.5, 0.4, "copper"), ball(0, 0.45, 0.3, "glass"),
            {"type": "sphere", "center": [0.1, 1.4, -0.5], "radius": 0.25, "material": "copper"}],
        "camera": {"type": "perspective", "position": [0, 1, 3.4], "target": [0, 0.9, 0], "fov_deg": 42, "resolution": [WIDTH, WIDTH]}}
    path = folder / "smooth.json"
    path.write_text(json.dumps(document))
    return path


def small(name, folder):
    """The scene with fewer pixels, in the folder: those are soon known."""
    if name == "smooth":
        return smooth(folder)
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
