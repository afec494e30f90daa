"""The parts of docs/accuracy.md that tools/accuracy makes, from the comparisons that there are."""
import math

from study.accuracy_plan import METHODS, mutation_settings
from study.page import percent, table

USUAL = ("mlt", "", "")


def range_text(error):
    """5.4 % (5.0–6.1)."""
    if math.isnan(error.low) or math.isnan(error.high):
        return f"{percent(error.value)} (no interval)"
    return f"{percent(error.value)} ({percent(error.low)[:-2]}–{percent(error.high)[:-2]})"


def seconds_text(t):
    return "the first budget" if t.value == 0 else f"{t.value:.2g} s ({t.low:.2g}–{t.high:.2g})"


def methods_row(scene, comparison):
    """Errors at the largest budget, and from when on mlt is ahead of bdpt."""
    cells = [scene]
    for method in METHODS:
        key = (method, "", "")
        error = comparison.error(key)
        beats_all = error and all(comparison.lead(key, (other, "", "")) == 1 for other in METHODS if other != method)
        text = range_text(error) if error else "–"
        cells.append(f"**{text}**" if beats_all else text)
    mlt, bdpt = USUAL, ("bdpt", "", "")
    start = comparison.ahead_from(mlt, bdpt)
    cells.append(seconds_text(start) if start else ("never seen" if comparison.lead(mlt, bdpt) == -1 else "not significant"))
    return cells


def methods_part(comparisons):
    """comparisons: by scene."""
    heads = ["scene", *(f"`{method}`" for method in METHODS), "`mlt` ahead of `bdpt` from"]
    figure = "![Error against time, a panel for each scene and a line for each method](accuracy.svg)"
    return figure + "\n\n" + table(heads, [methods_row(scene, it) for scene, it in comparisons.items()])


def setting_cell(comparison, dial, setting):
    """▲: less error than usual, beyond chance; ▼: more."""
    key = ("mlt", dial, setting)
    error = comparison.error(key)
    if not error:
        return "–"
    return range_text(error) + {1: " ▲", 0: "", -1: " ▼"}[comparison.lead(key, USUAL)]


def dial_row(scene, comparison, dial, settings):
    usual = comparison.error(USUAL)
    return [scene, range_text(usual) if usual else "–",
            *(setting_cell(comparison, dial, setting) if setting else "–" for setting in settings)]


def columns_of(studies, requirements):
    """Heads of the columns of a dial, and by scene the settings in them, None where a scene has none."""
    dial = studies[0].name
    if dial == "mutations":
        by_scene = {study.scene: mutation_settings(requirements[study.scene]["requires"]["mutations"]) for study in studies}
    elif dial == "max_vertices":
        by_scene = {study.scene: {("longest − 2", "longest − 1")[k - len(study.settings)]: setting
                                  for k, setting in enumerate(study.settings)} for study in studies}
    else:
        by_scene = {study.scene: {setting: setting for setting in study.settings} for study in studies}
    heads = list(dict.fromkeys(head for columns in by_scene.values() for head in columns))
    return heads, {scene: [columns.get(head) for head in heads] for scene, columns in by_scene.items()}


def dial_part(studies, comparisons, requirements):
    """studies of one dial on all scenes; comparisons: by scene, of those that there are."""
    heads, settings = columns_of(studies, requirements)
    rows = [dial_row(scene, comparison, studies[0].name, settings[scene]) for scene, comparison in comparisons.items()]
    return table(["scene", "usual", *heads], rows)


def curves_of(comparisons):
    """By scene and method, for the figure; scenes of which nothing is known are left out."""
    curves = {scene: {method: points for method in METHODS if (points := comparison.curve((method, "", "")))}
              for scene, comparison in comparisons.items()}
    return {scene: methods for scene, methods in curves.items() if methods}
