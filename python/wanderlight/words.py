"""What Python asks for, in the words of the command line: one language, and one set of messages."""

from __future__ import annotations

import shlex
from typing import Any, Iterable, Mapping, Union

from . import _wander

__all__ = ["Budget", "Setting", "budget_text", "command_line", "counted", "seeded", "setting_texts"]

_MOST = 1 << 53

# A number of samples, or "2M", "30s", "30cpu-s", "error<1%".
Budget = Union[int, float, str]
Setting = Union[str, float, int, bool, Mapping[str, float], None]


def seeded(seed: int, threads: int) -> tuple[int, int]:
    """Both as the command line takes them."""
    return _wander.seed_of(str(seed)), _wander.threads_of(str(threads))


def counted(what: str, number: int, low: int = 1, high: int = _MOST) -> int:
    """A whole number within its range."""
    return _wander.count_of(what, str(number), low, high)


def budget_text(budget: Budget) -> str:
    """A budget as `wander render -b` takes it."""
    if isinstance(budget, str):
        return budget
    return str(int(budget)) if budget == int(budget) else str(budget)


def _number_text(value: Any) -> str:
    """A number of NumPy has the digits of Python's."""
    return repr(value.item() if hasattr(value, "item") else value)


def setting_text(value: Setting) -> str:
    """The value of a dial as its option takes it."""
    if value is True:
        return "on"
    if isinstance(value, Mapping):
        return ",".join(f"{name}={_number_text(weight)}" for name, weight in value.items())
    return value if isinstance(value, str) else _number_text(value)


def setting_texts(settings: Mapping[str, Setting]) -> dict[str, str]:
    """The dials that are turned; None and False leave one as usual."""
    return {name: setting_text(value) for name, value in settings.items() if value is not None and value is not False}


def command_line(words: Iterable[Any], settings: Mapping[str, str]) -> str:
    """What makes the same on a command line."""
    options: list[str] = []
    for name, text in settings.items():
        options.append("--" + name.replace("_", "-"))
        if text != "on":
            options.append(text)
    return shlex.join(["wander", *(str(word) for word in words), *options])
