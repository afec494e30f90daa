"""The package as it is read: its names, docstrings, examples and types."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
import subprocess
import sys

import pytest

import wanderlight as wl

MODULES = [
    importlib.import_module(f"wanderlight.{found.name}")
    for found in pkgutil.iter_modules(wl.__path__)
    if found.name != "_wander"
]
FINDER = doctest.DocTestFinder(exclude_empty=False)


def public_things():
    """Every public name of every module: (where, what)."""
    for module in [wl, *MODULES]:
        for name in module.__all__:
            thing = getattr(module, name)
            if inspect.isclass(thing) or inspect.isfunction(thing):
                yield f"{module.__name__}.{name}", thing


def lacks(thing) -> str:
    """What a docstring lacks, in words; nothing if it is whole."""
    text = inspect.getdoc(thing) or ""
    if not text:
        return "a docstring"
    if ">>>" not in text:
        return "an example"
    if not inspect.isfunction(thing):
        return ""
    asked = [name for name, p in inspect.signature(thing).parameters.items() if p.kind is not p.VAR_KEYWORD]
    if asked and "Parameters\n" not in text:
        return "its parameters"
    missing = [name for name in asked if name not in text]
    return f"the parameters {missing}" if missing else ""


@pytest.mark.parametrize("where, thing", [p for p in public_things() if p[1].__module__.startswith("wanderlight")])
def test_public_names_are_documented_with_an_example(where, thing):
    if where.startswith(tuple(f"wanderlight.{name}." for name in ("_fields", "words", "view", "progress"))):
        assert inspect.getdoc(thing)  # of use within the package alone
        return
    if where.startswith("wanderlight.cluster.") or where.endswith(".begin"):
        assert ">>>" in inspect.getdoc(thing)  # parameters are those of what calls them
        return
    assert not lacks(thing), f"{where} lacks {lacks(thing)}"


def test_a_name_without_an_example_is_found():
    def undocumented(a):
        """Does something."""

    assert lacks(undocumented) == "an example"


@pytest.mark.parametrize("where, thing", [p for p in public_things() if inspect.isclass(p[1])])
def test_public_methods_have_docstrings(where, thing):
    for name, member in vars(thing).items():
        if not name.startswith("_") and (inspect.isfunction(member) or isinstance(member, property)):
            assert inspect.getdoc(member), f"{where}.{name}"


@pytest.mark.parametrize("module", [wl, *MODULES], ids=lambda module: module.__name__)
def test_examples_run(module):
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    said: list[str] = []
    for example in FINDER.find(module, module.__name__):
        import matplotlib.pyplot as plt

        plt.close("all")
        runner.run(example, out=said.append)
    assert runner.failures == 0, "".join(said)


def test_types_are_strict():
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--config-file", "pyproject.toml"], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout


def test_versions_agree(wander):
    from importlib.metadata import version

    assert wl.__version__ == version("wanderlight")
    assert wander("--version").stdout.split()[-1] == wl.__version__
