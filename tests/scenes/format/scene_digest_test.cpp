// What tells scenes from others.
#include "scenes/format/scene_digest.h"

#include <gtest/gtest.h>

#include "scenes/format/sha256.h"

namespace wander::test::scene_digest_test {
namespace {

const std::string a(64, 'a'), b(64, 'b');

TEST(SceneDigests, OfATextAloneAreThatOfTheText) { EXPECT_EQ(whole_digest({a, {}}), a); }

TEST(SceneDigests, AreOthersWhereAFileIs) {
  const SceneDigest one{a, {{"x.obj", a}, {"y.png", b}}};
  EXPECT_EQ(whole_digest(one), whole_digest({a, {{"y.png", b}, {"x.obj", a}}}));
  for (const SceneDigest& other :
       {SceneDigest{a, {}}, SceneDigest{b, one.files}, SceneDigest{a, {{"x.obj", a}}},
        SceneDigest{a, {{"x.obj", b}, {"y.png", a}}}, SceneDigest{a, {{"x.obj", a}, {"z.png", b}}}})
    EXPECT_NE(whole_digest(one), whole_digest(other));
}

TEST(SceneDigests, MayBeOfOneSceneWhereARecordDoesNotKnowItsFiles) {
  const SceneDigest one{a, {{"x.obj", a}}};
  EXPECT_TRUE(may_be_the_same(one, one) && may_be_the_same(one, {a, {}}) &&
              may_be_the_same({a, {}}, one));
  EXPECT_FALSE(may_be_the_same(one, {a, {{"x.obj", b}}}) || may_be_the_same(one, {b, {}}));
}

TEST(SceneDigests, SayWhichFilesHaveChanged) {
  const SceneDigest was{a, {{"x.obj", a}, {"y.png", b}}}, is{a, {{"x.obj", a}, {"y.png", a}}};
  EXPECT_TRUE(changed_files(was, was).empty());
  const auto changed = changed_files(was, is);
  ASSERT_EQ(changed.size(), 1u);
  EXPECT_EQ(changed.front(), "y.png (sha256 aaaaaaaaaaaa, which was bbbbbbbbbbbb)");
}

}  // namespace
}  // namespace wander::test::scene_digest_test
