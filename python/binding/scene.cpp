// Scenes: read, checked and told about.
#include "python/binding/scene.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "draw/figure/scene_figure.h"
#include "draw/figure/space_figure.h"
#include "python/binding/bindings.h"
#include "records/scene_curves.h"

namespace wander::python {

namespace nb = nanobind;

namespace {

using Table = nb::typed<nb::dict, nb::str, nb::any>;

BoundScene opened(const std::string& source) { return {open_scene(source), source}; }

BoundScene parsed(const std::string& text, const std::string& source) {
  return {reopen_scene(text, source), source};
}

std::string drawing_of(const BoundScene& scene, double width) {
  const description::Scene& s = scene.document.scene;
  const figure::SceneFigureOptions how{.width = width};
  return s.dimension == 2 ? figure::scene_figure(s, how) : figure::space_figure(s, how);
}

// Of a scene of the plane: a row of numbers for each segment, and for each arc.
Table curves_of(const BoundScene& scene) {
  const SceneCurves curves = scene_curves(scene.document.scene);
  std::vector<std::string> materials;
  for (const std::int32_t material : curves.material)
    materials.push_back(material_types[static_cast<std::size_t>(material)]);
  Table dict;
  dict["kind"] = curves.kind;
  dict["material"] = materials;
  dict["from"] = curves.from;
  dict["to"] = curves.to;
  dict["center"] = curves.center;
  dict["radius"] = curves.radius;
  dict["from_degrees"] = curves.from_degrees;
  dict["to_degrees"] = curves.to_degrees;
  dict["radiance"] = curves.radiance;
  dict["is_sensor"] = curves.is_sensor;
  return dict;
}

}  // namespace

void bind_scene(nb::module_& module) {
  nb::class_<BoundScene>(module, "Scene", "A valid scene.")
      .def_static("open", &opened, nb::arg("source"), "A scene file, or gallery:NAME.")
      .def_static("parse", &parsed, nb::arg("text"), nb::arg("source"),
                  "The text of a scene file that is, or would be, at `source`.")
      .def_ro("source", &BoundScene::source)
      .def_prop_ro("text", [](const BoundScene& s) { return s.document.text; })
      .def_prop_ro("sha256", [](const BoundScene& s) { return s.document.digest.text; })
      .def_prop_ro("files", [](const BoundScene& s) { return s.document.digest.files; })
      .def_prop_ro("name", [](const BoundScene& s) { return s.document.scene.name; })
      .def_prop_ro("dimension", [](const BoundScene& s) { return s.document.scene.dimension; })
      .def_prop_ro("max_vertices",
                   [](const BoundScene& s) { return s.document.scene.max_vertices; })
      .def_prop_ro("warnings",
                   [](const BoundScene& s) { return scene_warnings(s.document, s.source); })
      .def("figure", &drawing_of, nb::arg("width"), "An SVG document, so many points wide.")
      .def("curves", &curves_of, "The geometry of a scene of the plane, as columns.");
}

}  // namespace wander::python
