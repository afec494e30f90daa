// What cpack makes: a package for Debian, and a tarball for anywhere.
#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using Packages = CommandLine;

TEST_F(Packages, HoldTheProgramForDebianAndForAnywhere) {
  const Outcome made =
      shell("cpack --config '" WANDER_BUILD "/CPackConfig.cmake' -B \"$PWD/packages\"");
  ASSERT_EQ(made.exit_code, 0) << made.out << made.err;
  const std::string debian = "packages/wanderlight_" + version() + "_*.deb";
  EXPECT_EQ(shell("dpkg-deb --field " + debian + " Version").out, version() + "\n");
  const std::string needs = shell("dpkg-deb --field " + debian + " Depends").out;
  for (const char* library : {"libnetcdf", "libopenexr", "libtbb", "librsvg"})
    EXPECT_NE(needs.find(library), std::string::npos) << library;
  EXPECT_NE(shell("dpkg-deb --contents " + debian).out.find(" ./usr/bin/wander\n"),
            std::string::npos);
  const std::string slit = shell("tar xzf packages/wanderlight-" + version() +
                                 "-*.tar.gz --strip-components=1 && bin/wander gallery slit")
                               .out;
  EXPECT_EQ(slit, contents(folder / "share/wanderlight/scenes/slit.json"));
}

}  // namespace
}  // namespace wander::test
