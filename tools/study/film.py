"""Films of `wander render`, merged, and their errors.

A film has a value x and a standard error s for each bin, in W/m.  Of n independent films of equal
budgets the merged film is, bin by bin,

  x = Σ x_r / n,    s = √(Σ s_r²) / n,

and a merged bin is reliable where at least half of the films call it so.  With a reference I whose
standard error is e, independent of x, and Σ over bins,

  relative MSE = (Σ (x - I)² - Σ e²) / Σ I²,    relative RMSE = √(relative MSE);

what the film claims of itself is √(Σ s² / Σ x²).
"""
import json
import math
import pathlib
from dataclasses import dataclass


class InvalidInput(Exception):
    """A file that is not what it has to be; the text names the place and the remedy."""


@dataclass(frozen=True)
class Film:
    values: tuple
    errors: tuple
    reliable: tuple
    samples: int = 0
    seed_samples: int = 0
    runs: int = 1

    def claimed_error(self):
        """√(Σ s² / Σ x²); infinite for a film that saw nothing."""
        power = squares(self.values)
        return math.sqrt(squares(self.errors) / power) if power > 0 else math.inf

    def is_mostly_reliable(self):
        return 2 * sum(self.reliable) >= len(self.reliable)


def squares(numbers):
    return math.fsum(x * x for x in numbers)


def mean_values(films):
    return tuple(math.fsum(column) / len(films) for column in zip(*(film.values for film in films)))


def merged(films):
    """The merged film of the doc string above."""
    films = list(films)
    n = len(films)
    if len({len(film.values) for film in films}) != 1:
        raise InvalidInput("films of different numbers of bins cannot be merged")
    return Film(
        values=mean_values(films),
        errors=tuple(math.sqrt(squares(column)) / n for column in zip(*(film.errors for film in films))),
        reliable=tuple(2 * sum(column) >= n for column in zip(*(film.reliable for film in films))),
        samples=sum(film.samples for film in films),
        seed_samples=sum(film.seed_samples for film in films),
        runs=sum(film.runs for film in films))


def squared_distance(film, reference):
    """Σ (x - I)² - Σ e²: unbiased for Σ (x - truth)², so negative where the film is too good to tell."""
    return squares(x - i for x, i in zip(film.values, reference.values)) - squares(reference.errors)


def relative_mse(film, reference):
    power = squares(reference.values)
    return squared_distance(film, reference) / power if power > 0 else math.nan


def best_reference(candidates):
    """The film of least claimed error, of those that are mostly reliable if there are any."""
    seen = [film for film in candidates if squares(film.values) > 0]
    sure = [film for film in seen if film.is_mostly_reliable()]
    return min(sure or seen, key=Film.claimed_error, default=None)


def film_of(run):
    """The film of a run.json, or of any JSON object with a `film` of this form."""
    film = run["film"]
    values = tuple(film["value"])
    errors = tuple(film["standard_error"])
    if len(values) != len(errors) or not values or None in values or None in errors:
        raise KeyError("film.value and film.standard_error, of equal length and without null")
    reliable = tuple(bool(flag) for flag in film.get("reliable", [True] * len(values)))
    # The seed pass of a Markov chain method, whatever estimate of b it served.
    estimates = run.get("normalization", {}).get("estimates", {})
    seed_samples = estimates.get("seed_pass", {}).get("samples", 0)
    return Film(values, errors, reliable, run.get("samples", 0), seed_samples)


def read_json(path):
    try:
        return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as fault:
        raise InvalidInput(f"{path}: {fault}") from fault


def read_reference(path):
    """A reference film: a JSON file with a `film`, or a directory that holds such a run.json."""
    path = pathlib.Path(path)
    file = path / "run.json" if path.is_dir() else path
    try:
        return film_of(read_json(file))
    except (KeyError, TypeError, AttributeError) as fault:
        raise InvalidInput(f"{file}: not a film ({fault}); give a run.json, or a JSON file with film.value "
                           "and film.standard_error") from fault
