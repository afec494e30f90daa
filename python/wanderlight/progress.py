"""How far a run is, by tqdm."""

from __future__ import annotations

import sys
import time
from types import TracebackType
from typing import Any, Callable, Union

from tqdm import tqdm

__all__ = ["Bar", "Progress"]

# True: a bar; False: none; None: a bar where somebody watches; or called with (fraction, samples, seconds, phase).
Progress = Union[bool, None, Callable[[float, int, float, str], None]]


_FORMAT = "{desc} {percentage:3.0f} %|{bar}| {elapsed}<{remaining}{postfix}"
_DELAY = 1.0  # seconds, before which there is nothing to see


def _is_notebook() -> bool:
    return "ipykernel" in sys.modules


class _Text:
    """A bar of text in a notebook: one output that changes, and is empty in the end."""

    def __init__(self) -> None:
        self._begun = time.monotonic()
        self._handle: Any = None

    def show(self, fraction: float, phase: str, rate: str) -> None:
        passed = time.monotonic() - self._begun
        if passed < _DELAY:
            return
        text = tqdm.format_meter(
            fraction, 1.0, passed, ncols=80, prefix=phase, bar_format=_FORMAT, postfix=rate, unit_scale=True
        )
        from IPython.display import display

        shown = {"text/plain": text}
        if self._handle is None:
            self._handle = display(shown, raw=True, display_id=True)
        else:
            self._handle.update(shown, raw=True)

    def close(self) -> None:
        if self._handle is not None:
            self._handle.update({"text/plain": ""}, raw=True)


class _Terminal:
    """A bar of tqdm on stderr."""

    def __init__(self) -> None:
        self._bar = tqdm(total=1.0, delay=_DELAY, leave=False, bar_format=_FORMAT)

    def show(self, fraction: float, phase: str, rate: str) -> None:
        self._bar.set_description_str(phase, refresh=False)
        self._bar.set_postfix_str(rate, refresh=False)
        self._bar.n = fraction
        self._bar.refresh()

    def close(self) -> None:
        self._bar.close()


class Bar:
    """A bar that shows after a second, and is gone when the run is done."""

    def __init__(self, progress: Progress) -> None:
        self._own: Callable[[float, int, float, str], None] | None = progress if callable(progress) else None
        wanted = (_is_notebook() or sys.stderr.isatty()) if progress is None else progress is True
        self._bar: _Text | _Terminal | None = None
        if wanted and self._own is None:
            self._bar = _Text() if _is_notebook() else _Terminal()

    @property
    def listener(self) -> Callable[[float, int, float, str], None] | None:
        """What the engine calls."""
        if self._own is not None:
            return self._own
        return self._show if self._bar is not None else None

    def _show(self, fraction: float, samples: int, seconds: float, phase: str) -> None:
        assert self._bar is not None
        rate = f"{samples / seconds:.3g} samples/s" if seconds > 0 and samples > 0 else ""
        self._bar.show(min(max(fraction, 0.0), 1.0), phase, rate)

    def __enter__(self) -> Bar:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.close()
