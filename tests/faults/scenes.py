"""The small scenes on which faults are tried: of the plane, of space, of glass, and one of Mitsuba's."""

import json


def scene(dimension, shapes, materials, **members):
    return {
        "format": "wanderlight-scene/1",
        "dimension": dimension,
        "max_vertices": 4,
        "materials": materials,
        "shapes": shapes,
        **members,
    }


WALL = {"wall": {"type": "diffuse", "reflectance": 0.5}}
WALLS = {"type": "polyline", "points": [[0, 0], [2, 0], [2, 1], [0, 1]], "closed": True, "material": "wall"}
LAMP = {"type": "segment", "from": [1.5, 0.9], "to": [0.5, 0.9], "light": {"radiance": 5}}
SENSOR = {"type": "segment", "from": [0.5, 0.1], "to": [1.5, 0.1], "sensor": {"bins": 8}}

PLANE = scene(2, [WALLS, LAMP, SENSOR], WALL, name="box")
GLASS = scene(
    2,
    [WALLS, LAMP, SENSOR, {"type": "circle", "center": [1, 0.5], "radius": 0.2, "material": "glass"}],
    {**WALL, "glass": {"type": "dielectric", "ior": 1.5}},
    name="glass",
)
SPACE = scene(
    3,
    [
        {"type": "parallelogram", "origin": [-1, -1, -1], "edges": [[2, 0, 0], [0, 2, 0]], "material": "wall"},
        {"type": "sphere", "center": [0, 0, 0], "radius": 0.4, "material": "wall"},
        {
            "type": "parallelogram",
            "origin": [-0.5, -0.5, 2],
            "edges": [[0, 1, 0], [1, 0, 0]],
            "light": {"radiance": [3, 2, 1]},
        },
    ],
    {"wall": {"type": "diffuse", "reflectance": [0.5, 0.4, 0.3]}},
    name="ball",
    camera={
        "type": "perspective",
        "position": [0, -3, 1],
        "target": [0, 0, 0],
        "up": [0, 0, 1],
        "fov_deg": 50,
        "resolution": [10, 6],
    },
)
MITSUBA = """<scene version="3.0.0">
  <integrator type="path"><integer name="max_depth" value="3"/></integrator>
  <shape type="cube"><emitter type="area"/></shape>
  <sensor type="perspective">
    <transform name="to_world"><lookat origin="0,0,5" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="6"/><rfilter type="box"/></film>
  </sensor>
</scene>
"""
FILES = {
    "plane.json": json.dumps(PLANE),
    "glass.json": json.dumps(GLASS),
    "space.json": json.dumps(SPACE),
    "cube.xml": MITSUBA,
}
