"""The engine with mutations of one's own."""

from __future__ import annotations

import fcntl
import hashlib
import importlib.metadata
import importlib.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import NamedTuple, Sequence

from ._wander import version as _version
from .errors import RunError, UsageError

__all__ = ["WORLDS", "BuildError", "build"]

# Scenes of the plane, in double and in single precision, of space, and of space in colour.
WORLDS = ("plane", "plane_float", "space", "colour")

_HERE = Path(__file__).resolve().parent
_NAMED = re.compile(r"struct\s+(\w+)[^;{]*\{(?:(?!struct\b).)*?static\s+constexpr\s+std::string_view\s+name\b", re.S)
_PACKAGES = "tools/install_dependencies of the sources installs all of it on Debian"


class BuildError(RunError):
    """What is wanted for compiling is missing, or does not compile; the message has the compiler's first error.

    Examples
    --------
    >>> import wanderlight as wl
    >>> issubclass(wl.BuildError, wl.RunError)
    True
    """


class _Own(NamedTuple):
    file: Path
    type: str


def build(
    header: str | Path | Sequence[str | Path],
    type: str | None = None,
    *,
    worlds: Sequence[str] = WORLDS,
    jobs: int = 0,
    folder: str | Path | None = None,
) -> ModuleType:
    """Compiles an engine with mutations of one's own; docs/extending.md says how one is written.

    What depends on mutations is compiled, in each of the worlds: about a minute for one on two cores.

    Parameters
    ----------
    header : str, Path or several
        The file of the mutation; or of each mutation, which become one family.
    type : str, optional
        The name of its struct, if the header has several with a ``name``.
    worlds : sequence of str
        Of which scenes it computes, of `WORLDS`: others are refused.
    jobs : int
        Compilers at a time; 0: one for each core.
    folder : str or Path, optional
        Where it is made; usually in the user's cache.

    Returns
    -------
    module
        All that `wanderlight` has, with an engine that knows the mutation: ``own.check(scene, mutations={...})``.
        ``own.program`` is the path of a `wander` that knows it, too.

    Raises
    ------
    BuildError
        Where a compiler, CMake or a library is missing, or a header does not compile.

    Examples
    --------
    >>> import wanderlight as wl
    >>> own = wl.build("sensor_slide.h", worlds=["plane"])                                  # doctest: +SKIP
    >>> own.check("gallery:article-1", mutations={"bidirectional": 1, "sensor_slide": 1})   # doctest: +SKIP
    """
    _require_worlds(worlds)
    headers = [header] if isinstance(header, (str, Path)) else list(header)
    own = [_own(each, type) for each in headers]
    package = _package_of(own, worlds)
    if package in sys.modules:
        return sys.modules[package]
    place = Path(folder) if folder is not None else _cache()
    _require_tools()
    place.mkdir(parents=True, exist_ok=True)
    # One at a time: what does not depend on the mutation is compiled once for all.
    with (place / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        _compile(own, worlds, package, place, jobs or os.cpu_count() or 1)
        home = _packed(package, place)
    return _loaded(package, home)


def _require_worlds(worlds: Sequence[str]) -> None:
    unknown = [world for world in worlds if world not in WORLDS]
    if isinstance(worlds, str) or unknown or not worlds:
        raise UsageError(f"worlds={worlds!r}: it is a list of some of {', '.join(WORLDS)}")


def _own(header: str | Path, type: str | None) -> _Own:
    file = Path(header).resolve()
    if not file.is_file():
        raise UsageError(f"{header}: there is no such file")
    return _Own(file, type or _type_in(file.read_text(encoding="utf-8"), str(header)))


def _package_of(own: Sequence[_Own], worlds: Sequence[str]) -> str:
    told = "".join(each.type + each.file.read_text(encoding="utf-8") for each in own) + ",".join(worlds)
    types = "_".join(each.type.lower() for each in own)
    return f"wanderlight_{types}_{hashlib.sha256(told.encode()).hexdigest()[:10]}"


def _type_in(text: str, shown: str) -> str:
    names = _NAMED.findall(text)
    if len(names) != 1:
        raise UsageError(f"{shown}: it has {len(names)} structs with a `name`; say which by type=")
    return str(names[0])


def _cache() -> Path:
    base = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    # Another installation of the package has sources of its own, and CMake's folder knows but one.
    place = hashlib.sha256(str(_HERE).encode()).hexdigest()[:8]
    return Path(base) / "wanderlight" / f"programs-{_version()}-{sys.implementation.cache_tag}-{place}"


def _require_tools() -> None:
    if importlib.util.find_spec("nanobind") is None:
        raise BuildError("nanobind is missing, which binds the engine: pip install nanobind")
    for tool, packages in (("cmake", "cmake"), (os.environ.get("CXX", "c++"), "g++")):
        if shutil.which(tool) is None:
            raise BuildError(f"{tool} is missing: install {packages}; {_PACKAGES}")
    if not (_HERE / "source" / "CMakeLists.txt").is_file():
        raise BuildError("the sources of the engine are not beside the package: install it by pip")


def _run(words: list[str], log: Path, what: str) -> None:
    with log.open("w") as output:
        done = subprocess.run(words, stdout=output, stderr=subprocess.STDOUT)
    if done.returncode == 0:
        return
    lines = log.read_text(errors="replace").splitlines()
    first = next((k for k, line in enumerate(lines) if re.search(r"\berror\b", line, re.I)), max(0, len(lines) - 5))
    raise BuildError(f"{what} failed, see {log}; {_PACKAGES}:\n" + "\n".join(lines[first : first + 6]))


def _compiled_rooms() -> Path | None:
    """What knows no mutation came compiled with the package; its binding is for one nanobind alone."""
    rooms = _HERE / "rooms"
    version = rooms / "nanobind_version"
    same = version.is_file() and version.read_text().strip() == importlib.metadata.version("nanobind")
    return rooms if same else None


def _compile(own: Sequence[_Own], worlds: Sequence[str], package: str, place: Path, jobs: int) -> None:
    made = place / "build"
    made.mkdir(parents=True, exist_ok=True)
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    settings = {
        "CMAKE_BUILD_TYPE": "Release",
        "CMAKE_UNITY_BUILD": "ON",
        "WANDER_TESTS": "OFF",
        "WANDER_BENCHMARKS": "OFF",
        "WANDER_PYTHON": "ON",
        "WANDER_PYTHON_DOMAIN": package,
        "WANDER_OWN_MUTATIONS": ";".join(f"{each.file};{each.type}" for each in own),
        "WANDER_WORLDS": ";".join(worlds),
        "WANDER_ROOMS": str(_compiled_rooms() or ""),
        "Python_EXECUTABLE": sys.executable,
    }
    options = [f"-D{key}={value}" for key, value in settings.items()]
    source = str(_HERE / "source")
    _run(["cmake", "-S", source, "-B", str(made), *generator, *options], place / "configure.log", "CMake")
    targets = ["--target", "_wander", "--target", "wander", "-j", str(jobs)]
    _run(["cmake", "--build", str(made), *targets], place / "compile.log", f"compiling {own[0].file.name}")


def _packed(package: str, place: Path) -> Path:
    """This package under another name and with the other engine, and its program."""
    home = place / "packages" / package
    home.mkdir(parents=True, exist_ok=True)
    engines = (place / "build" / "python" / "wanderlight").glob("_wander*.so")
    for file in (*_HERE.glob("*.py"), *engines, place / "build" / "bin" / "wander"):
        shutil.copy(file, home)
    return home


def _loaded(package: str, home: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(package, home / "__init__.py", submodule_search_locations=[str(home)])
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[package] = module
    try:
        spec.loader.exec_module(module)
    except BaseException:
        del sys.modules[package]
        raise
    module.program = home / "wander"  # type: ignore[attr-defined]
    return module
