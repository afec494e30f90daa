"""A small writer of SVG: lengths in points, text escaped, attributes by name (`_` stands for `-`).

Colours and sizes are those of the figures of the program (draw/figure/style.h).
"""
from xml.sax.saxutils import escape, quoteattr

FONT = "Helvetica, Arial, sans-serif"
INK, FAINT, NEUTRAL = "#222222", "#e4e4e4", "#808080"
TITLE_SIZE, LABEL_SIZE, SMALL_SIZE = 8.5, 7.5, 6.5
PAGE_WIDTH = 516


def number(x):
    """At most two decimals, which is a hundredth of a point."""
    text = f"{x:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


class Svg:
    def __init__(self, width, height, title, description):
        self.parts = [
            '<?xml version="1.0" encoding="UTF-8"?>',
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{number(width)}pt" height="{number(height)}pt" '
            f'viewBox="0 0 {number(width)} {number(height)}" role="img" font-family="{FONT}">',
            f"<title>{escape(title)}</title>", f"<desc>{escape(description)}</desc>",
            f'<rect width="{number(width)}" height="{number(height)}" fill="#ffffff"/>']

    def element(self, name, **attributes):
        self.parts.append(f"<{name}{attribute_text(attributes)}/>")

    def line(self, points, **attributes):
        """An open line through points (x, y)."""
        path = "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)
        self.element("path", d=path, **{"fill": "none", "stroke": INK, "stroke_width": 0.6, **attributes})

    def text(self, x, y, words, **attributes):
        options = {"font_size": SMALL_SIZE, "fill": INK, **attributes}
        self.parts.append(f'<text x="{number(x)}" y="{number(y)}"{attribute_text(options)}>{escape(words)}</text>')

    def nested(self, x, y, width, height, view_box, content):
        """Another drawing in a rectangle of this one; it keeps its proportions."""
        self.parts.append(f'<svg x="{number(x)}" y="{number(y)}" width="{number(width)}" height="{number(height)}" '
                          f'viewBox="{" ".join(map(number, view_box))}">{content}</svg>')

    def finish(self):
        return "\n".join(self.parts) + "\n</svg>\n"


def attribute_text(attributes):
    return "".join(f" {name.replace('_', '-')}={quoteattr(number(x) if isinstance(x, float) else str(x))}"
                   for name, x in attributes.items())
