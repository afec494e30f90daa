"""The drawing of a scene, taken out of a figure of `wander plot SCENE`, to be nested in another."""
import re
import xml.etree.ElementTree as ET

NAMESPACE = "http://www.w3.org/2000/svg"


def picture_of(figure):
    """View box (x, y, width, height) and content: walls, light and sensor, without axes and legend."""
    ET.register_namespace("", NAMESPACE)
    scene = next(group for group in ET.fromstring(figure).iter(f"{{{NAMESPACE}}}g") if group.get("class") == "scene")
    points = [(float(x), float(y)) for path in scene.iter(f"{{{NAMESPACE}}}path")
              for x, y in re.findall(r"[ML](-?[\d.]+) (-?[\d.]+)", path.get("d"))]
    left, top = (min(column) - 2 for column in zip(*points))
    right, bottom = (max(column) + 2 for column in zip(*points))
    return (left, top, right - left, bottom - top), ET.tostring(scene, encoding="unicode")
