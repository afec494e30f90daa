"""How far a run is, by tqdm."""

from __future__ import annotations

import sys
import warnings
from types import TracebackType
from typing import Any, Callable, Union

__all__ = ["Bar", "Progress"]

# True: a bar; False: none; None: a bar where somebody watches; or called with (fraction, samples, seconds, phase).
Progress = Union[bool, None, Callable[[float, int, float, str], None]]


def _is_watched() -> bool:
    return sys.stderr.isatty() or "ipykernel" in sys.modules


class Bar:
    """A bar that shows after a second, and is gone when the run is done."""

    def __init__(self, progress: Progress) -> None:
        self._own: Callable[[float, int, float, str], None] | None = progress if callable(progress) else None
        wanted = _is_watched() if progress is None else progress is True
        self._bar: Any = None
        if wanted and self._own is None:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of a notebook without widgets, which has a bar of text
                from tqdm.auto import tqdm
            self._bar = tqdm(
                total=1.0,
                delay=1.0,
                leave=False,
                bar_format="{desc} {percentage:3.0f} %|{bar}| {elapsed}<{remaining}{postfix}",
            )

    @property
    def listener(self) -> Callable[[float, int, float, str], None] | None:
        """What the engine calls."""
        if self._own is not None:
            return self._own
        return self._show if self._bar is not None else None

    def _show(self, fraction: float, samples: int, seconds: float, phase: str) -> None:
        self._bar.set_description_str(phase, refresh=False)
        if seconds > 0 and samples > 0:
            self._bar.set_postfix_str(f"{samples / seconds:.3g} samples/s", refresh=False)
        self._bar.n = min(max(fraction, 0.0), 1.0)
        self._bar.refresh()

    def __enter__(self) -> Bar:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.close()
