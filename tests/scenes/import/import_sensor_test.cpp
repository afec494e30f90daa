// Cameras and films of Mitsuba, by the rays through the corners of the picture.
#include <cmath>

#include "tests/scenes/import/import_folder.h"

namespace wander::test {
namespace {

using Point = std::array<double, 3>;

class ImportedCameras : public ImportFolder {
 protected:
  static std::string seen_by(const std::string& sensor) {
    return "<scene version='3.0.0'><shape type='sphere'><emitter type='area'/></shape>" + sensor +
           "</scene>";
  }
  static std::string film(int width, int height, const std::string& more = "") {
    return "<film type='hdrfilm'><integer name='width' value='" + std::to_string(width) +
           "'/><integer name='height' value='" + std::to_string(height) +
           "'/><rfilter type='box'/>" + more + "</film>";
  }
  static std::string pinhole(const std::string& properties) {
    return seen_by("<sensor type='perspective'>" + properties + film(200, 100) + "</sensor>");
  }
  Json camera(const std::string& properties) const { return exact(pinhole(properties))["camera"]; }

  // The direction through a place of the picture, (0, 0) top left, by the formula of this format.
  static Point direction(const Json& camera, double u, double v) {
    const auto position = camera["position"].get<Point>(), target = camera["target"].get<Point>(),
               up = camera["up"].get<Point>();
    const auto unit = [](Point p) {
      const double length = std::hypot(p[0], p[1], p[2]);
      return Point{p[0] / length, p[1] / length, p[2] / length};
    };
    const auto cross = [](const Point& a, const Point& b) {
      return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const Point ahead =
        unit({target[0] - position[0], target[1] - position[1], target[2] - position[2]});
    const Point right = unit(cross(ahead, up)), above = cross(right, ahead);
    const auto size = camera["resolution"].get<std::array<double, 2>>();
    const double half = std::tan(camera["fov_deg"].get<double>() * std::acos(-1.0) / 360);
    const double x = (2 * u - 1) * half, y = (1 - 2 * v) * half * size[1] / size[0];
    Point d;
    for (std::size_t i = 0; i < 3; ++i) d[i] = ahead[i] + x * right[i] + y * above[i];
    return unit(d);
  }
  static void expect_directions(const Json& camera, Point top_left, Point top_right) {
    expect_near(direction(camera, 0, 0), {top_left[0], top_left[1], top_left[2]}, 2e-5);
    expect_near(direction(camera, 1, 0), {top_right[0], top_right[1], top_right[2]}, 2e-5);
  }
};

// The rays are those that sample_ray of Mitsuba 3.9 gives.
TEST_F(ImportedCameras, SeeWhatMitsubaSees) {
  const std::string fov = "<float name='fov' value='60'/>";
  expect_directions(camera(fov), {0.48507, 0.24254, 0.84017}, {-0.48507, 0.24254, 0.84017});
  expect_directions(camera(fov + "<transform name='to_world'><lookat origin='1,2,3' target='1,2,0' "
                                 "up='0,1,0'/></transform>"),
                    {-0.48507, 0.24254, -0.84017}, {0.48507, 0.24254, -0.84017});
}

TEST_F(ImportedCameras, HaveTheirAngleAlongTheAxisThatIsNamed) {
  const auto axis = [](const char* name) {
    return std::string("<float name='fov' value='60'/><string name='fov_axis' value='") + name +
           "'/>";
  };
  for (const char* x : {"x", "larger"})
    expect_directions(camera(axis(x)), {0.48507, 0.24254, 0.84017}, {-0.48507, 0.24254, 0.84017});
  for (const char* y : {"y", "smaller"})
    expect_directions(camera(axis(y)), {0.70711, 0.35355, 0.61237}, {-0.70711, 0.35355, 0.61237});
  expect_directions(camera(axis("diagonal")), {0.44721, 0.22361, 0.86603},
                    {-0.44721, 0.22361, 0.86603});
  for (const char* length : {"", "<string name='focal_length' value='50mm'/>"})
    expect_directions(camera(length), {0.35517, 0.17758, 0.91778}, {-0.35517, 0.17758, 0.91778});
  EXPECT_EQ(camera("<float name='fov' value='39.3077'/>")["fov_deg"], 39.3077);
}

TEST_F(ImportedCameras, OfVersion06HaveTheirOldNames) {
  const Json old = camera(
      "<float name='fov' value='60'/><string name='fovAxis' value='y'/>"
      "<transform name='toWorld'><lookAt origin='1,2,3' target='1,2,0' "
      "up='0,1,0'/></transform><float name='nearClip' value='0.1'/>");
  expect_directions(old, {-0.70711, 0.35355, -0.61237}, {0.70711, 0.35355, -0.61237});
}

TEST_F(ImportedCameras, WithALensFocusWhereMitsubaDoes) {
  const auto lens = [&](const std::string& properties) {
    return exact(seen_by("<sensor type='thinlens'><float name='fov' value='60'/>" + properties +
                         film(20, 10) + "</sensor>"))["camera"];
  };
  const std::string radius = "<float name='aperture_radius' value='0.1'/>";
  EXPECT_EQ(lens(radius + "<float name='focus_distance' value='3'/>")["aperture_radius"], 0.1);
  EXPECT_EQ(lens(radius + "<float name='focusDistance' value='3'/>")["focus_distance"], 3.0);
  EXPECT_EQ(lens(radius)["focus_distance"], 10000.0);  // the far clip
}

TEST_F(ImportedCameras, HaveTheSizeOfTheirFilm) {
  EXPECT_EQ(camera("")["resolution"], Json::parse("[200, 100]"));
  const ImportedScene usual = scene(seen_by("<sensor type='perspective'/>"));
  EXPECT_EQ(Json::parse(usual.text)["camera"]["resolution"], Json::parse("[768, 576]"));
}

TEST_F(ImportedCameras, WithoutAFilterSayThatTheirsIsABox) {
  const ImportedScene imported =
      scene(seen_by("<sensor type='perspective'><film type='hdrfilm'/></sensor>"));
  ASSERT_EQ(imported.approximations.size(), 1u);
  EXPECT_SAYS(imported.approximations[0].what, "pixels are boxes");
}

TEST_F(ImportedCameras, OfWhichPartsCannotBeSaidAreApproximate) {
  const auto with = [&](const std::string& film_part, const std::string& properties = "") {
    return seen_by("<sensor type='perspective'>" + properties + film(20, 10, film_part) +
                   "</sensor>");
  };
  approximate(with("<integer name='crop_width' value='5'/>"), "a part of a film");
  for (const char* offset : {"1", "0"}) {
    const auto part = [&](const char* name, const char* value) {
      return std::string("<integer name='crop_") + name + "' value='" + value + "'/>";
    };
    approximate(with(part("width", offset == std::string("1") ? "5" : "20") + part("height", "9") +
                     part("offset_x", offset) + part("offset_y", "1")),
                "a part of a film");
  }
  exact(with("<integer name='crop_width' value='20'/><integer name='crop_offset_x' value='0'/>"));
  approximate(with("", "<float name='principal_point_offset_x' value='0.1'/>"), "that is shifted");
  approximate(with("", "<transform name='to_world'><scale x='-1'/></transform>"), "mirrors");
  approximate(seen_by("<sensor type='perspective'><film type='hdrfilm'><rfilter type='gaussian'/>"
                      "</film></sensor>"),
              "the pixel filter \"gaussian\"");
  approximate(
      seen_by("<sensor type='perspective'>" + film(2, 2) + "</sensor><sensor type='perspective'/>"),
      "another sensor");
}

TEST_F(ImportedCameras, ThatCannotBeAreRefused) {
  EXPECT_SAYS(refused(seen_by("")), "the scene has no sensor");
  EXPECT_SAYS(refused(seen_by("<sensor type='fisheye'/>")), "known are perspective and thinlens");
  EXPECT_SAYS(refused(pinhole("<transform name='to_world'><scale value='2'/></transform>")),
              "not scaled");
  EXPECT_SAYS(refused(pinhole("<float name='fov' value='180'/>")), "< 180");
  EXPECT_SAYS(refused(pinhole("<string name='fov_axis' value='z'/><float name='fov' value='1'/>")),
              "fov_axis is x, y");
  EXPECT_SAYS(refused(pinhole("<string name='focal_length' value='50in'/>")), "of mm");
  EXPECT_SAYS(refused(seen_by("<sensor type='perspective'>" + film(0, 10) + "</sensor>")), "> 0");
  EXPECT_SAYS(refused(seen_by("<sensor type='thinlens'>" + film(2, 2) + "</sensor>")),
              "has an aperture_radius");
}

// ---- the lengths of paths

TEST_F(ImportedCameras, SeePathsAsLongAsTheIntegratorSays) {
  const auto vertices = [&](const std::string& integrator) {
    return Json::parse(scene(scene_of(integrator)).text).value("max_vertices", 0);
  };
  const auto path = [](const char* depth) {
    return std::string("<integrator type='path'><integer name='max_depth' value='") + depth +
           "'/></integrator>";
  };
  EXPECT_EQ(vertices(path("1")), 2);
  EXPECT_EQ(vertices(path("2")), 3);
  EXPECT_EQ(vertices(path("7")), 8);
  EXPECT_EQ(
      vertices(
          "<integrator type='bdpt'><integer name='maxDepth' value='5'/><integer name='rrDepth' "
          "value='3'/></integrator>"),
      6);
  EXPECT_EQ(vertices("<integrator type='direct'/>"), 3);
  EXPECT_EQ(vertices(""), 0);
  for (const std::string& unlimited : {path("-1"), std::string("<integrator type='path'/>")}) {
    EXPECT_EQ(vertices(unlimited), 64);
    EXPECT_SAYS(scene(scene_of(unlimited)).approximations.at(0).what, "at most 64 vertices");
  }
  EXPECT_SAYS(refused(scene_of(path("0"))), "a max_depth is > 0");
  approximate(scene_of("<integrator type='path'><integer name='max_depth' value='3'/><boolean "
                       "name='hide_emitters' value='true'/></integrator>"),
              "hidden emitters");
}

}  // namespace
}  // namespace wander::test
