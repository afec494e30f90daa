"""tools/figure4 on tiny budgets: it resumes, merges, draws, and says what is wrong."""
import json
import math
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

import place
from study.page import percent

METHODS = ["pt", "lt", "bdpt", "mlt", "mlt-chains"]
SCENES = ["article-1", "article-2"]
SMALL, LARGE, CHUNK = 1000, 10000, 5000


class Figure4(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = Path(cls.folder.name)
        cls.out, cls.docs = cls.root / "out", cls.root / "docs"
        cls.first = cls.figure4()
        cls.times = cls.run_times()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def figure4(cls, *more):
        return subprocess.run(
            [sys.executable, "-B", str(place.ROOT / "tools/figure4"), "--samples", f"{SMALL},{LARGE}", "--chunk", "5k",
             "--scenes", ",".join(SCENES), "--out", str(cls.out), "--docs", str(cls.docs), "--program", place.PROGRAM,
             *more], capture_output=True, text=True)

    @classmethod
    def run_times(cls):
        return {str(file): file.stat().st_mtime_ns for file in cls.out.rglob("run.json")}

    def test_makes_every_run_and_again_none(self):
        self.assertEqual(self.first.returncode, 0, self.first.stderr)
        self.assertEqual(len(self.times), len(SCENES) * len(METHODS) * 3)
        again = self.figure4()
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(self.run_times(), self.times)

    def test_makes_again_what_is_missing_or_incomplete(self):
        cut, lost = self.out / "article-1/pt/1/run.json", self.out / "article-1/pt/2/run.json"
        record = json.loads(cut.read_text())
        cut.write_text(json.dumps(dict(record, complete=False)))
        lost.unlink()
        done = self.figure4()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 are missing", done.stderr)
        self.assertEqual(json.loads(cut.read_text())["film"], record["film"])
        self.assertTrue(lost.exists())
        type(self).times = self.run_times()

    def test_merged_error_is_that_of_a_computation_by_hand(self):
        table = [line for line in (self.docs / "figure4.md").read_text().splitlines() if "`lt`" in line]
        chunks = [json.loads((self.out / f"article-1/lt/{seed}/run.json").read_text())["film"] for seed in (1, 2)]
        values = [(a + b) / 2 for a, b in zip(*(chunk["value"] for chunk in chunks))]
        variances = [(a * a + b * b) / 4 for a, b in zip(*(chunk["standard_error"] for chunk in chunks))]
        claimed = math.sqrt(sum(variances) / sum(v * v for v in values))
        self.assertIn(f"| {percent(claimed)} |", next(line for line in table if "article-1" in line))

    def test_figure_is_well_formed_and_has_all_panels(self):
        figure = (self.docs / "figure4.svg").read_text()
        texts = [text.text for text in ET.fromstring(figure).iter("{http://www.w3.org/2000/svg}text")]
        for scene in SCENES:
            self.assertIn(scene, texts)
        self.assertEqual(sum(text.startswith("10⁴: ") for text in texts), len(SCENES) * len(METHODS))
        self.assertLess(len(figure), 600_000)

    def test_table_has_all_methods(self):
        page = (self.docs / "figure4.md").read_text()
        for method in METHODS:
            self.assertEqual(page.count(f"| `{method}` |"), len(SCENES))

    def test_ratio_is_made_once_and_stays_on_the_page(self):
        for _ in range(2):
            done = self.figure4("--ratio", "2")
            self.assertEqual(done.returncode, 0, done.stderr)
        page = (self.docs / "figure4.md").read_text()
        self.assertEqual(page.count("Against this one film of `bdpt`"), 1)
        self.assertEqual(page.count("<!-- figure:begin -->"), 1)

    def test_foreign_runs_and_bad_words_are_refused(self):
        for code, arguments, words in ((2, ["--samples", "many"], "not a number of samples"),
                                       (2, ["--samples", "7500"], "whole number of chunks"),
                                       (2, ["--methods", "ptt"], "no method 'ptt'"),
                                       (2, ["--reference", "article-9=x"], "--reference takes"),
                                       (2, ["--scenes", "article-9"], "article-9"),
                                       (1, ["--program", "/no/wander"], "build it"),
                                       (3, ["--reference", f"article-1={self.root}"], "run.json"),
                                       (3, ["--chunk", "2k"], "choose another --out")):
            done = self.figure4(*arguments)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
