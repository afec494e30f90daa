"""Scenes that are built in Python meet the validation of scene files, and its messages."""

from __future__ import annotations

import gc
import json
import pickle

import numpy as np
import pytest

import wanderlight as wl

PLASTER = wl.Diffuse(0.5)


def room(*more: wl.Shape, **kinds) -> wl.Scene:
    return wl.Scene(
        [
            wl.Polyline([(0, 0), (2, 0), (2, 2), (0, 2)], closed=True, material=PLASTER),
            wl.Segment((1.1, 1.9), (0.9, 1.9), light=1),
            wl.Segment((0.5, 0.1), (1.5, 0.1), sensor=20),
            *more,
        ],
        **kinds,
    )


FAULTY = [
    {"format": "wanderlight-scene/1", "dimension": 2, "shapes": []},
    {"format": "wanderlight-scene/1", "dimension": 2, "shapes": [{"type": "segment", "from": [0, 0]}], "nmae": "x"},
    {
        "format": "wanderlight-scene/1",
        "dimension": 2,
        "materials": {"m": {"type": "diffuse", "reflectance": 1.5}},
        "shapes": [
            {"type": "segment", "from": [0, 0], "to": [1, 0], "light": {"radiance": -1}},
            {"type": "circle", "center": [0, 3], "radius": 1, "material": "n", "sensor": {"bins": 10}},
        ],
    },
]


@pytest.mark.parametrize("faulty", FAULTY)
def test_faults_are_those_of_scene_files(wander, tmp_path, faulty):
    with pytest.raises(wl.SceneError) as caught:
        wl.load(faulty)
    file = tmp_path / "scene.json"
    file.write_text(json.dumps(faulty, indent=1))
    theirs = wander("inspect", file, expected=3).stderr
    ours = str(caught.value).replace("<scene>", str(file))
    assert ours.splitlines() == [line.removeprefix("error: ") for line in theirs.splitlines() if str(file) in line]
    assert len(caught.value.faults) == len(ours.splitlines())


def test_a_file_that_is_not_there():
    with pytest.raises(wl.SceneError, match="slit"):
        wl.load("slit.json")


def test_built_scenes_say_what_they_were_told():
    scene = room(wl.Circle((1, 1), 0.2, material=wl.Dielectric(1.5)), name="a room", max_vertices=5)
    said = json.loads(scene.text)
    assert (scene.name, scene.dimension, scene.max_vertices) == ("a room", 2, 5)
    assert [shape["type"] for shape in said["shapes"]] == ["polyline", "segment", "segment", "circle"]
    assert said["materials"][said["shapes"][3]["material"]] == {"type": "dielectric", "ior": 1.5}
    assert said["shapes"][0]["material"] == "diffuse-1"
    assert "material" not in said["shapes"][1]


def test_equal_materials_are_one():
    scene = room(wl.Segment((0.2, 1), (0.4, 1), material=wl.Diffuse(0.5)))
    assert list(json.loads(scene.text)["materials"]) == ["diffuse-1"]


def test_every_part_of_the_plane_renders():
    scene = room(
        wl.Circle((0.4, 1.5), 0.1, material=wl.Mirror(0.9)),
        wl.Arc((1.5, 1), 0.3, 90, 270, flip=True, material=wl.RoughConductor(0.2, reflectance=0.8)),
        wl.Circle((0.4, 1), 0.1, material=wl.RoughDielectric(0.1, ior=1.5)),
        wl.Segment((1.7, 0.5), (1.9, 0.7), material=wl.Conductor(1.2, 5.0)),
    )
    assert float(wl.render(scene, "bdpt", "20k").film.mean()) > 0
    assert set(scene.curves().kind) == {"segment", "arc"}


def test_every_part_of_space_renders():
    cube = wl.Mesh(
        points=np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]) * 0.5,
        faces=[(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)],
        transform=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]],
        material=wl.Diffuse((0.8, 0.2, 0.2)),
    )
    scene = wl.Scene(
        [
            cube,
            wl.Sphere((1, 0.3, 0), 0.3, material=wl.Dielectric(1.5)),
            wl.Triangle([(-1, 0, -1), (1, 0, 1), (1, 0, -1)], material=PLASTER),
            wl.Parallelogram((-0.5, 2, -0.5), [(1, 0, 0), (0, 0, 1)], light=(5, 5, 4)),
        ],
        camera=wl.Camera((0, 1, 4), (0, 0.3, 0), 40, (16, 12), up=(0, 1, 0), aperture_radius=0.01, focus_distance=4),
    )
    run = wl.render(scene, "bdpt", "20k")
    assert run.film.shape == (12, 16, 3) and float(run.film.mean()) > 0


def tent(name="tent"):
    """Of a mesh that is made of arrays."""
    cloth = wl.Mesh(
        points=[(-1, -1, 0), (1, -1, 0), (0, 1, 0), (0, 0, 0.5)],
        faces=[(0, 1, 3), (1, 2, 3), (2, 0, 3)],
        material=wl.Diffuse(0.5),
    )
    lamp = wl.Parallelogram((-1, -1, 4), [(0, 2, 0), (2, 0, 0)], light=(5, 3, 1))
    return wl.Scene([cloth, lamp], camera=wl.Camera((0, 0, 3), (0, 0, 0), 60, (5, 4)), name=name)


def films(tmp_path, *seeds):
    """Of runs that are saved, and whose scene is gone, as in another process."""
    values = [wl.render(tent(), "bdpt", "4k", seed=seed) for seed in seeds]
    for seed, run in zip(seeds, values):
        run.save(tmp_path / str(seed))
    values = [run.film.to_numpy().copy() for run in values]
    gc.collect()
    return values


def test_meshes_of_arrays_are_saved_with_their_scene(tmp_path):
    scene = tent()
    scene.save(tmp_path / "tent.json")
    again = wl.load(tmp_path / "tent.json")
    assert again.files == scene.files and list(scene.files)
    assert np.array_equal(wl.render(again, "bdpt", "4k").film, wl.render(scene, "bdpt", "4k").film)


def test_meshes_of_arrays_are_pickled_with_their_scene():
    scene = tent()
    files, text = scene.files, pickle.dumps(scene)
    before = wl.render(scene, "bdpt", "4k").film.to_numpy().copy()
    del scene
    gc.collect()
    again = pickle.loads(text)
    assert again.files == files and np.array_equal(wl.render(again, "bdpt", "4k").film, before)
    assert pickle.loads(pickle.dumps(again)).files == files


def test_runs_of_meshes_of_arrays_go_on_without_their_scene(tmp_path, wander):
    one, two = films(tmp_path, 1, 2)
    run = wl.open_run(tmp_path / "1")
    assert np.array_equal(run.film, one)
    assert run.advance("6k").samples == 6000
    run.save(tmp_path / "more")
    assert wl.open_run(tmp_path / "more").advance("8k").samples == 8000
    both = wl.merge([tmp_path / "1", tmp_path / "2"])
    assert np.allclose(both.film, (one + two) / 2)
    wander("merge", tmp_path / "1", tmp_path / "2", "-q", "-o", tmp_path / "both")
    wander("render", "--continue", "-q", "-o", tmp_path / "2", "-b", "8k")
    wander("render", "--continue", "-q", "-o", tmp_path / "2", "-b", "10k")


def test_runs_whose_files_have_moved_are_looked_at_and_go_on_where_they_are_named(tmp_path):
    tent().save(make(tmp_path / "here") / "tent.json")
    for seed in (1, 2):
        wl.render(tmp_path / "here" / "tent.json", "bdpt", "4k", seed=seed).save(tmp_path / str(seed))
    (tmp_path / "here").rename(tmp_path / "there")
    scene, runs = tmp_path / "there" / "tent.json", [tmp_path / "1", tmp_path / "2"]
    with pytest.warns(UserWarning, match="can be looked at, but not go on"):
        assert wl.open_run(runs[0]).film.shape == (4, 5, 3)
    assert wl.open_run(runs[0], scene=scene).advance("6k").samples == 6000
    with pytest.raises(wl.SceneError):
        wl.merge(runs)
    assert wl.merge((run for run in runs), scene=scene).samples == 8000
    tent("another").save(scene)
    with pytest.raises(wl.UsageError, match="is not that of the run"):
        wl.open_run(runs[0], scene=scene)


def make(folder):
    folder.mkdir()
    return folder


def test_scenes_are_pickled_with_their_meshes():
    scene = wl.load("gallery:bidir-room")
    again = pickle.loads(pickle.dumps(scene))
    assert (again.sha256, again.files, again.source) == (scene.sha256, scene.files, scene.source)
    assert [len(digest) for digest in scene.files.values()] == [64] * len(scene.files) and scene.files


def test_dictionaries_and_gallery():
    said = json.loads(room().text)
    assert wl.load(said).sha256 == wl.load(dict(said)).sha256
    assert {wl.load(f"gallery:{name}").dimension for name in wl.gallery()} == {2, 3}
