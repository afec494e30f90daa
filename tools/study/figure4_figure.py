"""Figure 4 as small multiples: a row for each scene, a column for each method.

Fewest samples as a pale area under a step line, most samples as a dark step line, the reference thin
and dashed.  A row has one scale, from 0 to SPREAD times the bright end of its best film; what lies
above is cut, and a triangle marks it.
"""
from study.axis import ticks_up_to, unit_of
from study.page import error_text, power_of_ten
from study.svg import FAINT, LABEL_SIZE, NEUTRAL, PAGE_WIDTH, TITLE_SIZE, Svg, number

METHOD_NAMES = {"pt": "path tracing", "lt": "light tracing", "bdpt": "bidirectional", "mlt": "Metropolis",
                "mlt-chains": "its chains alone", "pssmlt": "primary sample space", "mmlt": "multiplexed",
                "pt-naive": "naive path tracing", "lt-naive": "naive light tracing"}
PALE, AREA, DARK, REFERENCE = "#4d9fd6", "#d3e7f5", "#1a1a1a", "#d55e00"
SPREAD = 1.5
MARGIN, PICTURE, AXIS, GAP, PANEL_HEIGHT, ROW_HEIGHT, HEAD = 6, 84, 32, 8, 60, 92, 46


class Panel:
    """A rectangle with the unit square of the sensor, from 0 to 1, and values from 0 to top."""

    def __init__(self, svg, x, y, width, top):
        self.svg, self.x, self.y, self.width, self.top = svg, x, y, width, top

    def to_x(self, u):
        return self.x + u * self.width

    def to_y(self, value):
        return self.y + PANEL_HEIGHT * (1 - min(max(value / self.top, 0), 1))

    def outline(self, film):
        """The tops of the bins from left to right, cut at the top."""
        n = len(film.values)
        return [(self.to_x(i / n), self.to_y(v)) for k, v in enumerate(film.values) for i in (k, k + 1)]

    def area(self, film):
        points = [(self.x, self.to_y(0)), *self.outline(film), (self.to_x(1), self.to_y(0))]
        self.svg.line(points, fill=AREA, stroke="none")

    def steps(self, film, colour, width, **more):
        self.svg.line(self.outline(film), stroke=colour, stroke_width=width, stroke_linejoin="round", **more)

    def cut_marks(self, film, colour, offset):
        """A triangle above each run of bins that do not fit."""
        n, k = len(film.values), 0
        while k < n:
            first = k
            while k < n and film.values[k] > self.top:
                k += 1
            if k > first:
                x, y = self.to_x((first + k) / 2 / n), self.y - offset
                self.svg.element("path", d=f"M{number(x - 1.5)} {number(y)}h3l-1.5 -2.4z", fill=colour)
            k += 1

    def frame(self):
        for tick in ticks_up_to(self.top)[1:]:
            self.svg.line([(self.x, self.to_y(tick)), (self.to_x(1), self.to_y(tick))], stroke=FAINT, stroke_width=0.4)

    def axes(self):
        self.svg.line([(self.x, self.y), (self.x, self.to_y(0)), (self.to_x(1), self.to_y(0))], stroke_width=0.6)


def styled(samples):
    """(samples, is_pale) from the one drawn first to the one drawn last."""
    ordered = sorted(samples)
    return [(n, n != ordered[-1]) for n in ordered]


def draw_panel(panel, row, method, samples):
    panel.frame()
    films = [(row.films.get((method, n)), is_pale) for n, is_pale in styled(samples)]
    for film, is_pale in films:
        if film and is_pale:
            panel.area(film)
    for film, is_pale in films:
        if film:
            panel.steps(film, PALE if is_pale else DARK, 0.6 if is_pale else 0.8)
            panel.cut_marks(film, PALE if is_pale else DARK, 1 if is_pale else 3.6)
    panel.steps(row.reference().film, REFERENCE, 0.5, stroke_dasharray="2 1.2")
    panel.axes()
    if not any(film for film, _ in films):
        panel.svg.text(panel.to_x(0.5), panel.to_y(panel.top / 2), "no film", text_anchor="middle", fill=NEUTRAL)


def draw_errors(panel, row, method, samples):
    """Relative RMSE above the panel, the pale film's to the left; and of how many samples, if that is not what its
    colour says, or for the dark one."""
    for n, is_pale in styled(samples):
        film, measured = row.films.get((method, n)), row.relative_mse((method, n))
        words, made = error_text(*measured) if measured else "–", film.samples if film else n
        if made != n or not is_pale:
            words = f"{power_of_ten(made)}: {words}"
        panel.svg.text(panel.x if is_pale else panel.to_x(1), panel.y - 8.5, words, font_size=6,
                       text_anchor="start" if is_pale else "end", fill="#1f6fa3" if is_pale else DARK)


def draw_row(svg, y, row, picture, columns, samples):
    svg.text(MARGIN, y - 8.5, row.scene, font_size=LABEL_SIZE, font_weight="bold")
    svg.nested(MARGIN, y, PICTURE, PANEL_HEIGHT, *picture)
    if row.reference() is None:
        svg.text(columns[0][0], y + PANEL_HEIGHT / 2, "no light seen yet", fill=NEUTRAL)
        return
    bright = sorted(row.reference().film.values)
    top = SPREAD * bright[int(0.98 * (len(bright) - 1))]
    unit, power = unit_of(top)
    length = row.sensor_length()
    for k, (x, width, method) in enumerate(columns):
        panel = Panel(svg, x, y, width, top)
        draw_panel(panel, row, method, samples)
        draw_errors(panel, row, method, samples)
        for tick in ticks_up_to(top) if k == 0 else []:
            svg.text(x - 3, panel.to_y(tick) + 2.2, f"{tick / unit:.3g}", text_anchor="end")
        for u, anchor in ((0, "start"), (1, "end")):
            svg.text(panel.to_x(u), y + PANEL_HEIGHT + 8, f"{u * length:g}", text_anchor=anchor)
    x = columns[0][0] - 22
    svg.text(x, y + PANEL_HEIGHT / 2, f"irradiance, {power}W/m", text_anchor="middle",
             transform=f"rotate(-90 {number(x)} {number(y + PANEL_HEIGHT / 2)})")


def draw_legend(svg, samples, y):
    x = MARGIN + PICTURE + AXIS
    for n, is_pale in styled(samples):
        if is_pale:
            svg.element("rect", x=x, y=y - 5, width=16, height=6, fill=AREA)
        svg.line([(x, y - (5 if is_pale else 2)), (x + 16, y - (5 if is_pale else 2))],
                 stroke=PALE if is_pale else DARK, stroke_width=0.6 if is_pale else 0.9)
        svg.text(x + 20, y, f"{power_of_ten(n)} samples")
        x += 74
    svg.line([(x, y - 2), (x + 16, y - 2)], stroke=REFERENCE, stroke_width=0.6, stroke_dasharray="2 1.2")
    svg.text(x + 20, y, "reference")
    svg.element("path", d=f"M{number(x + 66)} {number(y)}h3.6l-1.8 -3z", fill=DARK)
    svg.text(x + 73, y, "above the scale")
    svg.text(PAGE_WIDTH - MARGIN, y, "%: relative RMSE", text_anchor="end")


def draw(rows, pictures, methods, samples):
    """The figure as text of an SVG; pictures by scene."""
    height = HEAD + ROW_HEIGHT * len(rows) - 4
    svg = Svg(PAGE_WIDTH, height, "Estimated distributions of light on the sensor",
              "A row for each scene, a column for each method: irradiance over the position on the sensor.")
    left, right = MARGIN + PICTURE + AXIS, PAGE_WIDTH - MARGIN
    width = (right - left - GAP * (len(methods) - 1)) / len(methods)
    columns = [(left + k * (width + GAP), width, method) for k, method in enumerate(methods)]
    draw_legend(svg, samples, 11)
    for x, w, method in columns:
        svg.text(x + w / 2, 25, METHOD_NAMES[method], font_size=TITLE_SIZE, font_weight="bold", text_anchor="middle")
    for k, row in enumerate(rows):
        draw_row(svg, HEAD + k * ROW_HEIGHT, row, pictures[row.scene], columns, samples)
    svg.text((left + right) / 2, height - 4, "position on the sensor, m", font_size=LABEL_SIZE, text_anchor="middle")
    return svg.finish()
