"""A scene file of three dimensions as Mitsuba 3 is given it, for what both can say.

Rough materials are left out: Mitsuba's masking is that of separate directions, ours is height-correlated.
"""
import json
import re

import numpy


def read(path):
    """The document of a scene file, whose comments take lines of their own."""
    return json.loads(re.sub(r"(?m)^\s*//.*$", "", path.read_text()))


def colour(value):
    return {"type": "rgb", "value": value if isinstance(value, list) else [value] * 3}


def bsdf(material):
    kind = material["type"]
    if kind == "black":
        return {"type": "diffuse", "reflectance": colour(0)}
    if kind == "diffuse":
        return {"type": "twosided", "inside": {"type": "diffuse", "reflectance": colour(material["reflectance"])}}
    if kind == "mirror":
        inside = {"type": "conductor", "material": "none", "specular_reflectance": colour(material["reflectance"])}
        return {"type": "twosided", "inside": inside}
    if kind == "conductor":
        return {"type": "twosided", "inside": {"type": "conductor", "eta": colour(material["eta"]), "k": colour(material["k"])}}
    if kind == "dielectric":
        return {"type": "dielectric", "int_ior": float(material["ior"]),
                "ext_ior": float(material.get("exterior_ior", 1))}
    raise ValueError(f"Mitsuba has no counterpart of the material {kind}")


def write_faces(path, points, faces):
    lines = ["v " + " ".join(repr(float(c)) for c in point) for point in points]
    lines += ["f " + " ".join(str(corner + 1) for corner in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")
    return {"type": "obj", "filename": str(path), "face_normals": True}


def geometry(shape, scene_folder, file, mitsuba):
    """`file` is a place for what Mitsuba must read."""
    kind = shape["type"]
    if kind == "triangle":
        return write_faces(file, shape["points"], [[0, 1, 2]])
    if kind == "parallelogram":
        origin, a, b = (numpy.array(v, float) for v in (shape["origin"], *shape["edges"]))
        return write_faces(file, [origin, origin + a, origin + a + b, origin + b], [[0, 1, 2], [0, 2, 3]])
    if kind == "sphere":
        return {"type": "sphere", "center": shape["center"], "radius": shape["radius"],
                "flip_normals": shape.get("flip", False)}
    if kind == "mesh":
        path = scene_folder / shape["file"]
        place = numpy.eye(4)
        rows = shape.get("transform", [])
        place[:len(rows)] = rows
        return {"type": path.suffix[1:].lower(), "filename": str(path), "face_normals": shape.get("normals") != "smooth",
                "to_world": mitsuba.ScalarTransform4f(place)}
    raise ValueError(f"Mitsuba has no counterpart of the shape {kind}")


def sensor(camera, mitsuba):
    width, height = camera["resolution"]
    result = {
        "type": "thinlens" if camera.get("aperture_radius") else "perspective",
        "fov": camera["fov_deg"], "fov_axis": "x", "near_clip": 1e-3, "far_clip": 1e4,
        "to_world": mitsuba.ScalarTransform4f().look_at(
            origin=camera["position"], target=camera["target"], up=camera.get("up", [0, 1, 0])),
        "film": {"type": "hdrfilm", "width": width, "height": height, "rfilter": {"type": "box"},
                 "pixel_format": "rgb", "component_format": "float32"},
        "sampler": {"type": "independent"}}
    if camera.get("aperture_radius"):
        result.update(aperture_radius=camera["aperture_radius"], focus_distance=camera["focus_distance"])
    return result


def load(path, folder, mitsuba):
    """The scene of a file; `folder` takes what Mitsuba must read."""
    document = read(path)
    depth = document.get("max_vertices", 8) - 1
    scene = {"type": "scene", "integrator": {"type": "path", "max_depth": depth, "rr_depth": depth + 1},
             "sensor": sensor(document["camera"], mitsuba)}
    black = {"type": "black"}
    for number, shape in enumerate(document["shapes"]):
        converted = geometry(shape, path.parent, folder / f"shape{number}.obj", mitsuba)
        converted["bsdf"] = bsdf(document["materials"][shape["material"]] if "material" in shape else black)
        if "light" in shape:
            converted["emitter"] = {"type": "area", "radiance": colour(shape["light"]["radiance"])}
        scene[f"shape{number}"] = converted
    return mitsuba.load_dict(scene)
