"""The experiment of figure 4: which runs it takes, and the films that come of them.

A number of samples above the chunk is made in chunks, seeds 1, 2, …, in OUT/SCENE/METHOD/SEED, and
their films are merged; any other is one run, in OUT/SCENE/METHOD/10M, whose seed is its number of
samples: a seed of its own.
"""
from dataclasses import dataclass
from pathlib import Path

from study.film import Film, InvalidInput, best_reference, film_of, merged, read_reference, relative_mse
from study.page import power_of_ten
from study.runs import Run, short


def runs_of(out, scene, method, samples, chunk):
    folder = out / scene / method
    if samples <= chunk:
        return [Run(scene, method, samples, samples, folder / short(samples))]
    return [Run(scene, method, chunk, seed, folder / str(seed)) for seed in range(1, samples // chunk + 1)]


def all_runs(options):
    """Cheap ones first; chunks by turns, so that what there is after a while is even."""
    cells = [runs_of(options.out, scene, method, samples, options.chunk)
             for samples in sorted(options.samples) for scene in options.scenes for method in options.methods]
    single = [cell[0] for cell in cells if len(cell) == 1]
    chunked = [run for cell in cells if len(cell) > 1 for run in cell]
    return single + sorted(chunked, key=lambda run: run.seed)


@dataclass(frozen=True)
class Reference:
    """What errors are measured against: a film, the independent films of which it is made, its name."""
    name: str
    parts: list
    film: Film


@dataclass
class Row:
    """A scene: the films that there are, by (method, samples asked for), each in independent parts."""
    scene: str
    directory: Path  # of one of its runs
    parts: dict
    given: Reference = None  # from outside

    def __post_init__(self):
        self.films = {key: merged(parts) for key, parts in self.parts.items()}

    def reference(self, without=()):
        """The given film, or the best of those that are not to be measured against it.  None: there is none."""
        if self.given:
            return self.given
        films = {key: film for key, film in self.films.items() if key not in without}
        best = best_reference(films.values())
        key = next((key for key, film in films.items() if film is best), None)
        return Reference(f"{key[0]}, {power_of_ten(best.samples)}", self.parts[key], best) if key else None

    def relative_mse(self, contender):
        """And the relative error of the reference.  None if there is nothing to compare."""
        film, reference = self.films.get(contender), self.reference([contender])
        return (relative_mse(film, reference.film), reference.film.claimed_error()) if film and reference else None

    def sensor_length(self):
        """In metres: the bins are equal, and film.csv has their centers."""
        centers = [float(line.split(",")[1]) for line in (self.directory / "film.csv").read_text().split("\n")[1:-1]]
        return centers[0] + centers[-1]


def parts_of(runs, hashes):
    """Films of those runs that there are; notes where each hash of a scene was seen."""
    parts = []
    for run in runs:
        if record := run.record():
            parts.append(film_of(record))
            hashes.setdefault(record["scene"]["sha256"], run.directory)
    if len(hashes) > 1:
        raise InvalidInput(f"{' and '.join(map(str, hashes.values()))} are of different scenes of one name; "
                           "move one away, or choose another --out")
    return parts


def read_row(options, scene):
    hashes, parts = {}, {}
    for method in options.methods:
        for samples in options.samples:
            if found := parts_of(runs_of(options.out, scene, method, samples, options.chunk), hashes):
                parts[method, samples] = found
    row = Row(scene, next(iter(hashes.values()), None), parts)
    if scene in options.references:
        row.given = given_reference(options.references[scene], row)
    return row


def given_reference(path, row):
    film = read_reference(path)
    if any(len(other.values) != len(film.values) for other in row.films.values()):
        raise InvalidInput(f"{path}: {len(film.values)} bins, where the films of {row.scene} have another number")
    return Reference("given", [film], film)
