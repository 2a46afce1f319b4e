#include "jobs/farm.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

bool holds(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

FarmJob odd_job() {
  return {.folder = "/a'b \"{{c}}\"<d>", .name = "my film {{x}}", .work = {"frames", "1"}};
}

TEST(JobName, HoldsNothingThatOthersMightRead) {
  EXPECT_EQ(job_name("reef-8_a.b"), "reef-8_a.b");
  EXPECT_EQ(job_name("{{x}} \n$y"), "--x-----y");
  EXPECT_EQ(job_name(""), "frond");
  EXPECT_EQ(job_name(std::string(100, 'a')).size(), 64u);
}

TEST(SbatchWords, HoldWhatTheSiteAsksFor) {
  FarmSite site;
  site.partition = "a b";
  site.cpus = 4;
  site.minutes = 90;
  site.options = {"--exclusive"};
  std::vector<std::string> expected{"--job-name=my-film---x--", "--partition=a b", "--cpus-per-task=4",
                                    "--time=90", "--exclusive"};
  EXPECT_EQ(sbatch_words(odd_job(), site), expected);
}

TEST(OpenJd, TakesTheFolderAsAValue) {
  std::string text = openjd_text(odd_job(), {});
  EXPECT_TRUE(holds(text, R"("default": "/a'b \"{{c}}\"<d>")"));
  EXPECT_TRUE(holds(text, R"("args": ["{{Param.Folder}}", "1", "frames", "1", "{{Task.Param.Task}}"])"));
  EXPECT_FALSE(holds(text, "timeout"));
}

TEST(OpenCue, QuotesForTheShellAndForXml) {
  FarmSite site;
  site.memory = 500;
  std::string text = opencue_text(odd_job(), site);
  EXPECT_TRUE(holds(text, "<cmd>'/a'\\''b &quot;{{c}}&quot;&lt;d&gt;/tool/scripts/farm_task.sh' "));
  EXPECT_TRUE(holds(text, "'frames' '1' #IFRAME#</cmd>"));
  EXPECT_TRUE(holds(text, "<cores>1.0</cores><memory>500m</memory>"));
}

}  // namespace
}  // namespace frond
