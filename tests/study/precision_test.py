"""The tables and the figure of docs/precision.md, of numbers made by hand."""
import unittest
import xml.etree.ElementTree

import place  # noqa: F401
from study import precision


def printed(largest):
    """What wander_precision would print, with one largest difference for float and a billionth of it for double."""
    return "".join(f"{dimension}\t{sweep}\t{setting:g}\t{kind}\t{quantity}\t{most / 2:g}\t{most:g}\t100\n"
                   for dimension in precision.WORLDS for sweep in precision.SWEEPS for setting in (1, 100)
                   for kind, most in (("float", largest), ("double", largest * 1e-9)) for quantity in precision.QUANTITIES)


class Precision(unittest.TestCase):
    def test_reads_medians_and_largest_differences(self):
        worlds = precision.read(printed(2e-7))
        self.assertEqual([list(worlds[2]), list(worlds[3])], [list(precision.SWEEPS)] * 2)
        self.assertEqual(worlds[3]["angle"][100]["float", "weights"], (1e-7, 2e-7))

    def test_writes_one_digit(self):
        self.assertEqual(precision.difference(2.6e-7), "3·10⁻⁷")
        self.assertEqual(precision.difference(9.7e-8), "1·10⁻⁷")
        self.assertEqual(precision.difference(0), "0")
        self.assertEqual(precision.difference(float("nan")), "no number")
        self.assertEqual([precision.power(x) for x in (1, 64, 1e-4, 1e12)], ["1", "64", "10⁻⁴", "10¹²"])

    def test_tables_have_a_row_for_each_setting(self):
        text = precision.tables(precision.read(printed(2e-7)))
        rows = [line for line in text.splitlines() if line.startswith(("| 1 |", "| 10² |"))]
        self.assertEqual(len(rows), 2 * 2 * len(precision.SWEEPS))
        self.assertTrue(all(row.count("2·10⁻⁷") == 4 and row.count("2·10⁻¹⁶") == 4 for row in rows))

    def test_draws_larger_differences_higher(self):
        heights = []
        for largest in (1e-7, 1e-6):
            drawing = precision.draw(precision.read(printed(largest)))
            xml.etree.ElementTree.fromstring(drawing)
            panel = precision.Panel(None, 0, 12 + precision.HEAD, 100, [1, 100])
            heights.append(panel.to_y(largest))
            self.assertIn(f"{round(heights[-1], 2):g}", drawing)
        self.assertLess(heights[1], heights[0])


if __name__ == "__main__":
    unittest.main()
