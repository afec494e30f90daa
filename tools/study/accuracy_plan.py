"""What docs/accuracy.md takes: comparisons of methods on eight scenes, and of mlt with each dial turned.

Budgets are seconds of wall time.  Of b seconds a run, R replicates and n contenders, a study takes
R n b seconds at its largest budget and a quarter of it at each smaller one; the reference of a scene
that is not known exactly takes 3 R b once.
"""
import json
import re
from dataclasses import dataclass
from pathlib import Path

SCENES = ["article-3", "article-4", "slit", "corridor", "lens", "mirror-dish", "frosted", "ajar-mirror"]
METHODS = ["pt", "lt", "bdpt", "mlt", "pssmlt", "mmlt"]
CURVE = (1 / 16, 1 / 4, 1)  # budgets of the comparison of methods, times the largest
REFERENCE = 3

# The usual values (large_step 0.3, kernel auto) take part in every sweep without being named.
DIALS = {
    "film": ["chains"],
    "large_step": ["0.02", "0.1", "0.6", "0.9"],
    "kernel": ["0.25", "1", "4", "16"],
    "chains": ["64", "1024", "4096"],
    "seed_share": ["0.05", "1", "4"],
    "precision": ["float"],
}
# What a dial does to chains shows on their own film: most of a pooled one may be that of samples.
CHAINS_ALONE = ("--dial", "film=chains")
# Of `--mutations auto`, by word (auto_weight in mutations/*.h).
AUTO_WEIGHTS = {"bidirectional": 0.5, "lens": 1, "caustic": 1, "multichain": 1, "primary": 1.5}


@dataclass(frozen=True)
class Study:
    scene: str
    name: str  # "methods", or a dial
    methods: list
    settings: list  # of the dial
    relative_budgets: tuple
    options: tuple = ()  # of compare, beside these

    def effort(self):
        """Runs of the largest budget that one replicate is worth."""
        return len(self.methods) * (1 + len(self.settings)) * sum(self.relative_budgets)

    def budgets(self, seconds):
        return [f"{seconds * part:.2g}s" for part in self.relative_budgets]

    def directory(self, out):
        return Path(out) / self.scene / self.name

    def command(self, program, seconds, replicates, out):
        words = [str(program), "compare", f"gallery:{self.scene}", "-m", ",".join(self.methods), "-b",
                 ",".join(self.budgets(seconds)), "--replicates", str(replicates)]
        if self.settings:
            words += ["--sweep", f"{self.name}=" + joined(self.settings)]
        return words + [*self.options, "-o", str(self.directory(out)), "--force"]


def joined(settings):
    """Settings that hold commas are parted by semicolons; one alone ends with it."""
    if any("," in setting for setting in settings):
        return ";".join(settings) + (";" if len(settings) == 1 else "")
    return ",".join(settings)


def mutation_settings(taken):
    """Column heads and specs: one family of moves alone, and auto without each of its words."""
    words = [word for word in AUTO_WEIGHTS if any(re.fullmatch(word + "(_.*)?", name) for name in taken)]
    settings = {f"`{word}` alone": f"{word}=1" for word in ("primary", "bidirectional") if word in words}
    for word in words:
        rest = [f"{other}={AUTO_WEIGHTS[other]:g}" for other in words if other != word]
        if len(rest) > 1:
            settings[f"without `{word}`"] = ",".join(rest)
    return settings


def studies_of(scene, requirements):
    """All studies of a scene, from what `wander inspect --json` says of it; the one of methods first."""
    longest = requirements["max_vertices"]
    settings = dict(DIALS, max_vertices=[str(n) for n in (longest - 2, longest - 1) if n >= 2],
                    mutations=list(mutation_settings(requirements["requires"]["mutations"]).values()))
    return [Study(scene, "methods", METHODS, [], CURVE)] + [
        Study(scene, dial, ["mlt"], values, (1,), () if dial == "film" else CHAINS_ALONE)
        for dial, values in settings.items() if values]


def seconds_per_run(studies, minutes, replicates):
    """The largest budget with which all studies and references take so many minutes."""
    scenes = len({study.scene for study in studies})
    effort = sum(study.effort() for study in studies) + REFERENCE * scenes
    return float(f"{60 * minutes / (replicates * effort):.2g}")


def requirements_of(program, scene, call):
    return json.loads(call([str(program), "inspect", f"gallery:{scene}", "--json", "-q"]))
