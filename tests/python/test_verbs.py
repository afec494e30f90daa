"""Traces, comparisons, checks and imports are those of the program."""

from __future__ import annotations

import json

import numpy as np
import pytest
import xarray as xr

import wanderlight as wl


def test_a_trace_is_the_file_of_the_program(wander, tmp_path):
    wander("trace", "gallery:slit", "--steps", 200, "--chains", 3, "-s", 4, "-q", "-o", tmp_path / "theirs.nc")
    data = wl.trace("gallery:slit", steps=200, chains=3, seed=4, out=tmp_path / "ours.nc")
    for group in ("posterior", "sample_stats", "proposal", "paths"):
        ours, theirs = (xr.open_dataset(tmp_path / f"{name}.nc", group=group) for name in ("ours", "theirs"))
        assert ours.equals(theirs), group
    assert data["posterior"].sizes["chain"] == 3 and data["posterior"].sizes["draw"] == 200


def test_arviz_takes_a_trace():
    arviz = pytest.importorskip("arviz")
    data = wl.trace("gallery:slit", steps=400, chains=4)
    table = arviz.summary(data, var_names=["sensor_u", "log_f"])
    assert (table.r_hat.astype(float) > 0.9).all()


def test_windows_and_thinning():
    data = wl.trace("gallery:slit", window=(100, 200), every=10, chains=1)
    assert data["posterior"].draw.to_numpy().tolist() == list(range(100, 200, 10))
    with pytest.raises(wl.UsageError, match="at least one step"):
        wl.trace("gallery:slit", window=(5, 5))
    with pytest.raises(wl.UsageError, match="bdpt has none"):
        wl.trace("gallery:slit", "bdpt")


def test_a_replayed_step_is_the_recorded_one(wander):
    data = wl.trace("gallery:slit", steps=50, chains=1)
    stats = data["sample_stats"]
    step = int(np.flatnonzero(stats["accepted"].to_numpy()[0])[-1])
    factors = wl.replay("gallery:slit", 0, step).factors
    assert factors["accepted"]
    assert factors["acceptance_rate"] == pytest.approx(float(stats["acceptance_rate"].to_numpy()[0, step]), rel=1e-12)
    theirs = json.loads(wander("trace", "gallery:slit", "--replay", f"0:{step}", "--json").stdout)
    assert factors == theirs


def test_a_check_is_that_of_the_program(wander):
    theirs = json.loads(wander("check", "gallery:furnace", "--samples", 3000, "--json").stdout)
    ours = wl.check("gallery:furnace", samples=3000)
    assert ours and ours.record == theirs
    assert set(ours.table.index) >= {"mixture", "mlt", "pt"}


WITHOUT_TIMES = ("relative_rmse", "rel_mse", "mae", "bias", "coverage", "claimed_relative_error")


def test_a_comparison_is_that_of_the_program(wander, tmp_path):
    words = ["-m", "pt,bdpt", "-b", "2k,8k", "--replicates", 3, "--sweep", "max_vertices=3,5"]
    wander("compare", "gallery:furnace", *words, "-q", "-o", tmp_path / "theirs")
    theirs = json.loads((tmp_path / "theirs" / "compare.json").read_text())
    ours = wl.compare("gallery:furnace", ["pt", "bdpt"], ["2k", 8000], replicates=3, sweep={"max_vertices": [3, 5]},
                      out=tmp_path / "ours")  # fmt: skip
    assert ours.contenders == [contender["label"] for contender in theirs["contenders"]]
    for mine, other in zip(ours.record["cells"], theirs["cells"], strict=True):
        for name in WITHOUT_TIMES:
            assert mine[name] == other[name], name
    assert ours.report.is_file() and (tmp_path / "ours" / "compare.csv").is_file()
    assert len(ours.runs) == len(theirs["runs"])
    assert ours.table.index.names == ["contender", "budget"]
    assert ours.verdict[0] in ours._repr_html_().replace("&lt;", "<")


def test_a_comparison_of_a_scene_that_is_no_file():
    plaster = wl.Diffuse(0.5)
    scene = wl.Scene([
        wl.Polyline([(0, 0), (2, 0), (2, 2), (0, 2)], closed=True, material=plaster),
        wl.Segment((1.1, 1.9), (0.9, 1.9), light=1),
        wl.Segment((0.5, 0.1), (1.5, 0.1), sensor=20)])  # fmt: skip
    assert wl.compare(scene, ["pt", "bdpt"], ["2k"], replicates=2).contenders == ["pt", "bdpt"]


def test_what_comparisons_refuse():
    with pytest.raises(wl.UsageError, match="no-such"):
        wl.compare("gallery:furnace", ["no-such"], ["2k"])
    with pytest.raises(wl.UsageError) as caught:
        wl.compare("gallery:furnace", ["pt"], ["2k"], sweep={"nothing": [1]})
    assert "nothing" in str(caught.value)


XML = """<scene version="3.0.0">
  <default name="glow" value="3"/>
  <sensor type="perspective"><float name="fov" value="40"/>
    <film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="6"/><rfilter type="box"/></film>
    <transform name="to_world"><lookat origin="0,0,4" target="0,0,0" up="0,1,0"/></transform></sensor>
  <shape type="rectangle"><emitter type="area"><rgb name="radiance" value="$glow"/></emitter></shape>
  {more}
</scene>"""


def test_an_import_is_that_of_the_program(wander, tmp_path):
    file = tmp_path / "box.xml"
    file.write_text(XML.format(more=""))
    wander("import", file, "-o", tmp_path / "theirs.json", "-D", "glow=5", "-q")
    ours = wl.import_mitsuba(file, tmp_path / "ours.json", parameters={"glow": 5})
    theirs = wl.load(tmp_path / "theirs.json")
    assert ours.text.replace("ours", "theirs") == theirs.text


def test_what_cannot_be_imported_exactly(tmp_path):
    file = tmp_path / "box.xml"
    file.write_text(XML.format(more='<shape type="sphere"><point name="center" z="-3"/><bsdf type="plastic"/></shape>'))
    with pytest.raises(wl.SceneError) as caught:
        wl.import_mitsuba(file, tmp_path / "box.json")
    assert caught.value.faults[0][0] == 7  # the line
    assert not (tmp_path / "box.json").exists()
    with pytest.warns(UserWarning, match="plastic"):
        wl.import_mitsuba(file, tmp_path / "box.json", approximate=True)


def test_what_renders_refuse(tmp_path):
    with pytest.raises(wl.UsageError, match='"mtl".*"mlt"'):
        wl.render("gallery:slit", "mtl", 1000)
    with pytest.raises(wl.UsageError, match="large_step"):
        wl.render("gallery:slit", "mlt", 1000, large_stpe=0.1)
    with pytest.raises(wl.UsageError, match="bdpt"):
        wl.render("gallery:slit", "bdpt", 1000, large_step=0.1)
    with pytest.raises(wl.UsageError, match="-5"):
        wl.render("gallery:slit", "bdpt", -5)
    wl.render("gallery:furnace", "bdpt", 1000).save(tmp_path / "run")
    with pytest.raises(wl.UsageError, match="overwrite=True"):
        wl.render("gallery:furnace", "bdpt", 2000).save(tmp_path / "run")
    wl.render("gallery:furnace", "bdpt", 2000).save(tmp_path / "run", overwrite=True)
    assert wl.open_run(tmp_path / "run").samples == 2000


def test_what_is_saved_over_a_run_is_not_carried_on_as_that_run(tmp_path):
    for seed in (1, 2):
        wl.render("gallery:furnace", "bdpt", 1000, seed=seed).save(tmp_path / f"run{seed}")
    assert (tmp_path / "run1" / "checkpoint").exists()
    both = wl.merge([tmp_path / f"run{k}" for k in (1, 2)])
    both.save(tmp_path / "run1", overwrite=True)
    assert not (tmp_path / "run1" / "checkpoint").exists()
    assert wl.open_run(tmp_path / "run1").samples == 2000


def test_a_comparison_that_was_given_up_leaves_its_directory_to_the_next(tmp_path):
    def stop(*_):
        raise ArithmeticError("given up")

    ask = dict(methods=["pt", "bdpt"], replicates=2, out=tmp_path / "made", overwrite=True)
    with pytest.raises(ArithmeticError) as given_up:
        wl.compare("gallery:slit", budgets=["20s"], progress=stop, **ask)
    # Its traceback is held, as an interactive session does, and with it all that the call had.
    assert given_up.traceback and wl.compare("gallery:furnace", budgets=["2k"], **ask).contenders == ["pt", "bdpt"]


def test_what_cannot_be_written_leaves_what_was_there(tmp_path):
    scene = wl.load("gallery:furnace")
    for place in (tmp_path / "none" / "scene.json", tmp_path):
        with pytest.raises(wl.OutputError, match=str(place)):
            scene.save(place)
    with pytest.raises(wl.OutputError, match="none"):
        wl.trace("gallery:slit", steps=10, chains=1, out=tmp_path / "none" / "trace.nc")
    assert not list(tmp_path.iterdir())


def test_numbers_of_numpy_are_numbers(tmp_path):
    found = wl.render("gallery:slit", "pssmlt", 1000, large_step=np.float64(0.25))
    assert "--large-step 0.25" in found.record["command_line"]


@pytest.mark.parametrize(
    "ask, said",
    [
        (lambda: wl.render("gallery:slit", "bdpt", 1000, seed=-1), "-1"),
        (lambda: wl.render("gallery:slit", "bdpt", 1000, seed=1.5), "1.5"),
        (lambda: wl.render("gallery:slit", "bdpt", 1000, threads=-2), "-2"),
        (lambda: wl.check("gallery:furnace", samples=0), "samples"),
        (lambda: wl.trace("gallery:slit", chains=0), "chains"),
        (lambda: wl.trace("gallery:slit", steps=-3), "steps"),
        (lambda: wl.trace("gallery:slit", window=(-1, 10)), "window"),
        (lambda: wl.trace("gallery:slit", window=(0, 10.5)), "window"),
        (lambda: wl.replay("gallery:slit", chain=10**6, step=0), "chain"),
        (lambda: wl.compare("gallery:furnace", budgets=["1k"], replicates=1), "replicates"),
        (lambda: wl.compare("gallery:furnace", budgets=["1k"], target=2.0), "target"),
        (lambda: wl.compare("gallery:furnace", [], ["1k"]), "method"),
        (lambda: wl.merge([]), "at least one"),
    ],
)
def test_numbers_have_the_ranges_of_the_command_line(ask, said):
    with pytest.raises(wl.UsageError, match=said):
        ask()


def test_nothing_computed_yet():
    run = wl.begin("gallery:slit", "mlt", "10k")
    assert "nothing computed" in repr(run)
    with pytest.raises(wl.UsageError, match="advance"):
        run.film
