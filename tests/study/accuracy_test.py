"""tools/accuracy with a program that measures nothing: what it asks for, what it keeps, what the page shows."""
import json
import math
import os
import stat
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

import place
from study import error_figure
from study.accuracy_plan import joined, mutation_settings, seconds_per_run, studies_of
from study.comparison import Measured

# `inspect` and `compare` of made-up numbers; writes each command down.  float is refused, as where a
# scene does not fit; kernel=4 is significantly worse than usual.
STAND_IN = '''#!%s
import json, pathlib, sys
words = sys.argv[1:]
value = lambda option: words[words.index(option) + 1]
if words[0] == "inspect":
    print(json.dumps({"max_vertices": 6, "requires": {"mutations": ["bidirectional", "lens", "primary_small"]}}))
    sys.exit()
out = pathlib.Path(value("-o"))
with open(out.parents[1] / "commands", "a") as log:
    log.write(" ".join(words) + "\\n")
dial, _, values = value("--sweep").partition("=") if "--sweep" in words else ("", "", "")
if dial == "precision":
    sys.exit("error: --precision float cannot hold this scene")
settings = [s for s in values.split(";" if ";" in values else ",") if s]
contenders = [dict(method=m, label=m, dial="", setting="") for m in value("-m").split(",")]
contenders += [dict(method="mlt", label="mlt " + s, dial=dial, setting=s) for s in settings]
budgets = value("-b").split(",")
measured = lambda x: {"value": x, "low": 0.9 * x, "high": 1.1 * x}
cells = [dict(contender=c, budget=b, seconds=measured(float(t[:-1])), relative_rmse=measured(0.01 * (c + 1) / (b + 1)))
         for c in range(len(contenders)) for b, t in enumerate(budgets)]
crossings = [dict(ahead=0, behind=c, significant=dial == "kernel" and contenders[c]["setting"] == "4", seconds=measured(0.5))
             for c in range(1, len(contenders))]
out.mkdir(parents=True, exist_ok=True)
(out / "compare.json").write_text(json.dumps(dict(
    complete=True, contenders=contenders, budgets=budgets, cells=cells, crossings=crossings)))
''' % sys.executable


class Accuracy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = Path(cls.folder.name)
        (cls.root / "out").mkdir()
        program = cls.root / "stand-in"
        program.write_text(STAND_IN)
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        cls.first = cls.accuracy()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def accuracy(cls, *more):
        return subprocess.run([sys.executable, "-B", str(place.ROOT / "tools/accuracy"), "--scenes", "slit,lens", "--minutes",
                               "2", "--out", str(cls.root / "out"), "--docs", str(cls.root / "docs"), "--program",
                               str(cls.root / "stand-in"), *more], capture_output=True, text=True, env=dict(os.environ))

    def commands(self):
        return (self.root / "out/commands").read_text().splitlines()

    def test_makes_each_study_once(self):
        self.assertEqual(self.first.returncode, 0, self.first.stderr)
        before = [line for line in self.commands() if "precision" not in line]
        self.assertEqual(len(before), 2 * 8)
        self.assertEqual([line for line in before if "film=chains" not in line],
                         [line for line in before if "--sweep" not in line], "dials are those of chains")
        self.assertEqual(self.accuracy().returncode, 0)
        self.assertEqual([line for line in self.commands() if "precision" not in line], before)

    def test_says_what_the_program_refuses(self):
        self.assertIn("--precision float cannot hold this scene", self.first.stderr)

    def test_page_has_methods_dials_and_marks(self):
        text = (self.root / "docs/accuracy.md").read_text()
        self.assertIn("-->\n    tools/accuracy --minutes 2 --replicates 8\n", text)
        self.assertIn("| slit | 0.33 % (0.30–0.37) |", text)
        self.assertIn("| without `lens` |", text)
        self.assertEqual(text.count("▼"), 2)  # kernel=4 on two scenes
        self.assertNotIn("precision:begin", text)
        ET.fromstring((self.root / "docs/accuracy.svg").read_text())

    def test_other_budgets_are_not_mixed_in(self):
        done = self.accuracy("--replicates", "9")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("choose another --out", done.stderr)

    def test_a_broken_comparison_is_named(self):
        broken = self.root / "out/slit/kernel/compare.json"
        whole = broken.read_text()
        broken.write_text(json.dumps({"complete": True}))
        done = self.accuracy()
        broken.write_text(whole)
        self.assertEqual(done.returncode, 3)
        self.assertIn("slit/kernel/compare.json", done.stderr)


class Figure(unittest.TestCase):
    def test_an_error_without_an_interval_has_no_bar(self):
        def bars(*interval):
            points = [(Measured(t, t, t), Measured(e, *interval)) for t, e in ((0.1, 0.2), (1, 0.1))]
            drawn = error_figure.draw({"slit": {"mlt": points}}, ["mlt"])
            self.assertNotIn("nan", drawn)
            return drawn.count('stroke-width="0.6"')
        self.assertEqual(bars(0.05, 0.3) - bars(math.nan, math.nan), 2)

    def test_letters_stay_apart_and_above_the_axis(self):
        self.assertEqual(error_figure.apart([10, 81], 6, 84), [10, 81])
        self.assertEqual(error_figure.apart([50, 52], 6, 84), [48, 54])
        self.assertEqual(error_figure.apart([10, 80, 82, 82], 6, 84), [10, 72, 78, 84])


class Plan(unittest.TestCase):
    def test_settings_with_commas_are_parted_by_semicolons(self):
        self.assertEqual(joined(["1", "2"]), "1,2")
        self.assertEqual(joined(["a=1,b=2"]), "a=1,b=2;")
        self.assertEqual(joined(["a=1,b=2", "c=1"]), "a=1,b=2;c=1")

    def test_mutations_leave_one_word_out(self):
        settings = mutation_settings(["bidirectional", "lens", "primary_small", "primary_large"])
        self.assertEqual(settings["without `lens`"], "bidirectional=0.5,primary=1.5")
        self.assertEqual(settings["`primary` alone"], "primary=1")
        self.assertNotIn("without `caustic`", settings)

    def test_time_is_that_of_all_runs(self):
        requirements = {"max_vertices": 5, "requires": {"mutations": ["primary_small"]}}
        studies = studies_of("slit", requirements)
        seconds = seconds_per_run(studies, 10, 4)
        spent = 4 * seconds * (sum(study.effort() for study in studies) + 3)
        self.assertAlmostEqual(spent, 600, delta=30)


if __name__ == "__main__":
    unittest.main()
