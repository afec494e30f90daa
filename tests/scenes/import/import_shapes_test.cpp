// The shapes of Mitsuba: where they are, and where their fronts are.
#include <array>
#include <cmath>
#include <numbers>

#include "scenes/format/scene_file.h"
#include "tests/scenes/import/import_folder.h"

namespace wander::test {
namespace {

using Point = std::array<double, 3>;

constexpr const char* mirrored = "<transform name='to_world'><scale x='-1'/></transform>";
constexpr const char* turned = "<boolean name='flip_normals' value='true'/>";

class ImportedShapesOf : public ImportFolder {
 protected:
  // Glass, so that inside and outside matter and the back is no matter.
  static std::string shape(const std::string& type, const std::string& properties) {
    return scene_of("<shape type='" + type + "'>" + properties +
                    "<bsdf type='dielectric'/></shape>");
  }
  Json first(const std::string& type, const std::string& properties) const {
    return exact(shape(type, properties))["shapes"][0];
  }
  // The triangles of the first shape as the program reads the scene.
  Triangles mesh(const std::string& type, const std::string& properties,
                 Fidelity fidelity = Fidelity::exact) const {
    const ImportedScene imported = scene(shape(type, properties), fidelity);
    const SceneDocument read = parse_scene(imported.text, "scene", files_in(place_));
    return *std::get<description::Mesh>(read.scene.shapes[0].kind).triangles;
  }
};

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Measures {
  double area = 0, volume = 0;  // negative where normals point inwards
  Point normal{};               // summed
};

Measures measures(const Triangles& mesh) {
  Measures sum;
  for (const auto& corners : mesh.corners) {
    const auto at = [&](std::size_t i) {
      return mesh.points[static_cast<std::size_t>(corners[i])];
    };
    const Point n = cross(at(1) - at(0), at(2) - at(0));
    sum.area += std::sqrt(dot(n, n)) / 2;
    sum.volume += dot(at(0), n) / 6;
    for (std::size_t axis = 0; axis < 3; ++axis) sum.normal[axis] += n[axis] / 2;
  }
  return sum;
}

TEST_F(ImportedShapesOf, RectanglesAreParallelograms) {
  EXPECT_EQ(first("rectangle",
                  "<transform name='to_world'><scale x='2'/><translate value='1 2 3'/>"
                  "</transform>"),
            Json::parse(R"({"type": "parallelogram", "origin": [-1.0, 1.0, 3.0],
                            "edges": [[4.0, 0.0, 0.0], [0.0, 2.0, 0.0]], "material": "dielectric"})"));
}

// The normal stays on the side of the transformed normal (Mitsuba 3.9: +z for both).
TEST_F(ImportedShapesOf, RectanglesKeepTheirFront) {
  const auto normal = [&](const std::string& properties) {
    const Json edges = first("rectangle", properties)["edges"];
    return cross(edges[0].get<Point>(), edges[1].get<Point>());
  };
  EXPECT_EQ(normal(""), (Point{0, 0, 4}));
  EXPECT_EQ(normal(mirrored), (Point{0, 0, 4}));
  EXPECT_EQ(normal(turned), (Point{0, 0, -4}));
  EXPECT_EQ(normal(std::string(mirrored) + turned), (Point{0, 0, -4}));
  EXPECT_EQ(normal("<transform name='to_world'><rotate x='1' angle='90'/></transform>"),
            (Point{0, -4, 0}));
}

TEST_F(ImportedShapesOf, SpheresAreSpheres) {
  EXPECT_EQ(first("sphere", ""), Json::parse(R"({"type": "sphere", "center": [0.0, 0.0, 0.0],
      "radius": 1.0, "material": "dielectric"})"));
  const Json moved = first("sphere",
                           "<point name='center' x='1' y='2' z='3'/><float name='radius' "
                           "value='2'/><transform name='to_world'><rotate y='1' angle='30'/>"
                           "<rotate y='1' angle='-30'/><scale value='3'/><translate x='1'/>"
                           "</transform>");
  expect_near(moved["center"], {4, 6, 9}, 1e-12);
  EXPECT_NEAR(moved["radius"].get<double>(), 6, 1e-12);
  EXPECT_FALSE(moved.contains("flip"));
}

// Mitsuba turns a sphere inside out in a mirror.
TEST_F(ImportedShapesOf, SpheresAreTurnedByMirrorsAndOnDemand) {
  EXPECT_EQ(first("sphere", mirrored)["flip"], true);
  EXPECT_EQ(first("sphere", turned)["flip"], true);
  EXPECT_FALSE(first("sphere", std::string(mirrored) + turned).contains("flip"));
}

TEST_F(ImportedShapesOf, CubesAreTheirTwelveTriangles) {
  const auto size = [&](const std::string& properties) {
    return measures(mesh("cube", properties));
  };
  EXPECT_EQ(mesh("cube", "").corners.size(), 12u);
  EXPECT_DOUBLE_EQ(size("").volume, 8);
  EXPECT_DOUBLE_EQ(size("").area, 24);
  EXPECT_DOUBLE_EQ(size(mirrored).volume, 8);
  EXPECT_DOUBLE_EQ(size(turned).volume, -8);
  EXPECT_NEAR(
      size("<transform name='to_world'><scale x='2'/><rotate z='1' angle='20'/></transform>")
          .volume,
      16, 1e-12);
}

TEST_F(ImportedShapesOf, RoundOnesAreMeshesOfTheirArea) {
  for (const char* type : {"disk", "cylinder"}) approximate(shape(type, ""), "of 128 sides");
  approximate(shape("sphere", "<transform name='to_world'><scale z='2'/></transform>"),
              "an ellipsoid");
  const double pi = std::numbers::pi;
  const auto nearly = [&](const char* type, const std::string& properties) {
    return measures(mesh(type, properties, Fidelity::approximate));
  };
  EXPECT_NEAR(nearly("disk", "<transform name='to_world'><scale value='3'/></transform>").area,
              9 * pi, 1e-9);
  EXPECT_NEAR(nearly("disk", "").normal[2], pi, 1e-9);
  EXPECT_NEAR(nearly("disk", mirrored).normal[2], pi, 1e-9);
  EXPECT_NEAR(nearly("disk", turned).normal[2], -pi, 1e-9);
  const std::string rod =
      "<point name='p0' x='1' y='2' z='3'/><point name='p1' x='1' y='6' z='6'/>"
      "<float name='radius' value='0.5'/>";
  EXPECT_NEAR(nearly("cylinder", rod).area, 2 * pi * 0.5 * 5, 1e-9);
  EXPECT_GT(nearly("cylinder", "").volume, 2);  // without caps, about 2/3 of it from the origin
  EXPECT_LT(nearly("cylinder", turned).volume, -2);
  EXPECT_GT(nearly("cylinder", mirrored).volume, 2);
  EXPECT_NEAR(nearly("sphere", "<transform name='to_world'><scale z='2'/></transform>").volume,
              8 * pi / 3, 0.02);
}

TEST_F(ImportedShapesOf, CylindersEndWhereTheyAreSaidTo) {
  const Triangles rod = mesh("cylinder",
                             "<point name='p0' x='1' y='2' z='3'/><point name='p1' x='1' "
                             "y='6' z='6'/>",
                             Fidelity::approximate);
  double low = 1e9, high = -1e9;  // along the axis (0, 0.8, 0.6), from p0
  for (const Point& p : rod.points) {
    const double along = dot(p - Point{1, 2, 3}, {0, 0.8, 0.6});
    low = std::min(low, along);
    high = std::max(high, along);
  }
  EXPECT_NEAR(low, 0, 1e-12);
  EXPECT_NEAR(high, 5, 1e-12);
}

// ---- meshes of files

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* roof = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 4 3\n";

TEST_F(ImportedShapesOf, MeshesAreCopiedWithTheirTransform) {
  write("in/a b.obj", triangle);
  const std::string file = "<string name='filename' value='in/a b.obj'/>";
  const Json shape =
      first("obj", file + "<transform name='to_world'><translate x='2'/></transform>");
  EXPECT_EQ(shape["file"], "scene-meshes/a_b.obj");
  EXPECT_EQ(shape["transform"],
            Json::parse("[[1.0,0.0,0.0,2.0],[0.0,1.0,0.0,0.0],[0.0,0.0,1.0,0.0]]"));
  EXPECT_FALSE(first("obj", file).contains("transform"));
  std::ifstream copy(place_ / "scene-meshes/a_b.obj");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(copy), {}), triangle);
}

TEST_F(ImportedShapesOf, EqualMeshesAreCopiedOnceAndOthersGetOtherNames) {
  write("a/m.obj", triangle);
  write("b/m.obj", triangle);
  write("c/m.obj", roof);
  const auto shape = [](const char* file) {
    return std::string("<shape type='obj'><string name='filename' value='") + file +
           "'/><boolean name='face_normals' value='true'/><bsdf type='dielectric'/></shape>";
  };
  const ImportedScene imported =
      scene(scene_of(shape("a/m.obj") + shape("b/m.obj") + shape("c/m.obj")));
  ASSERT_EQ(imported.files.size(), 2u);
  EXPECT_EQ(imported.files[0].path, "scene-meshes/m.obj");
  EXPECT_EQ(imported.files[1].path, "scene-meshes/m_2.obj");
}

// As Mitsuba 3.9 has the shading normals: flipped by a mirror unless the file has normals.
TEST_F(ImportedShapesOf, MeshesHaveTheirFrontWhereTheirNormalsPoint) {
  write("plain.obj", triangle);
  write("up.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nf 1//1 2//1 3//1\n");
  write("down.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//-1 2//1 3//1\n");
  write("down.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0 -1\n1 0 0 0 0 -1\n0 1 0 0 0 -1\n3 0 1 2\n");
  const auto up = [&](const std::string& file, const std::string& properties) {
    return measures(mesh(file.substr(file.size() - 3),
                         "<string name='filename' value='" + file + "'/>" + properties))
               .normal[2] > 0;
  };
  const std::string flat = "<boolean name='face_normals' value='true'/>";
  EXPECT_TRUE(up("plain.obj", ""));
  EXPECT_FALSE(up("plain.obj", turned));
  EXPECT_FALSE(up("plain.obj", mirrored));
  EXPECT_TRUE(up("plain.obj", std::string(mirrored) + turned));
  EXPECT_TRUE(up("up.obj", ""));
  EXPECT_TRUE(up("up.obj", mirrored));
  EXPECT_FALSE(up("up.obj", turned));
  EXPECT_FALSE(up("down.obj", ""));
  EXPECT_FALSE(up("down.obj", mirrored));
  EXPECT_FALSE(up("down.ply", ""));
  EXPECT_TRUE(up("down.obj", flat));
  EXPECT_TRUE(up("down.ply", flat));
  EXPECT_FALSE(up("down.ply", flat + mirrored));
}

TEST_F(ImportedShapesOf, MeshesThatMitsubaSmoothsAreSmooth) {
  write("roof.obj", roof);
  write("creased.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvn 0 0 1\nvn -1 -1 1\nf 1//1 2//1 3//1\nf 2//2 4//2 "
        "3//2\n");
  write("bent.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0.1 1\nf 1//1 2//1 3//1\n");
  const auto file = [&](const char* name) {
    return shape("obj", std::string("<string name='filename' value='") + name + "'/>");
  };
  const auto shape_of = [&](const char* name) { return exact(file(name))["shapes"][0]; };
  EXPECT_EQ(shape_of("bent.obj")["normals"], "smooth");
  EXPECT_EQ(shape_of("bent.obj")["file"], "scene-meshes/bent.obj");
  EXPECT_EQ(shape_of("roof.obj")["normals"], "smooth");
  EXPECT_EQ(shape_of("roof.obj")["file"], "scene-meshes/roof_smooth.ply");
  EXPECT_FALSE(shape_of("creased.obj").contains("normals"));
  EXPECT_FALSE(exact(shape("obj",
                           "<string name='filename' value='roof.obj'/><boolean name='faceNormals' "
                           "value='true'/>"))["shapes"][0]
                   .contains("normals"));
}

// As Mitsuba 3.9 computes them: weighted by angles in the world, parted where texture coordinates are.
TEST_F(ImportedShapesOf, MeshesWithoutNormalsHaveThoseThatMitsubaComputes) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\n";
  write("bend.obj", points + "f 1 2 3\nf 1 4 2\n");
  write("seam.obj", points + "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 4/1 2/1\n");
  const auto normals = [&](const char* name, const char* more, const Point& at) {
    const Triangles read =
        mesh("obj", std::string("<string name='filename' value='") + name + "'/>" + more);
    std::vector<Point> found;
    for (std::size_t i = 0; i < read.points.size(); ++i)
      if (read.points[i] == at) found.push_back(read.normals[i]);
    return found;
  };
  const auto expect_normal = [](const Point& found, const Point& expected) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-6);
  };
  const auto bend = normals("bend.obj", "", {1, 0, 0});
  ASSERT_EQ(bend.size(), 1u);
  expect_normal(bend[0], {0, 0.8156185, 0.57859});
  ASSERT_EQ(normals("bend.obj", "", {0, 0, 0}).size(), 1u);
  const auto seam = normals("seam.obj", "", {0, 0, 0});
  ASSERT_EQ(seam.size(), 2u);
  expect_normal(seam[0], {0, 0, 1});
  expect_normal(seam[1], {0, 1, 0});
  // Stretched to (1, 0, 0), (0, 2, 0) and (0, 0, 2): both angles are the same.
  const auto even =
      normals("bend.obj", "<transform name='to_world'><scale y='2'/></transform>", {1, 0, 0});
  expect_normal(even[0], {0, std::sqrt(0.5), std::sqrt(0.5)});
}

TEST_F(ImportedShapesOf, PartsOfAFileAreToldToBeAllOfIt) {
  write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no a\nf 1 2 3\no b\nf 1 2 4\n");
  const auto mesh = [](const std::string& member) {
    return scene_of("<shape type='obj'><string name='filename' value='two.obj'/>" + member +
                    "</shape>");
  };
  approximate(mesh("<integer name='shapeIndex' value='1'/>"), "one mesh of several");
  approximate(mesh("<float name='maxSmoothAngle' value='30'/>"), "normals that end at sharp edges");
}

TEST_F(ImportedShapesOf, LampsShineFromTheirFront) {
  const Json lamp =
      exact(scene_of("<shape type='cube' id='lamp 2'><emitter type='area'><rgb "
                     "name='radiance' value='1,2,3'/></emitter></shape>"))["shapes"][0];
  EXPECT_EQ(lamp["light"], Json::parse(R"({"radiance": [1.0, 2.0, 3.0]})"));
  EXPECT_EQ(lamp["name"], "lamp 2");
  EXPECT_FALSE(
      exact(scene_of("<shape type='cube'><emitter type='area'><float name='radiance' "
                     "value='0'/></emitter></shape>"))["shapes"][0]
          .contains("light"));
}

// Mitsuba 3.9.1 shows the same picture of either.
TEST_F(ImportedShapesOf, EmittersThatAreReferredToAreThoseOfTheShape) {
  const std::string
      emitter = "<emitter type='area' id='e'><rgb name='radiance' value='1,2,3'/></emitter>",
      shape = "<shape type='sphere'><ref id='e'/></shape>";
  for (const std::string& scene : {emitter + shape, shape + emitter})
    EXPECT_EQ(exact(scene_of(scene))["shapes"][0]["light"]["radiance"], Json({1, 2, 3}));
}

TEST_F(ImportedShapesOf, EmittersWithoutShapeAreLeftOut) {
  for (const char* type : {"constant", "envmap", "point", "spot", "directional"})
    approximate(scene_of(std::string("<emitter type='") + type + "'/>"), "the emitter \"");
  approximate(scene_of("<emitter type='area' id='of nobody'/>"), "the emitter \"area\"");
}

TEST_F(ImportedShapesOf, ThatCannotBeAreRefused) {
  write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  const auto said_of = [&](const std::string& shape) { return refused(scene_of(shape)); };
  EXPECT_SAYS(said_of("<shape type='cub'/>"), "did you mean \"cube\"?");
  EXPECT_SAYS(said_of("<shape type='obj'><string name='filename' value='bad.obj'/></shape>"),
              "bad.obj: line 2: there is no corner 3");
  EXPECT_SAYS(said_of("<shape type='ply'><string name='filename' value='none.ply'/></shape>"),
              "there is no file none.ply");
  EXPECT_SAYS(said_of("<shape type='obj'/>"), "there is no file without a name");
  EXPECT_SAYS(said_of("<shape type='sphere'><float name='radius' value='-1'/></shape>"), "> 0");
  EXPECT_SAYS(said_of("<shape type='sphere'><float name='radius' value='wide'/></shape>"),
              "finite number");
  EXPECT_SAYS(
      said_of("<shape type='sphere'><transform name='to_world'><matrix value='1 0 0 0 1 0 0 0 "
              "0'/></transform></shape>"),
      "flattens space");
  EXPECT_SAYS(said_of("<shape type='sphere'><emitter type='point'/></shape>"), "known is area");
  EXPECT_SAYS(said_of("<shape type='sphere'><emitter type='area'/><emitter type='area'/></shape>"),
              "one emitter");
}

TEST_F(ImportedShapesOf, WithoutExtentAreAskedForTheRestAllTheSame) {
  for (const char* transform : {"<scale x='0'/>", "<matrix value='1 0 0 0 1 0 0 0 0'/>"}) {
    const std::string words =
        refused(scene_of(std::string("<shape type='obj'><transform name='to_world'>") + transform +
                         "</transform><string name='filename' value='none.obj'/>"
                         "<bsdf type='diffuse'/><emitter type='area'/></shape>"));
    EXPECT_SAYS(words, "there is no file none.obj");
    EXPECT_EQ(std::ranges::count(words, '\n'), 1) << words;
  }
}

// Faults that only the reader of scene files finds are told at the place of their cause.
TEST_F(ImportedShapesOf, ThatMakeNoValidSceneAreToldAtTheirPlace) {
  const auto found = faults(
      "<scene version='3.0.0'>\n<shape type='sphere'><float name='radius' "
      "value='1e-160'/></shape>\n" +
      lamp_and_camera + "</scene>");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].line, 2);
  EXPECT_EQ(found[0].path, "/scene/shape[1]");
  EXPECT_SAYS(found[0].what, "/shapes/0/radius: shorter than 1e-60");
}

}  // namespace
}  // namespace wander::test
