"""The ratio of mean square errors: by hand where all is exact, and how often its interval covers the truth.

False alarms: the coverage test fails with probability below 1e-9.  Percentile intervals over eight
films cover in 85 % of cases or more; 60 of 120 or fewer then have a probability of 1e-20.
"""
import random
import unittest

import place  # noqa: F401
from study.figure4_experiment import Reference
from study.film import Film, merged
from study.ratio import FEW, ratios

BINS = 12


def film(values, error=0.0):
    return Film(tuple(values), (error,) * len(values), (True,) * len(values), 1)


def reference(parts):
    return Reference("of the test", parts, merged(parts))


class ExactRatio(unittest.TestCase):
    def test_of_films_by_hand(self):
        contenders, chunks = [film([1.1, 2.0]), film([1.0, 2.3])], [film([1.2, 2.0])]
        of_film, of_spread = ratios(contenders, chunks, reference([film([1, 2])]), resamples=50)
        self.assertAlmostEqual(of_film.value, ((0.01 + 0.09) / 2) / 0.04)
        self.assertGreaterEqual(of_film.high, of_film.value)
        self.assertIsNone(of_spread)

    def test_of_the_spread_by_hand(self):
        chunks = [film([x]) for x in (1, 2, 3, 4, 5)]
        self.assertEqual(len(chunks), FEW)
        _, of_spread = ratios([film([1.0]), film([1.0])], chunks, reference([film([0])]), resamples=50)
        self.assertAlmostEqual(of_spread.value, 1 / (10 / (5 * 4)))

    def test_the_error_of_the_reference_is_subtracted_above_and_below(self):
        of_film, _ = ratios([film([2.0])] * 2, [film([3.0])], reference([film([0.0], 1.0)]), resamples=50)
        self.assertAlmostEqual(of_film.value, (4 - 1) / (9 - 1))


def draw(generator, spread):
    return film([generator.gauss(1, spread) for _ in range(BINS)], spread)


def covers(generator, is_honest):
    """One experiment whose ratio is known: contenders of variance 1, chunks of 4 each, a mean of 8: 2."""
    parts = [draw(generator, 1.0)]
    if not is_honest:  # the twin believes its reference to be exact
        parts = [film(parts[0].values)]
    contenders, chunks = [draw(generator, 1.0) for _ in range(8)], [draw(generator, 2.0) for _ in range(8)]
    _, of_spread = ratios(contenders, chunks, reference(parts), resamples=100)
    return of_spread.low <= 2 <= of_spread.high


class Coverage(unittest.TestCase):
    def count(self, is_honest):
        generator = random.Random(7)
        return sum(covers(generator, is_honest) for _ in range(120))

    def test_the_interval_covers(self):
        self.assertGreater(self.count(True), 60)

    def test_the_twin_that_trusts_its_reference_does_not(self):
        self.assertLess(self.count(False), 60)


if __name__ == "__main__":
    unittest.main()
