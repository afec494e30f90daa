// Meshes in files: what OBJ and PLY say becomes triangles, and what they get wrong is told.
#include "scenes/format/mesh_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <string>

#include "tests/support/generator.h"

namespace wander::test {
namespace {

using Corners = std::vector<std::array<std::int32_t, 3>>;
using Points = std::vector<std::array<double, 3>>;

template <class Parse>
std::string fault_of(Parse parse, const std::string& text) {
  try {
    parse(text);
  } catch (const MeshFileError& error) {
    return error.what();
  }
  return "";
}
std::string obj_fault(const std::string& text) {
  return fault_of([](const auto& t) { return parse_obj(t); }, text);
}
std::string ply_fault(const std::string& text) {
  return fault_of([](const auto& t) { return parse_ply(t); }, text);
}

TEST(ObjFiles, HaveCornersAndFaces) {
  const Triangles mesh = parse_obj(
      "# a triangle\nmtllib none.mtl\no thing\nv 0 0 0\nv 1.5 0 -2e-1 1.0\r\n  v\t+0 1 0 0.5 0.5 "
      "1\n"
      "vn 0 0 1\nvt 0 0\ns off\nusemtl red\nf 1 2 3\n");
  EXPECT_EQ(mesh.points, (Points{{0, 0, 0}, {1.5, 0, -0.2}, {0, 1, 0}}));
  EXPECT_EQ(mesh.corners, (Corners{{0, 1, 2}}));
}

// What a Windows editor puts before the text is no part of its first word.
TEST(MeshFiles, MayBeginWithAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF", obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(parse_obj(mark + obj).points, parse_obj(obj).points);
  EXPECT_EQ(parse_obj(mark + obj).corners, parse_obj(obj).corners);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(parse_ply(mark + ply).corners, parse_ply(ply).corners);
  EXPECT_NE(obj_fault(mark + mark + "v 0 0 0\nf 1 1 1\n"), "");
}

TEST(ObjFiles, HaveFansForFacesOfManyCorners) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";
  EXPECT_EQ(parse_obj(square + "f 1 2 3 4 5").corners, (Corners{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  EXPECT_EQ(parse_obj(square + "f 1 2 \\\n 3 \\\r\n4 5").corners,
            (Corners{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}))
      << "a backslash joins lines";
  EXPECT_EQ(parse_obj(square + "f 1 2 3\\").corners, (Corners{{0, 1, 2}}));
  EXPECT_EQ(parse_obj("# of C:\\models\\\n" + square + "f 1 2 3").corners, (Corners{{0, 1, 2}}))
      << "but not a comment";
  EXPECT_EQ(parse_obj(square + "f 4/1/1 2//3 1/2 # so").corners, (Corners{{3, 1, 0}}));
}

TEST(ObjFiles, CountFromTheStartAndBackFromTheLastCornerSoFar) {
  const Triangles mesh =
      parse_obj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -1 1 -2\n");
  EXPECT_EQ(mesh.corners, (Corners{{0, 1, 2}, {0, 1, 2}, {3, 0, 2}}));
}

// As the numbers of a scene file, so that what has the same coordinates is the same point.
TEST(ObjFiles, HaveNumbersToTheLastDigit) {
  const Triangles mesh = parse_obj("v 0.12 548.8123 1e-320\nv 0.1 0.2 0.3\nv 1 2 3\nf 1 2 3");
  EXPECT_EQ(mesh.points[0], (std::array{0.12, 548.8123, 1e-320}));
}

TEST(ObjFiles, HaveNormalsWhereTheyAreWanted) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 2\nvn 0.6 0 0.8\n"
      "f 1//1 2/7/2 4//-1 3\nvn 1 0 0\nf 1//3 2/1 3\n";
  const Triangles mesh = parse_obj(text, MeshNormals::smooth);
  EXPECT_EQ(mesh.normals, (Points{{0, 0, 2}, {0.6, 0, 0.8}, {1, 0, 0}}));
  EXPECT_EQ(mesh.normal_corners, (Corners{{0, 1, 1}, {0, 1, -1}, {2, -1, -1}}));
  EXPECT_EQ(mesh.corners, parse_obj(text).corners);
  EXPECT_TRUE(parse_obj(text).normals.empty());
  const Triangles none = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", MeshNormals::smooth);
  EXPECT_TRUE(none.normals.empty());
  EXPECT_TRUE(none.normal_corners.empty());
}

TEST(ObjFiles, TellTheLineOfAFaultInTheirNormals) {
  const auto fault = [](const std::string& rest) {
    return fault_of([](const auto& t) { return parse_obj(t, MeshNormals::smooth); },
                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n" + rest);
  };
  EXPECT_EQ(fault("f 1//1 2//2 3//1"), "line 5: there is no normal 2; the file has 1");
  EXPECT_EQ(
      fault("f 1//1 2//0 3//1"),
      "line 5: there is no normal 0; normals are counted from 1, or back from the last as -1");
  EXPECT_EQ(fault("vn 1 x 0"), "line 5: x is no number");
  EXPECT_EQ(fault("f 1//1 2//a 3//1"), "line 5: a is no integer");
}

TEST(ObjFiles, TellTheLineOfTheirFault) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(obj_fault(points + "f 1 2 4"), "line 4: there is no corner 4; the file has 3");
  EXPECT_EQ(
      obj_fault(points + "f 1 0 2"),
      "line 4: there is no corner 0; corners are counted from 1, or back from the last as -1");
  EXPECT_EQ(obj_fault("v 0 0 0\nf -1 -1 -2").substr(0, 30), "line 2: there is no corner -2;");
  EXPECT_EQ(obj_fault(points + "f 1 2"), "line 4: a face of 2 corners; a face has 3 or more");
  EXPECT_EQ(obj_fault(points + "f 1 2 x"), "line 4: x is no integer");
  EXPECT_EQ(obj_fault(points + "f 1 2 99999999999999999999"),
            "line 4: 99999999999999999999 is no integer");
  EXPECT_EQ(obj_fault("v 0 0"), "line 1: the end is no number");
  EXPECT_EQ(obj_fault("v 0 0 0,5"), "line 1: 0,5 is no number");
  EXPECT_EQ(obj_fault("v 0 0 nan").substr(0, 26), "line 1: nan is not allowed");
  EXPECT_EQ(obj_fault("v 0 0 1e200").substr(0, 30), "line 1: 1e+200 is not allowed;");
}

const std::string ascii_header = "ply\nformat ascii 1.0\ncomment made by hand\n";
const std::string three_points =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";

TEST(PlyFiles, HaveNormalsWhereTheyAreWanted) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 1\nproperty list "
      "uchar int vertex_indices\nend_header\n0 0 0 0 0 1\n1 0 0 0.5 0 1\n0 1 0 0 0 -3\n3 0 1 2\n";
  const Triangles mesh = parse_ply(text, MeshNormals::smooth);
  EXPECT_EQ(mesh.normals, (Points{{0, 0, 1}, {0.5, 0, 1}, {0, 0, -3}}));
  EXPECT_TRUE(mesh.normal_corners.empty());
  EXPECT_TRUE(parse_ply(text).normals.empty());
}

TEST(PlyFiles, MayBeText) {
  const Triangles mesh = parse_ply(ascii_header +
                                   "element vertex 4\nproperty double x\nproperty float y\n"
                                   "property float nx\nproperty float z\nelement edge 1\n"
                                   "property int a\nelement face 2\n"
                                   "property list uchar int vertex_indices\nproperty uchar red\n"
                                   "end_header\n0 0 nan 0\n0.1 0 7 0\n1 1 7 0.5\n0 1 7 0\n"
                                   "12\n4 0 1 2 3 255\n3 0\n 2 3\n255\n");
  EXPECT_EQ(mesh.points, (Points{{0, 0, 0}, {0.1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}}));
  EXPECT_EQ(mesh.corners, (Corners{{0, 1, 2}, {0, 2, 3}, {0, 2, 3}}));
}

template <class T>
void append(std::string& bytes, T value, std::endian order) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (order != std::endian::native) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string binary(std::endian order) {
  std::string bytes = std::string("ply\nformat binary_") +
                      (order == std::endian::big ? "big" : "little") + "_endian 1.0\n" +
                      "element vertex 3\nproperty float x\nproperty double y\nproperty short z\n" +
                      "property list ushort uint8 tags\n" +
                      "element face 1\nproperty char kind\nproperty list uint int vertex_index\n" +
                      "end_header\n";
  for (int i = 0; i < 3; ++i) {
    append(bytes, 0.5f * static_cast<float>(i), order);
    append(bytes, 0.1 * i, order);
    append(bytes, static_cast<std::int16_t>(-300 * i), order);
    append(bytes, std::uint16_t{2}, order);
    bytes += "ab";
  }
  append(bytes, std::int8_t{-1}, order);
  append(bytes, std::uint32_t{3}, order);
  for (const std::int32_t corner : {2, 0, 1}) append(bytes, corner, order);
  return bytes;
}

TEST(PlyFiles, MayBeBinaryInEitherOrderOfBytes) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const Triangles mesh = parse_ply(binary(order));
    EXPECT_EQ(mesh.points, (Points{{0, 0, 0}, {0.5, 0.1, -300}, {1, 0.2, -600}}));
    EXPECT_EQ(mesh.corners, (Corners{{2, 0, 1}}));
  }
}

TEST(PlyFiles, TellTheirFaults) {
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string start = ascii_header + three_points + faces + "0 0 0 1 0 0 0 1 0 ";
  EXPECT_EQ(ply_fault("solid"), "line 1: this is no PLY file; it begins with \"ply\"");
  EXPECT_EQ(ply_fault("ply\nformat ascii 1.0\n"),
            "line 2: the header has no end; its last line is end_header");
  EXPECT_EQ(ply_fault("ply\nend_header\n"), "line 2: the header names no format");
  EXPECT_EQ(ply_fault("ply\nformat binary 1.0\n").substr(0, 34),
            "line 2: the format binary is not k");
  EXPECT_EQ(ply_fault(ascii_header + "element vertex -1\n"),
            "line 4: -1 elements; their number is >= 0");
  EXPECT_EQ(ply_fault(ascii_header + "element vertex 1\nproperty half x\n").substr(0, 33),
            "line 5: the type half is not know");
  EXPECT_EQ(ply_fault(ascii_header + "property float x\n"), "line 4: a property of no element");
  EXPECT_EQ(ply_fault(ascii_header + three_points + "end_header\n0 0 0 1 0 0 0 1 0"),
            "the file has no element \"face\"; a mesh has vertex and face");
  EXPECT_EQ(ply_fault(ascii_header + "element vertex 1\nproperty float x\n" + faces + "0"),
            "line 8: a vertex has no property y; it needs x, y and z");
  EXPECT_EQ(ply_fault(start + "3 0 1 3"),
            "a face has the corner 3; the file has 3, counted from 0");
  EXPECT_EQ(ply_fault(start + "3 0 1 -1"),
            "a face has the corner -1; the file has 3, counted from 0");
  EXPECT_EQ(ply_fault(start + "2 0 1"), "line 11: a face of 2 corners; a face has 3 or more");
  EXPECT_EQ(ply_fault(start + "3 0 1"), "line 11: the end is no number");
  EXPECT_EQ(ply_fault(start + "3 0 1 0.5"), "line 11: 0.5 is no integer");
  const std::string whole = binary(std::endian::little);
  EXPECT_EQ(ply_fault(whole.substr(0, whole.size() - 1)),
            "the file ends before all of its elements; write it anew");
}

// What a file claims to hold costs nothing before it is there.
TEST(PlyFiles, MayClaimMoreThanThereIs) {
  const std::string header = ascii_header +
                             "element vertex 4000000000000\nproperty float x\nproperty float y\n"
                             "property float z\nelement nothing 9000000000000000000\n"
                             "element face 4000000000000\nproperty list int int vertex_indices\n"
                             "end_header\n";
  EXPECT_EQ(ply_fault(header + "0 0 0"), "line 12: the end is no number");
  std::string list = binary(std::endian::little);
  list.replace(list.size() - 16, 4, "\xFF\xFF\xFF\x7F");
  EXPECT_EQ(ply_fault(list), "a list of 2147483647 values; the file ends before them");
}

// Any bytes are a mesh or a fault, and no more.
TEST(MeshFiles, OfGarbageAreFaultsOrMeshes) {
  Generator g(1);
  const std::string whole = binary(std::endian::big);
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf -1 -2 -3 1\n";
  int faults = 0;
  for (int i = 0; i < 20'000; ++i) {
    const bool is_ply = i % 2 == 0;
    std::string text = is_ply ? whole : obj;
    for (int k = 0; k < 3; ++k)
      text[static_cast<std::size_t>(g.uniform() * static_cast<double>(text.size()))] =
          static_cast<char>(256 * g.uniform());
    faults += !(is_ply ? ply_fault(text) : obj_fault(text)).empty();
  }
  EXPECT_GT(faults, 1000);
}

}  // namespace
}  // namespace wander::test
