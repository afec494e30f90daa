"""Where the modules and programs under test are."""
import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = os.environ.get("WANDER_PROGRAM", str(ROOT / "build/release/bin/wander"))
sys.path.insert(0, str(ROOT / "tools"))
