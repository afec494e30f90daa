"""The ratio of mean square errors of a contender at a small budget and of a rival at a large one.

With films x_r of the contender (r = 1 … R, seeds of their own), one film z of the rival, a reference I
with standard error e, independent of both, and Σ over bins,

  ratio = (mean_r Σ (x_r - I)² - Σ e²) / (Σ (z - I)² - Σ e²).

The film z is one draw.  Where it is the mean of n independent unbiased chunks z_c, its expected square
error is known better, and without the reference, from their spread:

  E Σ (z - truth)² = Σ_bins Σ_c (z_c - z)² / (n (n - 1)),

and the second ratio has that for a denominator, if n ≥ FEW.  Intervals hold 95 % of bootstrap
resamples: of the R films, of the chunks in the spread, and of the reference's own chunks (or, where
it has none, of its bins as independent normal numbers).  A resampled reference has twice the
variance, which is subtracted.  The rival's film itself is not resampled: the first ratio is about the
film that there is.
"""
import math
import random
from dataclasses import dataclass

from study.film import Film, mean_values, merged, squares

FEW = 5  # chunks, of which a spread says little


@dataclass(frozen=True)
class Estimate:
    value: float
    low: float
    high: float


def distance(film, reference, times):
    """Σ (x - I)² - times Σ e²."""
    return squares(x - i for x, i in zip(film.values, reference.values)) - times * squares(reference.errors)


def spread(chunks):
    """Expected square error of the mean of the chunks."""
    mean, n = mean_values(chunks), len(chunks)
    return math.fsum(squares(x - m for x, m in zip(chunk.values, mean)) for chunk in chunks) / (n * (n - 1))


def some_spread(chunks, generator):
    """Of a resample; repeats shrink it by (n-1)/n on average."""
    chosen = generator.choices(chunks, k=len(chunks))
    return spread(chosen) * len(chunks) / (len(chunks) - 1)


def resampled(reference, generator):
    """Another draw of the reference, with the standard errors of the original."""
    film = reference.film
    if len(reference.parts) > 1:
        values = mean_values(generator.choices(reference.parts, k=len(reference.parts)))
    else:
        values = tuple(generator.gauss(v, e) for v, e in zip(film.values, film.errors))
    return Film(values, film.errors, film.reliable)


def quantiles(values):
    """Of the 95 % interval; a denominator that is not positive makes the ratio infinite."""
    values = sorted(values)
    return values[int(0.025 * len(values))], values[int(0.975 * len(values))]


def quotient(a, b):
    return a / b if b > 0 else math.inf


def ratios(contenders, chunks, reference, resamples=1000):
    """The two ratios as Estimates; the second is None where the rival has fewer than FEW chunks."""
    generator, rival = random.Random(1), merged(chunks)
    top = math.fsum(distance(film, reference.film, 1) for film in contenders) / len(contenders)
    of_film, of_spread = [], []
    for _ in range(resamples):
        other = resampled(reference, generator)
        chosen = generator.choices(contenders, k=len(contenders))
        some_top = math.fsum(distance(film, other, 2) for film in chosen) / len(chosen)
        of_film.append(quotient(some_top, distance(rival, other, 2)))
        if len(chunks) >= FEW:
            of_spread.append(quotient(some_top, some_spread(chunks, generator)))
    first = Estimate(quotient(top, distance(rival, reference.film, 1)), *quantiles(of_film))
    return first, Estimate(quotient(top, spread(chunks)), *quantiles(of_spread)) if of_spread else None
