"""What is disturbed: commands of every verb, what is there before them, and what they leave."""

from dataclasses import dataclass

from scenes import FILES


@dataclass(frozen=True)
class Case:
    """`place` is the file or folder that the command makes; none: it prints.  `before` are commands undisturbed."""

    name: str
    command: tuple
    place: str = ""
    before: tuple = ()
    beside: tuple = ()  # other files that it makes
    has_chance: bool = False  # its numbers depend on times

    @property
    def verb(self):
        return self.command[0]

    @property
    def continues(self):
        return "--continue" in self.command

    @property
    def replaces(self):
        return "--force" in self.command or self.continues

    @property
    def prints(self):
        return "--json" in self.command or not self.place


def words(text):
    return tuple(text.split())


def case(name, command, place="", before=(), beside=(), has_chance=False):
    return Case(name, words(command), place, tuple(words(b) for b in before), beside, has_chance)


def renders():
    for method in ("pt", "lt", "bdpt", "mlt", "pssmlt", "mmlt", "pt-naive", "lt-naive"):
        yield case(f"render {method}, plane", f"render plane.json -m {method} -b 3k --checkpoint 0.002 -o out", "out")
    for method in ("pt", "lt", "bdpt", "mlt", "mmlt"):
        yield case(f"render {method}, space", f"render space.json -m {method} -b 3k -o out", "out")
    for method, scene in (("mlt", "plane"), ("bdpt", "space")):
        yield case(
            f"render {method} --force, {scene}",
            f"render {scene}.json -m {method} -b 3k -o out --force",
            "out",
            [f"render {scene}.json -m pt -b 1k -o out"],
        )
    for method, scene in (("pt", "plane"), ("mlt", "plane"), ("mmlt", "glass"), ("mlt", "space"), ("bdpt", "space")):
        yield case(
            f"render {method} --continue, {scene}",
            "render --continue -b 6k --checkpoint 0.002 -o out",
            "out",
            [f"render {scene}.json -m {method} -b 2k -o out"],
        )
    yield case("render bdpt --json, glass", "render glass.json -m bdpt -b 3k -o out --json", "out")
    yield case("render mlt, printed", "render plane.json -m mlt -b 3k --json")


def merges():
    for method, scene, force in (("mlt", "plane", ""), ("pt", "space", " --force")):
        runs = [f"render {scene}.json -m {method} -b 1k -s {seed} -o run-{seed}" for seed in (1, 2)]
        before = runs + [f"render {scene}.json -m bdpt -b 1k -o out"] if force else runs
        yield case(f"merge{force}, {scene}", f"merge run-1 run-2 -o out{force}", "out", before)


def compares():
    duel = "compare plane.json -m pt,bdpt -b 500,1k --replicates 2 -o out"
    yield case("compare, plane", duel, "out")
    yield case("compare --json, plane", duel + " --json", "out")
    yield case(
        "compare --force, plane", duel + " --force", "out", ["compare plane.json -m lt,mlt -b 1k --replicates 2 -o out"]
    )
    yield case("compare --continue, plane", "compare --continue -o out --replicates 3", "out", [duel])
    against = "compare space.json -m pt,bdpt -b 500 --replicates 2 --reference known -o out"
    known = "render space.json -m bdpt -b 20k -o known"
    yield case("compare, space", against, "out", [known])
    yield case("compare --continue, space", "compare --continue -o out --replicates 3", "out", [known, against])
    yield case(
        "compare with long runs, glass",
        "compare glass.json -m pt,bdpt -b 1k --replicates 2 -o out",
        "out",
        has_chance=True,
    )


def figures():
    run = "render plane.json -m mlt -b 2k -o run"
    yield case("plot scene, svg", "plot plane.json -o figure.svg", "figure.svg")
    yield case(
        "plot scene --force, svg",
        "plot plane.json -o figure.svg --force",
        "figure.svg",
        ["plot glass.json -o figure.svg"],
    )
    yield case("plot scene, png", "plot space.json -o figure.png", "figure.png")
    yield case(
        "plot film --force, pdf", "plot run -o figure.pdf --force", "figure.pdf", [run, "plot plane.json -o figure.pdf"]
    )
    yield case("plot image, svg", "plot image -o figure.svg", "figure.svg", ["render space.json -m pt -b 2k -o image"])
    yield case(
        "plot trajectory, svg", "plot steps.nc -o figure.svg", "figure.svg", ["trace plane.json --steps 20 -o steps.nc"]
    )
    yield case(
        "plot trajectory, obj", "plot steps.nc -o figure.obj", "figure.obj", ["trace space.json --steps 20 -o steps.nc"]
    )
    yield case(
        "plot comparison, svg",
        "plot duel -o figure.svg",
        "figure.svg",
        ["compare plane.json -m pt,bdpt -b 500 --replicates 2 -o duel"],
    )
    yield case("plot fluence, exr", "plot plane.json --fluence -b 5k --resolution 32 -o figure.exr", "figure.exr")


def others():
    yield case("trace, nc", "trace plane.json --steps 30 -o steps.nc", "steps.nc")
    yield case("trace, csv", "trace glass.json --steps 30 -o steps.csv", "steps.csv")
    yield case(
        "trace mmlt --force, nc of space",
        "trace space.json -m mmlt --chains 8 --steps 30 -o steps.nc --force",
        "steps.nc",
        ["trace space.json --steps 10 -o steps.nc"],
    )
    yield case("trace --replay", "trace plane.json --replay 0:3 --json")
    yield case("import", "import cube.xml -o made.json", "made.json", beside=("made-meshes",))
    yield case(
        "import --force",
        "import cube.xml -o made.json --force --json",
        "made.json",
        ["import cube.xml -o made.json"],
        ("made-meshes",),
    )
    yield case("gallery, with meshes", "gallery ring -o made.json", "made.json", beside=("meshes",))
    yield case("gallery, printed", "gallery slit")
    yield case("check, plane", "check plane.json --samples 300 --json")
    yield case("check, glass", "check glass.json --samples 300")
    yield case("inspect scene", "inspect space.json --json")
    yield case("inspect run", "inspect run", before=["render plane.json -m mlt -b 2k -o run"])
    yield case("inspect trajectory", "inspect steps.nc --json", before=["trace plane.json --steps 20 -o steps.nc"])


CASES = [*renders(), *merges(), *compares(), *figures(), *others()]


def write_scenes(folder):
    for name, text in FILES.items():
        (folder / name).write_text(text)
