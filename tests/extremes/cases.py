"""Scenes at the edge of what numbers can hold, each with the value that its one bin must have.

Expected values are made with 60 digits: in the plane by crossed strings, between mirrors by images, in furnaces by
their series, in space by the form factor of parallel squares.  Meshes are files of meshes.py.
"""
from decimal import Decimal, getcontext

getcontext().prec = 60
ONE = Decimal(1)


def distance(a, b):
    return sum(((Decimal(x) - Decimal(y)) ** 2 for x, y in zip(a, b)), Decimal(0)).sqrt()


def crossed_strings(lamp, sensor):
    """Mean irradiance of the sensor by a lamp of radiance 1 that all of it sees, W/m; both [from, to]."""
    (a, b), (c, d) = lamp, sensor
    strings = sorted([distance(a, c) + distance(b, d), distance(a, d) + distance(b, c)])
    return (strings[1] - strings[0]) / distance(c, d)


def scene(shapes, materials=None, max_vertices=4, dimension=2):
    return {"format": "wanderlight-scene/1", "dimension": dimension, "max_vertices": max_vertices,
            "materials": materials or {}, "shapes": shapes}


def segment(ends, **members):
    return {"type": "segment", "from": [float(x) for x in ends[0]], "to": [float(x) for x in ends[1]], **members}


def light(radiance=1):
    return {"light": {"radiance": radiance}}


SENSOR = {"sensor": {"bins": 1}}


def lamp_above(lamp, sensor, radiance=1, others=(), materials=None, max_vertices=4):
    shapes = [segment(lamp, **light(radiance)), segment(sensor, **SENSOR), *others]
    return scene(shapes, materials, max_vertices), float(Decimal(radiance) * crossed_strings(lamp, sensor))


def plates(size=1, shift=0, gap=1):
    # What the file says, not what was meant: shift + size is rounded.
    low, high, top = float(shift), float(shift + size), float(shift + gap * size)
    return [(high, top), (low, top)], [(low, low), (high, low)]


def furnace(reflectance, max_vertices):
    """A box that glows: 2 L everywhere, L = 1 + r + ... + r^(n - 2)."""
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    walls = [segment((corners[i], corners[(i + 1) % 4]), material="wall", **light()) for i in range(4)]
    walls[0].update(SENSOR)
    r = Decimal(str(reflectance))
    return (scene(walls, {"wall": {"type": "diffuse", "reflectance": reflectance}}, max_vertices),
            float(2 * sum(r ** k for k in range(max_vertices - 1))))


def mirror_corridor(length, reflectance, max_vertices):
    """Lamp and sensor fill the ends; behind k mirrors stands the k-th image of the lamp."""
    def root(h):
        return (Decimal(length) ** 2 + Decimal(h) ** 2).sqrt()
    r = Decimal(str(reflectance))
    most = max_vertices - 2
    expected = sum(r ** abs(k) * (root(k + 1) - 2 * root(k) + root(k - 1)) for k in range(-most, most + 1))
    mirror = {"material": "silver"}
    shapes = [segment([(0, 0), (length, 0)], **mirror), segment([(0, 1), (length, 1)], **mirror),
              segment([(0, 1), (0, 0)], **light()), segment([(length, 0), (length, 1)], **SENSOR)]
    return scene(shapes, {"silver": {"type": "mirror", "reflectance": reflectance}}, max_vertices), float(expected)


def behind_glass(index):
    disc = {"type": "circle", "center": [0.5, 0.5], "radius": 0.3, "material": "glass"}
    return lamp_above(*plates(), others=[disc], materials={"glass": {"type": "dielectric", "ior": index}},
                      max_vertices=8)


def beside_mirror(material):
    """All light comes by a mirror below the sensor and the lamp, which face down: the lamp's image is as far below."""
    lamp, sensor = [(-1, 1), (-0.5, 1)], [(1, 1), (0.5, 1)]
    image = [(-1, -1), (-0.5, -1)]
    shapes = [segment([lamp[1], lamp[0]], **light()), segment(sensor, **SENSOR),
              segment([(-50, 0), (50, 0)], material="silver")]
    return scene(shapes, {"silver": material}), float(crossed_strings(image, sensor))


def squares(size=1.0, shift=0.0, radiance=1):
    """Two squares a side apart: F = 0.19982..., E = pi L F."""
    x = Decimal(1)
    root = (1 + x * x).sqrt()
    pi = Decimal("3.14159265358979323846264338327950288419716939937510582097494")
    # Howell C-11 with X = Y = 1
    import math
    form = Decimal(2) / (pi * x * x) * (
        ((1 + x * x) ** 2 / (1 + 2 * x * x)).sqrt().ln() + 2 * x * root * Decimal(math.atan(float(x / root)))
        - 2 * x * Decimal(math.atan(float(x))))
    low, side = float(shift), float(size)
    shapes = [{"type": "parallelogram", "origin": [low, low + side, low], "edges": [[side, 0, 0], [0, 0, side]],
               **light(radiance)},
              {"type": "parallelogram", "origin": [low, low, low], "edges": [[0, 0, side], [side, 0, 0]],
               "sensor": {"resolution": [1, 1]}}]
    return scene(shapes, dimension=3), float(pi * form) * radiance


def ball_in_ball(size, reflectance=0.5, max_vertices=8):
    """A camera in a sphere that glows with 1 - r sees 1 - r^(n - 1)."""
    wall = {"type": "sphere", "center": [0, 0, 0], "radius": size, "flip": True, "material": "wall",
            **light(1 - reflectance)}
    made = scene([wall], {"wall": {"type": "diffuse", "reflectance": reflectance}}, max_vertices, 3)
    made["camera"] = {"type": "perspective", "position": [0, 0, size / 4], "target": [0, 0, 0], "fov_deg": 40,
                      "resolution": [1, 1]}
    return made, 1 - reflectance ** (max_vertices - 1)


def mesh(file, **members):
    return {"type": "mesh", "file": file, **members}


def below_needles():
    """The squares, with a lamp that is a mesh."""
    made, expected = squares()
    made["shapes"][0] = mesh("lamp-of-needles.ply", **light())
    return made, expected


def room(file, camera=(0.4, 0.3, 0.2), fov=60, reflectance=0.5, max_vertices=8):
    """As ball_in_ball, in the unit cube: what leaks through its triangles is missing."""
    made = scene([mesh(file, material="wall", **light(1 - reflectance))],
                 {"wall": {"type": "diffuse", "reflectance": reflectance}}, max_vertices, 3)
    made["camera"] = {"type": "perspective", "position": camera, "target": [0.6, 0.7, 0.9], "fov_deg": fov,
                      "resolution": [1, 1]}
    return made, 1 - reflectance ** (max_vertices - 1)


def lamp_twice():
    made, expected = squares()
    made["shapes"].append(made["shapes"][0])
    return made, expected


def nothing_to_see():
    lamp, sensor = plates()
    made, _ = lamp_above(lamp[::-1], sensor)
    return made, 0.0


# name: (scene, expected)
CASES = {
    "two plates": lamp_above(*plates()),
    "lengths × 10⁹": lamp_above(*plates(size=1e9)),
    "lengths × 10⁻⁹": lamp_above(*plates(size=1e-9)),
    "lengths × 10⁵⁰": lamp_above(*plates(size=1e50)),
    "lengths × 10⁻⁵⁰": lamp_above(*plates(size=1e-50)),
    "10⁶ diameters from the origin": lamp_above(*plates(shift=1e6)),
    "a lamp of 10⁻⁹": lamp_above([(0.5 + 1e-9, 1), (0.5, 1)], plates()[1]),
    "a lamp of 10⁹": lamp_above([(5e8, 1), (-5e8, 1)], plates()[1]),
    "plates 10⁻⁹ apart": lamp_above(*plates(gap=1e-9)),
    "plates one unit in the last place apart": lamp_above([(1.0, 2.0 ** -52), (0.0, 2.0 ** -52)], plates()[1]),
    "a lamp that touches the sensor": lamp_above([(0, 1), (0, 0)], plates()[1]),
    "a lamp in the line of the sensor's end": lamp_above([(3, 1e-9), (2, 1e-9)], plates()[1]),
    "a radiance of 10³⁶": lamp_above(*plates(), radiance=1e36),
    "a radiance of 10⁻³⁶": lamp_above(*plates(), radiance=1e-36),
    "10³⁶ beside 10⁻³⁶": lamp_above(*plates(), radiance=1e36,
                                    others=[segment([(3, 1), (2, 1)], **light(1e-36))]),
    "a light that faces away": nothing_to_see(),
    "reflectance 0.999999, 20 vertices": furnace(0.999999, 20),
    "reflectance 10⁻²⁵": furnace(1e-25, 8),
    "a corridor of mirrors, 200 bounces": mirror_corridor(100, 0.999, 202),
    "glass of index 1": behind_glass(1),
    "glass of index 1 + 10⁻¹²": behind_glass(1 + 1e-12),
    "glass of index 1 - 10⁻¹²": behind_glass(1 - 1e-12),
    "a mirror": beside_mirror({"type": "mirror", "reflectance": 1}),
    "a metal of roughness 10⁻⁵": beside_mirror({"type": "rough_conductor", "roughness": 1e-5, "reflectance": 1}),
    "a metal of roughness 10⁻⁹": beside_mirror({"type": "rough_conductor", "roughness": 1e-9, "reflectance": 1}),
    "two squares": squares(),
    "squares × 10⁹": squares(1e9),
    "squares × 10⁻⁵⁰": squares(1e-50),
    "squares × 10⁵⁰": squares(1e50),
    "squares 10⁶ diameters from the origin": squares(shift=1e6),
    "squares of radiance 10³⁶": squares(radiance=1e36),
    "squares of radiance 10⁻³⁶": squares(radiance=1e-36),
    "a ball × 10⁹": ball_in_ball(1e9),
    "a ball × 10⁵⁰": ball_in_ball(1e50),
    "a ball × 10⁻⁵⁰": ball_in_ball(1e-50),
    "a square lamp that is there twice": lamp_twice(),
    "a square lamp of needles 10⁻⁹ wide": below_needles(),
    "a room of needles 10⁻⁹ wide": room("needles.ply"),
    "a room of 1 002 252 triangles": room("million.ply"),
    "a room, the camera on its wall": room("needles.ply", camera=(0.4, 0.3, 0)),
    "a room, the camera in its corner": room("needles.ply", camera=(0, 0, 0)),
    "a room, a pixel of 10⁻⁹": room("needles.ply", fov=1e-7),
}
