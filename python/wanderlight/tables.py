"""What there is to choose from."""

from __future__ import annotations

import pandas as pd

from . import _wander

__all__ = ["dials", "methods"]


def methods() -> pd.DataFrame:
    """The methods: what each is, and which dials it has.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.methods().loc["mlt", "is_markov_chain"]
    True
    """
    return pd.DataFrame(_wander.methods()).set_index("name").astype({"is_markov_chain": object})


def dials() -> pd.DataFrame:
    """The dials of the trade between speed and accuracy: what each takes, and what it does.

    Examples
    --------
    >>> import wanderlight as wl
    >>> wl.dials().loc["large_step", "value"]
    'P'
    """
    return pd.DataFrame(_wander.dials()).set_index("name")
