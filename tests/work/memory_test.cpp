// How much memory there is, read from files made up for it.
#include "work/memory.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <fstream>

namespace wander::test {
namespace {

namespace fs = std::filesystem;

class Memory : public ::testing::Test {
 protected:
  Memory() {
    std::string name = (fs::temp_directory_path() / "wander-memory-XXXXXX").string();
    root = mkdtemp(name.data());
  }
  ~Memory() override { fs::remove_all(root); }

  void write(const fs::path& path, const std::string& text) const {
    fs::create_directories((root / path).parent_path());
    std::ofstream(root / path) << text;
  }
  double bytes() const { return available_memory(root).bytes; }

  fs::path root;
};

TEST_F(Memory, IsNotBoundedWhereNothingIsKnown) { EXPECT_TRUE(std::isinf(bytes())); }

TEST_F(Memory, IsWhatTheMachineHasFree) {
  write("proc/meminfo", "MemTotal:       8000 kB\nMemFree: 1 kB\nMemAvailable:   3000 kB\n");
  EXPECT_EQ(bytes(), 3000.0 * 1024);
  EXPECT_EQ(available_memory(root).word, "the machine");
}

TEST_F(Memory, IsWhatTheTightestControlGroupLeaves) {
  write("proc/meminfo", "MemAvailable:   3000 kB\n");
  write("proc/self/cgroup", "0::/user/jobs/job7\n");
  write("sys/fs/cgroup/user/memory.max", "max\n");
  write("sys/fs/cgroup/user/memory.current", "5000\n");
  write("sys/fs/cgroup/user/jobs/memory.max", "100000\n");
  write("sys/fs/cgroup/user/jobs/memory.current", "30000\n");
  write("sys/fs/cgroup/user/jobs/memory.stat", "anon 20000\ninactive_file 7000\n");
  write("sys/fs/cgroup/user/jobs/job7/memory.max", "200000\n");
  write("sys/fs/cgroup/user/jobs/job7/memory.current", "1000\n");
  EXPECT_EQ(bytes(), 77000);
  EXPECT_EQ(available_memory(root).word, "the control group");
}

TEST_F(Memory, IsWhatAControlGroupOfTheFirstVersionLeaves) {
  write("proc/self/cgroup", "4:cpu,cpuacct:/a\n9:memory:/box\n");
  write("sys/fs/cgroup/memory/box/memory.limit_in_bytes", "100000\n");
  write("sys/fs/cgroup/memory/box/memory.usage_in_bytes", "40000\n");
  EXPECT_EQ(bytes(), 60000);
}

}  // namespace
}  // namespace wander::test
