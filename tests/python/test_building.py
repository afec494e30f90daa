"""Programs with a mutation of their own."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import wanderlight as wl
from wanderlight import building

SLIDE = Path(__file__).resolve().parent.parent.parent / "docs" / "examples" / "sensor_slide.h"


def test_a_file_that_is_not_there():
    with pytest.raises(wl.UsageError, match="no such file"):
        wl.build("no_such_mutation.h")


@pytest.mark.parametrize(
    "text, count",
    [("struct A { double x; };", 0), ('struct A { static constexpr std::string_view name = "a"; };\n' * 2, 2)],
)
def test_which_mutation_is_meant(tmp_path, text, count):
    (tmp_path / "own.h").write_text(text)
    with pytest.raises(wl.UsageError, match=f"it has {count} structs"):
        wl.build(tmp_path / "own.h")


def test_a_missing_compiler_is_named(tmp_path, monkeypatch):
    for tool in ("cmake", "ninja"):
        (tmp_path / tool).write_text("#!/bin/sh\nexit 1\n")
        (tmp_path / tool).chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CXX", raising=False)
    with pytest.raises(wl.BuildError, match="c\\+\\+ is missing: install g\\+\\+"):
        wl.build(SLIDE, folder=tmp_path / "made")
    (tmp_path / "cmake").unlink()
    with pytest.raises(wl.BuildError, match="cmake is missing"):
        wl.build(SLIDE, folder=tmp_path / "made")


def test_each_installation_compiles_in_a_folder_of_its_own(monkeypatch):
    first = building._cache()
    monkeypatch.setattr(building, "_HERE", Path("/another/wanderlight"))
    assert building._cache() != first


def test_what_cmake_says_is_told(tmp_path, monkeypatch):
    for tool in ("cmake", "c++"):
        (tmp_path / tool).write_text("#!/bin/sh\necho one\necho 'CMake Error: no glm'\nexit 1\n")
        (tmp_path / tool).chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    with pytest.raises(wl.BuildError, match="no glm") as caught:
        wl.build(SLIDE, folder=tmp_path / "made")
    assert "configure.log" in str(caught.value) and "one" not in str(caught.value).splitlines()


@pytest.mark.parametrize("worlds", [["plain"], "plane", []])
def test_which_worlds_there_are(worlds):
    with pytest.raises(wl.UsageError, match="some of plane, plane_float, space, colour"):
        wl.build(SLIDE, worlds=worlds)


def test_an_own_mutation_is_right_and_its_wrong_twin_is_caught(tmp_path):
    right = SLIDE.read_text()
    forgotten = "density /= window_of(u).size();"
    assert forgotten in right
    wrong = right.replace(forgotten, "density /= window_of(u).size() / window_of(u).size();")
    twin = tmp_path / "twin.h"
    twin.write_text(wrong.replace("SensorSlide", "Twin").replace("sensor_slide", "twin"))
    own = wl.build([SLIDE, twin], worlds=["plane"], folder=tmp_path / "made")
    pairs = {"bidirectional": 1, "sensor_slide": 1}
    assert own.check("gallery:article-1", samples=50_000, mutations=pairs)
    assert not own.check("gallery:article-1", samples=50_000, mutations={"bidirectional": 1, "twin": 1})
    assert "sensor_slide" in own.render("gallery:article-1", "mlt", "50k", mutations=pairs).mutations.index
    # The engine beside it knows nothing of it, and this one nothing of other worlds.
    with pytest.raises(wl.UsageError, match="unknown mutation"):
        wl.render("gallery:article-1", "mlt", "50k", mutations=pairs)
    with pytest.raises(own.UsageError, match="3 dimensions in colour are left out of this program"):
        own.render("gallery:cornell", "pt", "1k")
