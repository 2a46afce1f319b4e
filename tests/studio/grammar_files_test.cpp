#include "studio/grammar_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/files.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

/// A folder of one's own with a preset in it.
class GrammarFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "frond-grammars-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    (void)write_file(folder_ / "a.json", "{}");
  }
  void TearDown() override { fs::remove_all(folder_); }

  Documents documents() const {
    return Documents({.home = FROND_ROOT, .preset = folder_ / "a.json", .assets = {}, .ready = {}});
  }
  static std::string text_of(const Json& answer, const std::string& name) {
    for (const Json& file : answer["files"])
      if (file["name"] == name) return file["text"];
    return "";
  }

  const fs::path lilac_ = fs::path(FROND_ROOT) / "presets/lsystems/lilac.l";
  fs::path folder_;
};

TEST_F(GrammarFilesTest, AModelOfCpfgShowsItsFilesAndItsWord) {
  Answer answer = grammar_files(documents(), {{"file", lilac_.string()}, {"steps", 1}});
  ASSERT_EQ(answer.status, 200);
  EXPECT_EQ(answer.json["files"][0]["name"], "lilac.l");
  EXPECT_EQ(text_of(answer.json, "lilac.l"), *read_file(lilac_));
  EXPECT_FALSE(text_of(answer.json, "lilac.v").empty());
  EXPECT_EQ(answer.json["steps"], 1);
  EXPECT_GT(answer.json["of"], 1);
  EXPECT_FALSE(answer.json["word"].get<std::string>().empty());
  EXPECT_TRUE(answer.json["svg"].get<std::string>().starts_with("<svg"));
  EXPECT_TRUE(answer.json["errors"].empty());
  EXPECT_EQ(grammar_files(documents(), {{"file", "/etc/passwd"}}).status, 403);
}

TEST_F(GrammarFilesTest, AGrammarOfOneFileShowsThatAlone) {
  (void)write_file(folder_ / "weed.ls", "axiom: F\nF -> F[+F]F\n");
  (void)write_file(folder_ / "weed.json", "{}");
  (void)write_file(folder_ / "specifications", "another program's");
  Answer answer = grammar_files(documents(), {{"file", (folder_ / "weed.ls").string()}});
  ASSERT_EQ(answer.status, 200);
  ASSERT_EQ(answer.json["files"].size(), 1u);
  EXPECT_EQ(answer.json["files"][0]["name"], "weed.ls");
}

TEST_F(GrammarFilesTest, AnEditedModelIsWrittenBesideThePresetAndTheFormerStays) {
  Documents d = documents();
  const std::string was = *read_file(lilac_);
  Json question{{"file", lilac_.string()}, {"name", "lilac.l"}, {"text", was + "\n/* mine */\n"}, {"of", ""}};
  Answer answer = changed_grammar(d, question);
  ASSERT_EQ(answer.status, 200) << answer.json;
  EXPECT_EQ(answer.json["file"], "lilac/lilac.l");
  EXPECT_TRUE(fs::exists(folder_ / "lilac/lilac.v")) << "its view goes along";
  EXPECT_EQ(*read_file(lilac_), was);
  // From there on.
  question["file"] = answer.json["path"], question["text"] = was + "\n/* mine, too */\n";
  answer = changed_grammar(d, question);
  EXPECT_EQ(answer.json["file"], "lilac-2/lilac.l");
  Json shown = grammar_files(d, {{"file", answer.json["path"]}}).json;
  EXPECT_EQ(text_of(shown, "lilac.l"), question["text"]);
}

TEST_F(GrammarFilesTest, AModelThatCannotBeReadIsToldWithItsLineAndNotWritten) {
  Json question{
      {"file", lilac_.string()}, {"name", "lilac.l"}, {"text", "Lsystem: 1\naxiom: A(\nendlsystem\n"}};
  Answer answer = changed_grammar(documents(), question);
  EXPECT_EQ(answer.status, 422);
  EXPECT_TRUE(answer.json["errors"][0]["where"].get<std::string>().starts_with("lilac.l")) << answer.json;
  EXPECT_FALSE(fs::exists(folder_ / "lilac"));
  question["name"] = "../a.json";
  EXPECT_EQ(changed_grammar(documents(), question).status, 400);
}

TEST_F(GrammarFilesTest, NothingIsWrittenForAShippedPresetThatWouldNotFindIt) {
  Answer answer = changed_grammar(documents(), {{"file", lilac_.string()},
                                                {"name", "lilac.l"},
                                                {"text", *read_file(lilac_) + "\n"},
                                                {"of", (lilac_.parent_path() / "lilac.json").string()}});
  EXPECT_EQ(answer.status, 409);
  EXPECT_NE(answer.json["error"].get<std::string>().find("save"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "lilac"));
}

TEST_F(GrammarFilesTest, ASavedPresetTakesItsModelAlong) {
  Documents d = documents();
  const fs::path shipped = lilac_.parent_path() / "lilac.json";
  Answer saved = d.save("mine.json", {*read_file(shipped), shipped}, "", false);
  ASSERT_EQ(saved.status, 200);
  EXPECT_NE(saved.json["text"].get<std::string>().find("\"lilac/lilac.l\""), std::string::npos);
  EXPECT_EQ(*read_file(folder_ / "lilac/lilac.l"), *read_file(lilac_));
  Result<Preset> preset = d.preset({saved.json["text"], folder_ / "mine.json"});
  EXPECT_TRUE(preset.ok()) << preset.errors().front().text();
}

TEST_F(GrammarFilesTest, SavingTakesAwayWhatWasMadeForThePresetAndIsNotNamed) {
  Documents d = documents();
  const fs::path own = folder_ / "a.json";
  auto add = [&](const std::string& name, const fs::path& of) {
    Answer made = d.add_file(name, ".png", "\x89PNG " + name, of);
    EXPECT_EQ(made.status, 200);
    return made.json["file"].get<std::string>();
  };
  auto there = [&](const std::string& name) { return fs::exists(folder_ / name); };
  auto save = [&](const std::string& text) {
    EXPECT_EQ(d.save("a.json", {text, own}, d.disk(own.string()), true).status, 200);
  };
  std::string first = add("first.png", own), second = add("second.png", own);
  std::string others = add("others.png", folder_ / "b.json");
  save(R"({"organisms": [], "title": "second.png"})");
  EXPECT_FALSE(there(first));
  EXPECT_TRUE(there(second) && there(others));
  // Undone.
  (void)d.preset({R"({"organisms": [], "title": "first.png"})", own});
  EXPECT_TRUE(there(first));
  // What was saved once may be named elsewhere.
  save(R"({"organisms": []})");
  EXPECT_FALSE(there(first));
  EXPECT_TRUE(there(second));
}

}  // namespace
}  // namespace frond
