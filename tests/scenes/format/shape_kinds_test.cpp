// The list of shapes and the schema of scene files name the same kinds, with the same keys.
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "core/description.h"
#include "scenes/format/scene_file_schema.h"

namespace wander {
namespace {

using nlohmann::json;
using Names = std::set<std::string>;

json definitions() { return json::parse(scene_schema_text).at("definitions"); }

// Calls visit(kind) for one of each.
template <class Visitor>
void for_each_kind(Visitor&& visit) {
  [&]<class... Kinds>(std::variant<Kinds...>*) {
    (visit(Kinds{}), ...);
  }(static_cast<description::ShapeKind*>(nullptr));
}

// What the kind says itself, and not what every shape may have.
Names keys_of(const json& definition) {
  Names keys;
  for (const auto& [key, value] : definition.at("properties").items()) keys.insert(key);
  for (const char* common : {"type", "material", "light", "sensor", "name", "id", "description"})
    keys.erase(common);
  return keys;
}

TEST(ShapeKinds, AreThoseOfTheSchemaInEachDimension) {
  Names of_plane, of_space;
  for_each_kind([&]<class Kind>(const Kind&) {
    (description::dimension_of<Kind> == 2 ? of_plane : of_space).emplace(Kind::name);
  });
  const auto names_in = [](const char* list) {
    return definitions().at(list).at("properties").at("type").at("enum").get<Names>();
  };
  EXPECT_EQ(of_plane, names_in("shape_2d"));
  EXPECT_EQ(of_space, names_in("shape_3d"));
}

TEST(ShapeKinds, HaveTheKeysOfTheSchema) {
  const json schema = definitions();
  for_each_kind([&]<class Kind>(const Kind&) {
    Names keys;
    std::apply([&](const auto&... field) { (keys.insert(field.key), ...); }, Kind::fields());
    EXPECT_EQ(keys, keys_of(schema.at(std::string(Kind::name)))) << Kind::name;
  });
}

TEST(ShapeKinds, OfSpaceHaveNoOutlineAndThoseOfThePlaneNoFaces) {
  const description::ShapeKind ball = description::Sphere{{0, 0, 0}, 1},
                               circle = description::Circle{{0, 0, 0}, 1};
  EXPECT_THROW(description::outline_of(ball), std::logic_error);
  EXPECT_THROW(description::visit_kind<3>([](const auto&) {}, circle), std::logic_error);
  int faces = 0;
  const auto count = [&](const auto&) { ++faces; };
  description::visit_kind<3>([&](const auto& kind) { kind.for_each_face(count); }, ball);
  EXPECT_EQ(faces, 1);
}

TEST(ShapeKinds, HaveTheFacesOfTheirTriangles) {
  Triangles two;
  two.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  two.corners = {{0, 1, 2}, {0, 3, 1}};
  const description::Mesh mesh{"m.obj", std::make_shared<const Triangles>(two)};
  std::vector<std::array<description::Coordinates, 3>> faces;
  mesh.for_each_face([&](const description::Triangle& face) { faces.push_back(face.points); });
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_EQ(faces[1][1], (description::Coordinates{0, 0, 1}));
}

}  // namespace
}  // namespace wander
