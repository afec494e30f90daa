"""Lines are counted for the dimension that they serve."""
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
from study import shared_lines  # noqa: E402

TEXT = """// A comment.
#pragma once

template <World W>
struct Any {
  int shared;
};
template <>
struct Room<2> {
  int plane;  // one
};
template <World W>
struct Room<W, 3> : Any<W> {

  int space, more;
};
int after;
"""


class SharedLines(unittest.TestCase):
    def test_specialisations_belong_to_their_dimension(self):
        count = shared_lines.Count()
        shared_lines.count_text(TEXT, count)
        self.assertEqual((count.shared, count.plane, count.space), (8, 3, 3))

    def test_most_of_light_transport_and_chains_is_shared(self):
        counts = shared_lines.count(ROOT)
        del counts["shapes"]
        self.assertGreaterEqual(shared_lines.total(counts.values()).share(), 0.85)

    def test_every_named_file_is_there(self):
        for patterns in (*shared_lines.FILES.values(), shared_lines.SHAPES, shared_lines.ORACLE):
            for pattern in patterns:
                self.assertTrue(list(ROOT.glob(pattern)), pattern)


if __name__ == "__main__":
    unittest.main()
