"""Merged films, their errors, and the choice of a reference, against computations by hand."""
import math
import unittest

import place  # noqa: F401
from study.film import Film, InvalidInput, best_reference, merged, relative_mse


def film(values, errors, reliable=(True, True), samples=10):
    return Film(tuple(values), tuple(errors), tuple(reliable), samples)


class Merging(unittest.TestCase):
    def test_takes_means_and_adds_variances(self):
        whole = merged([film([1, 2], [0.3, 0]), film([3, 6], [0.4, 0.2]), film([5, 1], [0, 0.1])])
        self.assertEqual(whole.values, (3, 3))
        self.assertAlmostEqual(whole.errors[0], 0.5 / 3, places=15)
        self.assertAlmostEqual(whole.errors[1], math.sqrt(0.05) / 3, places=15)
        self.assertEqual((whole.samples, whole.runs), (30, 3))

    def test_a_bin_is_reliable_where_half_of_the_films_say_so(self):
        one, two = film([1, 1], [1, 1], [True, False]), film([1, 1], [1, 1], [False, False])
        self.assertEqual(merged([one, two]).reliable, (True, False))

    def test_refuses_films_of_different_shapes(self):
        with self.assertRaises(InvalidInput):
            merged([film([1, 2], [0, 0]), film([1], [0], [True])])


class Errors(unittest.TestCase):
    def test_the_error_of_the_reference_is_subtracted(self):
        reference = film([3, 4], [0.1, 0.2])
        self.assertAlmostEqual(relative_mse(film([4, 4], [0, 0]), reference), (1 - 0.05) / 25)
        self.assertLess(relative_mse(film([3, 4], [0, 0]), reference), 0)

    def test_claims_of_a_film(self):
        self.assertAlmostEqual(film([3, 4], [0.3, 0.4]).claimed_error(), 0.1)
        self.assertEqual(film([0, 0], [0, 0]).claimed_error(), math.inf)


class References(unittest.TestCase):
    def test_the_least_claim_of_reliable_films_wins(self):
        bold = film([1, 1], [0.01, 0.01], [False, False])
        sound, rough = film([1, 1], [0.1, 0.1]), film([1, 1], [0.2, 0.2])
        self.assertIs(best_reference([rough, bold, sound]), sound)
        self.assertIs(best_reference([bold, film([1, 1], [0.2, 0.2], [False, False])]), bold)

    def test_a_dark_film_is_none(self):
        self.assertIsNone(best_reference([film([0, 0], [0, 0])]))


if __name__ == "__main__":
    unittest.main()
