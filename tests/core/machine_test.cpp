#include "core/machine.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/files.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

/// The files of /proc and /sys in which a made-up machine tells of itself.
class MachineTest : public testing::Test {
 protected:
  MachineTest() {
    fs::remove_all(root_);
    put("proc/meminfo", "MemTotal:       16000000 kB\nMemFree:  1 kB\nMemAvailable:    8000000 kB\n");
  }
  ~MachineTest() override { fs::remove_all(root_); }

  void put(const std::string& path, const std::string& text) { ASSERT_TRUE(write_file(root_ / path, text)); }
  double memory() const { return this_machine(".", root_).memory; }

  fs::path root_ = fs::path(testing::TempDir()) / ("frond_machine_" + std::to_string(getpid()));
};

TEST_F(MachineTest, HasTheMemoryThatIsAvailable) { EXPECT_EQ(memory(), 8000000.0 * 1024); }

TEST_F(MachineTest, IsHeldToItsCgroupAndThoseAbove) {
  put("proc/self/cgroup", "0::/outer/inner\n");
  put("sys/fs/cgroup/outer/inner/memory.max", "max\n");
  put("sys/fs/cgroup/outer/memory.max", "1000000000\n");
  put("sys/fs/cgroup/outer/memory.current", "400000000\n");
  put("sys/fs/cgroup/outer/memory.stat", "anon 1\ninactive_file 100000000\n");
  EXPECT_EQ(memory(), 7e8);
}

TEST_F(MachineTest, IsHeldToACgroupOfTheFirstVersionSeenFromWithinAContainer) {
  put("proc/self/cgroup", "9:name=systemd:/\n4:cpu,memory:/docker/0123\n");
  put("sys/fs/cgroup/memory/memory.limit_in_bytes", "500000000\n");
  put("sys/fs/cgroup/memory/memory.usage_in_bytes", "200000000\n");
  EXPECT_EQ(memory(), 3e8);
  put("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(memory(), 8000000.0 * 1024);
}

TEST_F(MachineTest, KnowsTheDiskOfAFolderThatIsNotThereYet) {
  double here = this_machine(testing::TempDir()).disk, below = this_machine(root_ / "not" / "there").disk;
  EXPECT_GT(here, 0);
  EXPECT_NEAR(below / here, 1, 0.1);
}

}  // namespace
}  // namespace frond
