"""What the harness must see: of a program that does wrong each fault, of scenes that they are spoilt, and how."""

import json
import random
import re
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
from mutations import MUTATIONS, hostile  # noqa: E402
from verdict import findings  # noqa: E402

SCENE = {
    "format": "wanderlight-scene/1",
    "dimension": 2,
    "materials": {"wall": {"type": "diffuse", "reflectance": 0.5}},
    "shapes": [
        {"type": "segment", "from": [1, 1], "to": [0, 1], "light": {"radiance": 1}},
        {"type": "segment", "from": [0, 0], "to": [1, 0], "sensor": {"bins": 8}},
    ],
}
FILM = "bin,center,value,standard_error,reliable\n"
PLACE = "scene.json:3:7: /shapes/0: it is wrong; allowed is what is right\n"


def found(command="render scene.json", files=(), **changes):
    done = SimpleNamespace(**{"code": 0, "out": b"", "err": "", "cpu": 0.1, **changes})
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "scene.json").write_text("{}")
        for name, text in files:
            (Path(folder) / name).write_text(text)
        return findings(command.split(), done, Path(folder))


class Verdict(unittest.TestCase):
    def test_of_what_is_right(self):
        self.assertEqual(found(), [])
        self.assertEqual(found(code=3, err=PLACE + PLACE), [])
        self.assertEqual(found(code=1, err="error: no light path was found\n"), [])
        self.assertEqual(found("check scene.json", code=4), [])
        self.assertEqual(found("inspect scene.json --json", out=b'{"a": 1}\n'), [])
        self.assertEqual(
            found(files=[("a.svg", "<svg><title>nan</title><g x='1'/></svg>"), ("film.csv", FILM + "0,0,1,nan,0\n")]),
            [],
        )

    def test_of_what_is_wrong(self):
        wrong = {
            "a signal": {"code": -11},
            "abort": {"code": -6},
            "a code of another verb": {"code": 4},
            "no such code": {"code": 255},
            "time": {"cpu": 20.5},
            "silence": {"code": 1},
            "no place": {"code": 3, "err": "error: bad\n"},
            "a library's words": {"code": 3, "err": PLACE + "scene.json:1:1: [json.exception.parse_error.101]\n"},
            "two errors of one": {"code": 1, "err": "error: a\nterminate called\n"},
            "an endless line": {"code": 3, "err": PLACE.strip() + 3000 * "x" + "\n"},
            "NaN printed": {"command": "render scene.json --json", "out": b'{"a": NaN}'},
            "half a document": {"command": "render scene.json --json", "out": b'{"a": '},
            "NaN in a large one": {
                "command": "render scene.json --json",
                "out": b'{"a": [' + b"1," * (1 << 20) + b"NaN]}\n",
            },
            "NaN in a film": {"files": [("film.csv", FILM + "0,0,nan,1,0\n")]},
            "NaN in a figure": {"files": [("a.svg", "<svg><g x='nan'/></svg>")]},
            "written all the same": {"code": 3, "err": PLACE, "files": [("film.csv", FILM)]},
        }
        for name, outcome in wrong.items():
            with self.subTest(name):
                self.assertNotEqual(found(**outcome), [])


class Mutations(unittest.TestCase):
    def test_each_of_them_changes_scenes(self):
        for mutation in MUTATIONS:
            with self.subTest(mutation.__name__):
                changed = 0
                for seed in range(30):
                    scene = json.loads(json.dumps(SCENE))
                    mutation(scene, random.Random(seed))
                    changed += scene != SCENE
                self.assertGreater(changed, 10)

    def test_tokens_and_twins_come_out_bare(self):
        texts = [hostile(SCENE, random.Random(seed))[0] for seed in range(600)]
        self.assertTrue(any(re.search(rb" (NaN|1e400|0x10|Infinity|1e-320)", text) for text in texts))
        self.assertTrue(any(text.count(b'"from"') == 3 for text in texts))
        self.assertFalse(any(b"u0000raw" in text or b"u0000twin" in text for text in texts))
        self.assertGreater(len(set(texts)), 400)


if __name__ == "__main__":
    unittest.main()
