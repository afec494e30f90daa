"""Error against time as small multiples: a panel for each scene, a line for each method, log-log.

Bars are the 95 % intervals of the comparison, where it has one.  Methods are told apart by dashes and by the letters
at the ends of their lines, which the legend explains; colours help.
"""
import math

from study.svg import FAINT, LABEL_SIZE, NEUTRAL, PAGE_WIDTH, Svg, number

# The palette and dashes of films in the program's figures (draw/figure/style.h).
STROKES = {"mlt": ("#0072b2", "none"), "bdpt": ("#d55e00", "4 1.6"), "lt": ("#009e73", "1.3 1.3"),
           "pt": ("#cc79a7", "6 1.5 1.3 1.5"), "pssmlt": ("#e69f00", "2.6 1.3"), "mmlt": ("#56b4e9", "6 1.2 1.2 1.2")}
LETTERS = {"mlt": "M", "bdpt": "B", "lt": "L", "pt": "P", "pssmlt": "S", "mmlt": "X"}
MARGIN, AXIS, COLUMNS, HEAD, PANEL_HEIGHT, ROW_HEIGHT, GAP = 6, 30, 4, 34, 84, 122, 10


class LogPanel:
    """Decades of seconds to the right and of error upwards."""

    def __init__(self, svg, x, y, width, times, errors):
        self.svg, self.x, self.y, self.width = svg, x, y, width
        self.times, self.errors = times, errors

    def to_x(self, seconds):
        low, high = self.times
        return self.x + self.width * math.log(seconds / low) / math.log(high / low)

    def to_y(self, error):
        low, high = self.errors
        return self.y + PANEL_HEIGHT * (1 - math.log(min(max(error, low), high) / low) / math.log(high / low))

    def axes(self, has_labels):
        for exponent in decades(self.errors):
            y = self.to_y(10.0**exponent)
            self.svg.line([(self.x, y), (self.x + self.width, y)], stroke=FAINT, stroke_width=0.4)
            if has_labels:
                self.svg.text(self.x - 3, y + 2.2, f"{10.0**(exponent + 2):g} %", text_anchor="end")
        base = self.y + PANEL_HEIGHT
        self.svg.line([(self.x, self.y), (self.x, base), (self.x + self.width, base)])
        for seconds in [m * 10.0**k for k in range(-3, 5) for m in (1, 3)]:
            if self.times[0] <= seconds <= self.times[1]:
                x = self.to_x(seconds)
                self.svg.line([(x, base), (x, base + 2.5)])
                self.svg.text(x, base + 9, f"{seconds:g}", text_anchor="middle")

    def curve(self, method, points):
        colour, dashes = STROKES[method]
        line = [(self.to_x(t.value), self.to_y(e.value)) for t, e in points]
        self.svg.line(line, stroke=colour, stroke_width=0.9, stroke_dasharray=dashes)
        for (x, _), (_, error) in zip(line, points):
            if math.isnan(error.low) or math.isnan(error.high):  # no interval is known
                continue
            low = error.low if error.low > 0 else self.errors[0]
            self.svg.line([(x, self.to_y(low)), (x, self.to_y(error.high))], stroke=colour, stroke_width=0.6)

    def letters(self, ends):
        """At the ends of the curves, (method, x, y), moved as little as keeps them apart and above the axis."""
        ends = sorted(ends, key=lambda end: end[2])
        for (method, x, _), y in zip(ends, apart([y for _, _, y in ends], 6, self.y + PANEL_HEIGHT - 3)):
            self.svg.text(x + 2, y + 2, LETTERS[method], font_size=6, fill=STROKES[method][0], font_weight="bold")


def apart(positions, least, most):
    """The nearest positions by squares, no larger than `most`, that are so far apart: isotonic regression of y_k - k least."""
    blocks = []  # (sum, count)
    for k, y in enumerate(positions):
        blocks.append((y - k * least, 1))
        while len(blocks) > 1 and blocks[-2][0] / blocks[-2][1] > blocks[-1][0] / blocks[-1][1]:
            total, count = blocks.pop()
            blocks[-1] = (blocks[-1][0] + total, blocks[-1][1] + count)
    level = [total / count for total, count in blocks for _ in range(count)]
    largest = most - (len(level) - 1) * least
    return [min(y, largest) + k * least for k, y in enumerate(level)]


def decades(ends):
    return range(math.ceil(math.log10(ends[0]) - 1e-9), math.floor(math.log10(ends[1]) + 1e-9) + 1)


def extent(values, most_decades):
    """From the least value to the largest with some room; the largest values win the decades that there are."""
    high = max(values) * 1.3
    return max(min(values) / 1.3, high / 10.0**most_decades), high


def draw_scene(panel_at, scene, curves, errors, has_labels):
    """curves: points by method."""
    times = extent([t.value for points in curves.values() for t, _ in points], 4)
    panel = panel_at(times, errors)
    panel.svg.text(panel.x, panel.y - 4, scene, font_size=LABEL_SIZE, font_weight="bold")
    panel.axes(has_labels)
    for method, points in curves.items():
        panel.curve(method, points)
    last = {method: points[-1] for method, points in curves.items()}
    panel.letters([(method, panel.to_x(t.value), panel.to_y(e.value)) for method, (t, e) in last.items()])


def draw_legend(svg, methods):
    x = MARGIN + AXIS
    for method in methods:
        colour, dashes = STROKES[method]
        svg.line([(x, 9), (x + 18, 9)], stroke=colour, stroke_width=0.9, stroke_dasharray=dashes)
        svg.text(x + 22, 11, f"{LETTERS[method]}  {method}")
        x += 62
    svg.text(PAGE_WIDTH - MARGIN, 11, "bars: 95 %", text_anchor="end")


def draw(scenes, methods):
    """The figure as text of an SVG; scenes: name → points by method."""
    rows = -(-len(scenes) // COLUMNS)
    height = HEAD + rows * ROW_HEIGHT
    svg = Svg(PAGE_WIDTH, height, "Error against time",
              "Relative root mean square error over seconds of wall time, for each scene and method.")
    draw_legend(svg, methods)
    width = (PAGE_WIDTH - 2 * MARGIN - AXIS - GAP * (COLUMNS - 1)) / COLUMNS
    for k, (scene, curves) in enumerate(scenes.items()):
        x, y = MARGIN + AXIS + k % COLUMNS * (width + GAP), HEAD + k // COLUMNS * ROW_HEIGHT
        # A row has one scale of errors.
        row = list(scenes.values())[k - k % COLUMNS:k - k % COLUMNS + COLUMNS]
        errors = extent([e.value for others in row for points in others.values() for _, e in points], 4)
        draw_scene(lambda times, errors, x=x, y=y: LogPanel(svg, x, y, width - 8, times, errors), scene, curves, errors,
                   k % COLUMNS == 0)
        svg.text(x + width / 2, y + PANEL_HEIGHT + 18, "time, s", text_anchor="middle", fill=NEUTRAL)
    for middle in (HEAD + row * ROW_HEIGHT + PANEL_HEIGHT / 2 for row in range(rows)):
        svg.text(11, middle, "relative RMSE", text_anchor="middle", transform=f"rotate(-90 11 {number(middle)})")
    return svg.finish()
