// `wander gallery` of scenes with meshes, which are in files of their own.
#include "tests/support/expect.h"
#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

const fs::path source = WANDER_SOURCE;

using GalleryWithMeshes = CommandLine;

TEST_F(GalleryWithMeshes, WritesThemBesideTheScene) {
  const Outcome written = wander("gallery ring -o mine.json");
  EXPECT_EQ(written.exit_code, 0) << written.err;
  EXPECT_EQ(written.out + written.err, "");
  EXPECT_EQ(contents(folder / "mine.json"), contents(source / "scenes" / "ring.json"));
  EXPECT_EQ(contents(folder / "meshes" / "ring.obj"), contents(source / "scenes/meshes/ring.obj"));
  EXPECT_EQ(entries(), 3u);  // and the box
  EXPECT_EQ(wander("inspect mine.json").exit_code, 0);
  EXPECT_EQ(shell("cd / && \"$WANDER\" inspect '" + folder.string() + "/mine.json'").exit_code, 0);
}

TEST_F(GalleryWithMeshes, SharesThemBetweenScenes) {
  EXPECT_EQ(wander("gallery door-ajar -o door.json").exit_code, 0);
  EXPECT_EQ(wander("gallery bidir-room -o room.json").exit_code, 0);
  EXPECT_EQ(wander("inspect door.json").exit_code, 0);
  EXPECT_EQ(wander("inspect room.json").exit_code, 0);
}

TEST_F(GalleryWithMeshes, ReplacesNoOtherWithoutForce) {
  fs::create_directory(folder / "meshes");
  write("meshes/ring.obj", "mine");
  const Outcome refused = wander("gallery ring -o ring.json");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_HAS(refused.err, "meshes/ring.obj exists; add --force to replace it");
  EXPECT_FALSE(exists("ring.json"));
  EXPECT_EQ(contents(folder / "meshes" / "ring.obj"), "mine");
  EXPECT_EQ(wander("gallery ring -o ring.json --force").exit_code, 0);
  EXPECT_EQ(wander("inspect ring.json").exit_code, 0);
}

TEST_F(GalleryWithMeshes, SaysWhereTheyAreWhenItPrints) {
  const Outcome printed = wander("gallery ring");
  EXPECT_EQ(printed.exit_code, 0);
  EXPECT_EQ(printed.out, contents(source / "scenes" / "ring.json"));
  EXPECT_EQ(printed.err,
            "The scene needs meshes/ring.obj: wander gallery ring -o FILE.json writes it beside "
            "it.\n");
  EXPECT_EQ(wander("gallery ring -q").err, "");
  EXPECT_EQ(wander("gallery slit").err, "");
  EXPECT_EQ(wander("gallery ring -q -o /dev/null").exit_code, 0);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(GalleryWithMeshes, HasThemFromItsScript) {
  const Outcome made =
      shell("'" + (source / "scenes" / "make_meshes").string() + "' made && diff -r made '" +
            (source / "scenes" / "meshes").string() + "'");
  EXPECT_EQ(made.exit_code, 0) << made.out << made.err;
}

}  // namespace
}  // namespace wander::test
