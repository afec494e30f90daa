"""What documents show in Python runs, block after block."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
PAGES = [
    page for page in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))] if "```python\n" in page.read_text()
]


def blocks_of(text: str) -> list[tuple[str, str]]:
    """What a page shows, in its order: ("python", block) and ("console", command)."""
    found = []
    for kind, block in re.findall(r"^```(python|console)\n(.*?)^```$", text, re.M | re.S):
        if kind == "python":
            found.append((kind, block))
        else:
            found += [(kind, line[2:]) for line in block.splitlines() if line.startswith("$ wander ")]
    return found


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_blocks_run(wander, page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names: dict = {}
    for kind, block in blocks_of(page.read_text()):
        if kind == "python":
            exec(compile(block, page.name, "exec"), names)
        else:
            wander(*shlex.split(block, comments=True)[1:])


def test_the_pages_are_found():
    assert "python.md" in {page.name for page in PAGES}
    text = "a\n```console\n$ wander gallery\nslit\n```\n```python\nx = 1\n```\n"
    assert blocks_of(text) == [("console", "wander gallery"), ("python", "x = 1\n")]
