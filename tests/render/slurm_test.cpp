#include "render/slurm.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "render/process.h"

namespace frond {

namespace fs = std::filesystem;

/// Programs of Slurm that only pretend, found before others as long as a test lives.
class SlurmTest : public testing::Test {
 protected:
  SlurmTest() : folder_((fs::temp_directory_path() / "slurm_test.XXXXXX").string()) {
    ::mkdtemp(folder_.data());
    ::setenv("PATH", (folder_ + ":" + path_).c_str(), 1);
  }
  ~SlurmTest() override {
    ::setenv("PATH", path_.c_str(), 1);
    fs::remove_all(folder_);
  }

  void pretend(const std::string& program, const std::string& script) const {
    fs::path file = fs::path(folder_) / program;
    std::ofstream(file) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(file, fs::perms::owner_all);
  }

 private:
  std::string path_ = environment_or("PATH", "/usr/bin:/bin"), folder_;
};

TEST_F(SlurmTest, TasksAreCountedByState) {
  pretend("squeue", "[ \"$3\" = --jobs=12,13 ] && printf 'RUNNING\\nPENDING\\nRUNNING\\n'");
  std::map<std::string, int> expected{{"PENDING", 1}, {"RUNNING", 2}};
  EXPECT_EQ(slurm_tasks("12,13", "all"), expected);
  EXPECT_TRUE(slurm_tasks("14", "all").empty());
}

TEST_F(SlurmTest, PartitionsAreNamedOnce) {
  pretend("sinfo",
          "case $2 in --partition=cpu) echo cpu ;; --format=%R) printf 'gpu\\ncpu \\ngpu\\n' ;; esac");
  EXPECT_TRUE(has_slurm_partition("cpu"));
  EXPECT_FALSE(has_slurm_partition("cpus"));
  Result<std::vector<std::string>> names = slurm_partitions();
  ASSERT_TRUE(names);
  EXPECT_EQ(*names, (std::vector<std::string>{"cpu", "gpu"}));
  pretend("sinfo", "echo no controller >&2; exit 1");
  EXPECT_EQ(slurm_partitions().errors()[0].text(), "no controller\nSlurm does not answer");
}

TEST_F(SlurmTest, AnArrayIsOneShorterThanItsLargestSize) {
  pretend("scontrol", "printf 'MailProg = x\\nMaxArraySize            = 5\\n'");
  EXPECT_EQ(most_slurm_tasks(), 4);
  pretend("scontrol", "exit 1");
  EXPECT_EQ(most_slurm_tasks(), 1000);
}

TEST_F(SlurmTest, AJobIsItsNumberWithoutItsCluster) {
  pretend("sbatch", "[ \"$1\" = '--name=a b' ] && echo 'sbatch: a note' >&2 && echo '17;west'");
  EXPECT_EQ(*submit_to_slurm({"--name=a b"}), "17");
  pretend("sbatch", "echo no such account >&2; exit 1");
  EXPECT_EQ(submit_to_slurm({}).errors()[0].text(), "sbatch: no such account");
}

TEST_F(SlurmTest, JobsAreEndedOneByOne) {
  pretend("scancel", "[ \"$*\" = '12 13' ] || { echo \"not $*\" >&2; exit 1; }");
  EXPECT_TRUE(cancel_in_slurm("12,13\n").empty());
  EXPECT_EQ(cancel_in_slurm("14")[0].text(), "the jobs could not be ended: not 14");
}

}  // namespace frond
