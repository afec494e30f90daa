"""What a part of a scene says, as a scene file has it: under the same words, and what is left out is as usual.

Whether it makes sense is said where a `Scene` is made of the parts, with the messages that scene files get.
"""

from __future__ import annotations

import dataclasses
from typing import Any, Sequence, Union

import numpy as np

__all__ = ["Colour", "Point", "fields", "plain"]

Point = Sequence[float]
# One number, or red, green and blue.
Colour = Union[float, Sequence[float]]

# What Python has another word for.
_WORDS = {"start": "from", "end": "to", "start_degrees": "from_deg", "end_degrees": "to_deg", "fov_degrees": "fov_deg"}


def plain(value: Any) -> Any:
    """As JSON has it."""
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return fields(value)
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    return value


def fields(part: Any) -> dict[str, Any]:
    """All that a part says, by its words in a scene file."""
    said: dict[str, Any] = {}
    for field in dataclasses.fields(part):
        value = getattr(part, field.name)
        if value is not None and value is not False:
            said[_WORDS.get(field.name, field.name)] = plain(value)
    return said
