"""What tests/precision/wander_precision prints, as the tables and the figure of docs/precision.md."""
import math

from study.page import SUPERSCRIPTS, table
from study.svg import FAINT, LABEL_SIZE, NEUTRAL, PAGE_WIDTH, Svg

SWEEPS = {"length": ("Length", "vertices"), "angle": ("Angle", "cosine"), "roughness": ("Roughness", "α"),
          "distance": ("Distance", "in lengths of the light"), "offset": ("Offset", "in diameters of the room")}
WORLDS = {2: "In the plane", 3: "In space"}
PRECISIONS = ("float", "double")
QUANTITIES = {"contribution": "f", "density": "Σ p", "weights": "w", "acceptance": "acceptance"}
COLOURS = {"float": "#d55e00", "double": "#0072b2"}
DASHES = {"contribution": "none", "acceptance": "2.6 1.3"}
MARGIN, AXIS, HEAD, PANEL_HEIGHT, GAP = 6, 30, 34, 120, 9
LOW, HIGH = -17, -5  # decades of differences


def read(text):
    """Medians and largest differences: {dimension: {sweep: {setting: {(precision, quantity): (median, largest)}}}}."""
    worlds = {}
    for line in text.splitlines():
        dimension, sweep, setting, precision, quantity, median, largest, _ = line.split("\t")
        settings = worlds.setdefault(int(dimension), {}).setdefault(sweep, {})
        settings.setdefault(float(setting), {})[precision, quantity] = (float(median), float(largest))
    return worlds


def power(x):
    """10⁻⁴; numbers that are no power of ten as they are."""
    exponent = math.log10(x)
    if exponent != round(exponent) or x in (1, 10):
        return f"{x:g}"
    return "10" + str(round(exponent)).translate(SUPERSCRIPTS)


def difference(x):
    """One digit: 3·10⁻⁸."""
    if x == 0 or math.isnan(x):
        return "0" if x == 0 else "no number"
    mantissa, exponent = f"{x:.0e}".split("e")
    return f"{mantissa}·10" + str(int(exponent)).translate(SUPERSCRIPTS)


def tables(worlds):
    """Of each sweep of each world, largest differences by setting."""
    heads = [f"{name}, {precision}" for precision in PRECISIONS for name in QUANTITIES.values()]
    parts = ["![Largest differences from extended precision, a panel for each sweep](precision.svg)"]
    for dimension, name in WORLDS.items():
        parts.append(f"### {name}")
        for sweep, (title, unit) in SWEEPS.items():
            rows = [[power(setting)] + [difference(cells[precision, quantity][1]) for precision in PRECISIONS
                                        for quantity in QUANTITIES] for setting, cells in worlds[dimension][sweep].items()]
            parts.append(f"**{title}**\n\n" + table([unit, *heads], rows))
    return "\n\n".join(parts)


class Panel:
    """Settings to the right and differences upwards, both in decades."""

    def __init__(self, svg, x, y, width, settings):
        self.svg, self.x, self.y, self.width, self.settings = svg, x, y, width, settings

    def to_x(self, setting):
        low, high = math.log(min(self.settings)), math.log(max(self.settings))
        return self.x + self.width * (math.log(setting) - low) / (high - low)

    def to_y(self, value):
        decade = LOW if value == 0 else min(max(math.log10(value), LOW), HIGH)
        return self.y + PANEL_HEIGHT * (HIGH - decade) / (HIGH - LOW)

    def axes(self, has_labels):
        for decade in range(LOW, HIGH + 1, 2):
            y = self.to_y(10.0**decade)
            self.svg.line([(self.x, y), (self.x + self.width, y)], stroke=FAINT, stroke_width=0.4)
            if has_labels:
                self.svg.text(self.x - 3, y + 2.2, power(10.0**decade), text_anchor="end")
        base = self.y + PANEL_HEIGHT
        self.svg.line([(self.x, self.y), (self.x, base), (self.x + self.width, base)])

    def settings_at_ends(self):
        for setting in (min(self.settings), max(self.settings)):
            anchor = "start" if setting == min(self.settings) else "end"
            self.svg.text(self.to_x(setting), self.y + PANEL_HEIGHT + 9, power(setting), text_anchor=anchor)

    def curve(self, precision, quantity, cells):
        points = [(self.to_x(setting), self.to_y(cells[setting][precision, quantity][1])) for setting in self.settings]
        self.svg.line(points, stroke=COLOURS[precision], stroke_width=0.9, stroke_dasharray=DASHES[quantity])


def legend(svg, x):
    for precision in PRECISIONS:
        for quantity, dashes in DASHES.items():
            svg.line([(x, 9), (x + 18, 9)], stroke=COLOURS[precision], stroke_width=0.9, stroke_dasharray=dashes)
            svg.text(x + 22, 11, f"{precision}, {QUANTITIES[quantity]}")
            x += 100


def draw_world(svg, top, sweeps):
    """A row of panels, one for each sweep."""
    width = (PAGE_WIDTH - 2 * MARGIN - AXIS - GAP * (len(SWEEPS) - 1)) / len(SWEEPS)
    for k, (sweep, (title, unit)) in enumerate(SWEEPS.items()):
        panel = Panel(svg, MARGIN + AXIS + k * (width + GAP), top, width, list(sweeps[sweep]))
        svg.text(panel.x, top - 5, title, font_size=LABEL_SIZE, font_weight="bold")
        panel.axes(k == 0)
        panel.settings_at_ends()
        for precision in PRECISIONS:
            for quantity in DASHES:
                panel.curve(precision, quantity, sweeps[sweep])
        svg.text(panel.x + width / 2, top + PANEL_HEIGHT + 18, unit, text_anchor="middle", fill=NEUTRAL)


def draw(worlds):
    """The figure as text of an SVG: a row of panels for each world."""
    row = HEAD + PANEL_HEIGHT + 24
    svg = Svg(PAGE_WIDTH, 12 + len(WORLDS) * row, "What float and double lose on a path",
              "The largest relative differences of contributions and of ratios of acceptance from extended precision.")
    legend(svg, MARGIN + AXIS)
    for k, (dimension, name) in enumerate(WORLDS.items()):
        top = 12 + k * row + HEAD
        svg.text(MARGIN, top - 16, name, font_size=LABEL_SIZE)
        draw_world(svg, top, worlds[dimension])
    return svg.finish()
