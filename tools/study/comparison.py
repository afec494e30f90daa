"""What `wander compare` wrote in compare.json (lab/compare/comparison.h says what it means)."""
import math
from dataclasses import dataclass

from study.film import InvalidInput, read_json


@dataclass(frozen=True)
class Measured:
    value: float
    low: float
    high: float


def measured(entry):
    """Numbers that are not known are null in the file, and NaN here."""
    return Measured(*(math.nan if entry[key] is None else entry[key] for key in ("value", "low", "high")))


class Comparison:
    """Contenders by (method, dial, setting); a method as it is usually has neither dial nor setting."""

    def __init__(self, path):
        self.record = read_json(path)
        try:
            self.is_complete = self.record["complete"] is True
            self.budgets = self.record["budgets"]
            self.keys = [(c["method"], c.get("dial") or "", c.get("setting") or "") for c in self.record["contenders"]]
            self.cells = {(self.keys[c["contender"]], c["budget"]): c for c in self.record["cells"]}
            self.crossings = {frozenset((self.keys[c["ahead"]], self.keys[c["behind"]])): c
                              for c in self.record["crossings"]}
        except (KeyError, TypeError, IndexError) as fault:
            raise InvalidInput(f"{path}: not a comparison ({fault!r}); remove it and run the same command again") from fault

    def curve(self, key):
        """[(seconds, relative RMSE)] from the smallest budget on, as far as both are known."""
        cells = [self.cells[key, k] for k in range(len(self.budgets)) if (key, k) in self.cells]
        points = [(measured(cell["seconds"]), measured(cell["relative_rmse"])) for cell in cells]
        return [(t, e) for t, e in points if t.value > 0 and e.value > 0]

    def error(self, key):
        """Relative RMSE at the last budget; None if it is not known."""
        cell = self.cells.get((key, len(self.budgets) - 1))
        error = measured(cell["relative_rmse"]) if cell else None
        return error if error and not math.isnan(error.value) else None

    def lead(self, one, other):
        """1 if one is ahead of the other at the last budget beyond chance, -1 if it is behind, else 0."""
        crossing = self.crossings.get(frozenset((one, other)))
        if not crossing or not crossing["significant"]:
            return 0
        return 1 if self.keys[crossing["ahead"]] == one else -1

    def ahead_from(self, one, other):
        """Seconds from which on one is ahead of the other; None if it is not, beyond chance."""
        return measured(self.crossings[frozenset((one, other))]["seconds"]) if self.lead(one, other) == 1 else None
