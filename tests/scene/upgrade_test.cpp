#include "scene/upgrade.h"

#include <gtest/gtest.h>

#include "core/files.h"

namespace frond {
namespace {

bool none_is_there(const std::string&) { return false; }

std::string upgraded(std::string_view text) { return upgrade_preset(text, "f", &none_is_there).text; }

TEST(Upgrade, RewritesWhatHasAnotherForm) {
  struct {
    std::string_view before, after;
  } const cases[] = {
      {R"({"organisms": [{"kind": "massive", "wave": 0.01}]})",
       R"({"organisms": [{"kind": "massive", "valley": 0.01}]})"},
      {R"({"organisms": [{"kind": "weber_penn", "species": "aspen.xml"}]})",
       R"({"organisms": [{"kind": "weber_penn", "arbaro": "aspen.xml"}]})"},
      {R"({"organisms": [{"species": "species/corals/bush.json"}]})",
       R"({"organisms": [{"species": "species/corals/bird_nest.json"}]})"},
      {R"({"base": "../species/corals/bush.json"})", R"({"base": "../species/corals/bird_nest.json"})"},
      {R"({"defaults": {"food": {"strength": 0.8}}})", R"({"defaults": {"food": {"strength": 45.8366}}})"},
      {R"({"scene": {"meadow": {"hills": 0.5, "hills_distance": 100}}})",
       R"({"scene": {"meadow": {}, "far": {"relief": 35}}})"},
      {R"({"scene": {"meadow": {"hills": 0}}})",
       R"({"scene": {"meadow": {}, "far": {"relief": 0, "woods": 0}}})"},
      {R"({"scene": {"meadow": {"hills": 1}}})", R"({"scene": {"meadow": {}}})"},
      {R"({"scene": {"far": {"woods": 1}, "meadow": {"hills": 2}}})",
       R"({"scene": {"far": {"woods": 1}, "meadow": {}}})"},
      {R"({"stand": {"years": 9, "events": [{"year": 3, "cut": "oak"}]}})",
       R"({"stand": {"years": 9}, "events": [{"year": 3, "cut": {"entry": "oak", "share": 0.5}}]})"},
      {R"({"stand": {"events": [{"cut": "oak", "share": 1, "year": 3}], "species": [{"name": "oak", "organism": "old"}]}})",
       R"({"stand": {"species": [{"name": "oak", "organism": "old"}]}, "events": [{"cut": {"entry": "old", "share": 1}, "year": 3}]})"},
  };
  for (const auto& c : cases) {
    EXPECT_EQ(upgraded(c.before), c.after);
    EXPECT_EQ(upgraded(c.after), c.after) << "once is enough";
  }
}

TEST(Upgrade, LeavesWhatIsOfToday) {
  for (std::string_view text :
       {R"({"organisms": [{"kind": "coral", "wave": {"amplitude": 4}}]})",
        R"({"version": 2, "defaults": {"food": {"strength": 0.8}}})",
        R"({"defaults": {"food": {"strength": 0.02}}})", R"({"defaults": {"food": {"strength": 8}}})",
        R"({"organisms": 3, "scene": [], "stand": {"events": 1}})", R"({"organisms": [3, null]})", "no JSON",
        "[]", ""})
    EXPECT_EQ(upgraded(text), text);
  std::string own = R"({"organisms": [{"species": "species/corals/bush.json"}]})";
  EXPECT_TRUE(upgrade_preset(own, "f", [](const std::string&) { return true; }).changes.empty())
      << "a file of one's own";
}

TEST(Upgrade, SaysWhatChangesAndWhere) {
  Upgrade today = upgrade_preset("{\"organisms\": [\n  {\"kind\": \"massive\", \"wave\": 0.01}]}", "my.json",
                                 &none_is_there);
  ASSERT_EQ(today.changes.size(), 1u);
  EXPECT_EQ(today.changes[0].text(), "my.json:2:31: /organisms/0/wave: is called valley");
}

TEST(Upgrade, FindsNothingOldInWhatIsShipped) {
  std::size_t presets = 0;
  for (const char* folder : {"presets", "templates"})
    for (const std::filesystem::path& file : files_below(folder)) {
      if (file.extension() != ".json") continue;
      Result<std::string> text = read_file(file);
      ASSERT_TRUE(text) << file;
      for (const Error& change : upgrade_preset(*text, file.string(), &none_is_there).changes)
        ADD_FAILURE() << change.text();
      ++presets;
    }
  EXPECT_GT(presets, 100u);
}

}  // namespace
}  // namespace frond
