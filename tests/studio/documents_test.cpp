#include "studio/documents.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/files.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

class DocumentsTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "frond-documents-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    (void)write_file(folder_ / "own/a.json", kText);
    (void)write_file(folder_ / "secret.json", kText);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Documents documents() const {
    return Documents({.home = FROND_ROOT, .preset = folder_ / "own/a.json", .assets = {}, .ready = {}});
  }
  std::string disk() const { return (*documents().read((folder_ / "own/a.json").string()))["disk"]; }

  Doc doc(const std::string& text) const { return {text, folder_ / "own/a.json"}; }

  static constexpr const char* kText = R"({"organisms": []} // mine)";
  fs::path folder_;
};

TEST_F(DocumentsTest, OpensThePresetAndKnowsTheShipped) {
  EXPECT_EQ(documents().opened()["text"], kText);
  EXPECT_FALSE(documents().opened()["copy"].get<bool>());
  Json shipped = documents().shipped();
  ASSERT_GT(shipped.size(), 40u);
  for (const Json& one : shipped) EXPECT_TRUE((*documents().read(one["file"]))["copy"].get<bool>());
}

TEST_F(DocumentsTest, ReadsNothingOutsideOfItsFolders) {
  Documents d = documents();
  EXPECT_TRUE(d.readable((folder_ / "own/a.json").string()));
  for (std::string file : {(folder_ / "secret.json").string(), (folder_ / "own/../secret.json").string(),
                           (folder_ / "ownish").string(), std::string("/etc/passwd")})
    EXPECT_FALSE(d.readable(file)) << file;
  fs::create_symlink(folder_ / "secret.json", folder_ / "own/link.json");
  EXPECT_FALSE(d.readable((folder_ / "own/link.json").string()));
  EXPECT_FALSE(d.gallery_picture("../export.md").ok());
  // Nor do presets: a file that one names is looked for in its folder alone.
  Result<Preset> preset = d.preset({R"({"base": "../secret.json"})", folder_ / "own/a.json"});
  ASSERT_FALSE(preset.ok());
  EXPECT_EQ(preset.errors().front().text().find("mine"), std::string::npos);
}

TEST_F(DocumentsTest, SavesWhereItMayAndNotOverWhatOthersWrote) {
  Documents d = documents();
  Json saved;
  std::string path = (folder_ / "own/a.json").string();
  EXPECT_FALSE(d.save(path, doc("{}"), disk(), false, saved));
  EXPECT_EQ(*read_file(path), "{}");
  EXPECT_EQ(saved["disk"], disk());
  std::string known = disk();
  (void)write_file(path, "{ }");
  auto refusal = d.save(path, doc("[]"), known, false, saved);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->status, 409);
  EXPECT_EQ(*read_file(path), "{ }");
  EXPECT_FALSE(d.save(path, doc("[]"), known, true, saved));
  EXPECT_EQ(*read_file(path), "[]");
  EXPECT_EQ(d.save("a.json", doc("x"), "", false, saved)->status, 409);  // there already
  EXPECT_FALSE(d.save("new.json", doc("{}"), "", false, saved));
  EXPECT_TRUE(fs::exists(folder_ / "own/new.json"));
  for (std::string file : {"../b.json", "/etc/b.json", "b.txt", ""}) {
    auto outside = d.save(file, doc("{}"), "", true, saved);
    ASSERT_TRUE(outside) << file;
    EXPECT_EQ(outside->status, 403) << file;
  }
  fs::create_symlink(folder_ / "secret.json", folder_ / "own/link.json");
  EXPECT_TRUE(d.save("link.json", doc("{}"), "", true, saved));
  EXPECT_EQ(*read_file(folder_ / "secret.json"), kText);
}

TEST_F(DocumentsTest, AMeshGetsAPlainNameOfItsOwn) {
  Documents d = documents();
  Json saved;
  EXPECT_FALSE(d.add_mesh("../../my rock!.obj", "v 0 0 0", saved));
  EXPECT_EQ(saved["file"], "my_rock_.obj");
  EXPECT_TRUE(fs::exists(folder_ / "own/my_rock_.obj"));
  EXPECT_FALSE(d.add_mesh("my rock!.obj", "v 0 0 0", saved));  // the same once
  EXPECT_EQ(saved["file"], "my_rock_.obj");
  EXPECT_FALSE(d.add_mesh("my rock!.obj", "v 1 0 0", saved));
  EXPECT_EQ(saved["file"], "my_rock_-2.obj");
}

TEST_F(DocumentsTest, ACopyTakesTheFilesThatItNamesAlong) {
  Documents d = documents();
  fs::path ivy = fs::weakly_canonical(fs::absolute(FROND_ROOT "/presets/ivy/any_mesh.json"));
  std::string text = *read_file(ivy);
  Json saved;
  ASSERT_FALSE(d.save("mine.json", {text, ivy}, "", false, saved));
  std::string moved = *read_file(folder_ / "own/mine.json");
  EXPECT_EQ(moved, saved["text"]);
  std::string expected = text;
  expected.replace(expected.find("../models/arch.obj"), 18, "arch.obj");
  EXPECT_EQ(moved, expected);  // nothing else has changed
  EXPECT_TRUE(d.preset({moved, folder_ / "own/mine.json"}).ok());
}

TEST(ErrorsJson, PartsOfAPlace) {
  Json list = errors_json({{"a.json:3:14: /organisms/0/pitch", "found 5"},
                           {"a.json:7:2", "no JSON"},
                           {"/film/fps", "bad"},
                           {"", "x"}});
  EXPECT_EQ(list[0]["line"], 3);
  EXPECT_EQ(list[0]["column"], 14);
  EXPECT_EQ(list[0]["pointer"], "/organisms/0/pitch");
  EXPECT_EQ(list[1]["line"], 7);
  EXPECT_EQ(list[1]["pointer"], "");
  EXPECT_EQ(list[2]["pointer"], "/film/fps");
  EXPECT_EQ(list[3]["line"], 0);
}

}  // namespace
}  // namespace frond
