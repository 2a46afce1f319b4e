#include "studio/documents.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <set>
#include <thread>

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
  EXPECT_FALSE(d.leaf("gallery", "../export.md").ok());
  EXPECT_TRUE(d.leaf("docs", "kinds/tree.md").ok());
  EXPECT_FALSE(d.leaf("docs", "../README.md").ok());
  EXPECT_FALSE(d.leaf("docs", "preset.schema.json").ok());
  // Nor do presets: a file that one names is looked for in its folder alone.
  Result<Preset> preset = d.preset({R"({"base": "../secret.json"})", folder_ / "own/a.json"});
  ASSERT_FALSE(preset.ok());
  EXPECT_EQ(preset.errors().front().text().find("mine"), std::string::npos);
}

TEST_F(DocumentsTest, NoNameEndsBeforeItsEnding) {
  Documents d = documents();
  const std::string nul(1, '\0');
  for (const std::string& file :
       {".bashrc" + nul + ".json", (folder_ / "own/b").string() + nul + "/c.json"}) {
    EXPECT_EQ(d.save(file, doc("{}"), "", true).status, 403) << file;
  }
  EXPECT_FALSE(fs::exists(folder_ / "own/.bashrc"));
  EXPECT_FALSE(fs::exists(folder_ / "own/b"));
  EXPECT_FALSE(d.readable((folder_ / "own/a.json").string() + nul));
  // Nor is a link a way round.
  (void)write_file(folder_ / "own/.profile", "mine");
  fs::create_symlink(folder_ / "own/.profile", folder_ / "own/link.json");
  EXPECT_NE(d.save("link.json", doc("{}"), "", true).status, 200);
  EXPECT_EQ(*read_file(folder_ / "own/.profile"), "mine");
  // Files that presets name are read by the same rule.
  EXPECT_FALSE(read_file((folder_ / "own/a.json").string() + nul + ".png").ok());
  EXPECT_FALSE(write_file((folder_ / "own/c").string() + nul + ".png", "x").ok());
}

TEST_F(DocumentsTest, SavesWhereItMayAndNotOverWhatOthersWrote) {
  Documents d = documents();
  Answer saved;
  std::string path = (folder_ / "own/a.json").string();
  EXPECT_EQ((saved = d.save(path, doc("{}"), disk(), false)).status, 200);
  EXPECT_EQ(*read_file(path), "{}");
  EXPECT_EQ(saved.json["disk"], disk());
  std::string known = disk();
  (void)write_file(path, "{ }");
  EXPECT_EQ(d.save(path, doc("[]"), known, false).status, 409);
  EXPECT_EQ(*read_file(path), "{ }");
  EXPECT_EQ(d.save(path, doc("[]"), known, true).status, 200);
  EXPECT_EQ(*read_file(path), "[]");
  EXPECT_EQ(d.save("a.json", doc("x"), "", false).status, 409);  // there already
  EXPECT_EQ(d.save("new.json", doc("{}"), "", false).status, 200);
  EXPECT_TRUE(fs::exists(folder_ / "own/new.json"));
  for (std::string file : {"../b.json", "/etc/b.json", "b.txt", ""}) {
    EXPECT_EQ(d.save(file, doc("{}"), "", true).status, 403) << file;
  }
  fs::create_symlink(folder_ / "secret.json", folder_ / "own/link.json");
  EXPECT_NE(d.save("link.json", doc("{}"), "", true).status, 200);
  EXPECT_EQ(*read_file(folder_ / "secret.json"), kText);
}

TEST_F(DocumentsTest, OfTwoWhoSaveOverTheSameOneIsTold) {
  // Each a studio of its own, as far as anybody can tell.
  std::string path = (folder_ / "own/a.json").string(), known = disk();
  for (int round = 0; round < 20; ++round) {
    std::array<Answer, 4> saved;
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < saved.size(); ++i)
      threads.emplace_back([&, i] {
        std::string text = "{\"seed\": " + std::to_string(10 * round + static_cast<int>(i)) + "}";
        saved[i] = documents().save(path, doc(text), known, false);
      });
    for (std::thread& thread : threads) thread.join();
    int fine = 0;
    for (const Answer& answer : saved) {
      if (answer.status == 200) ++fine, known = answer.json["disk"];
      EXPECT_EQ(answer.status == 200 ? 409 : answer.status, 409);
    }
    EXPECT_EQ(fine, 1) << "the others would have written over what they had not seen";
    EXPECT_EQ(known, disk());
  }
  for (const fs::path& file : files_in(folder_ / "own")) EXPECT_EQ(file.extension(), ".json") << file;
}

TEST_F(DocumentsTest, ManyMayBeSavedAtOnce) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&, i] {
      EXPECT_EQ(documents().save("b.json", doc("[" + std::to_string(i) + "]"), "", true).status, 200);
      EXPECT_EQ(documents().add_file("stone.obj", ".obj", "v 0 0 " + std::to_string(i), "").status, 200);
    });
  for (std::thread& thread : threads) thread.join();
  std::set<std::string> stones;
  for (const fs::path& file : files_in(folder_ / "own"))
    if (file.extension() == ".obj") stones.insert(*read_file(file));
  EXPECT_EQ(stones.size(), 8u);
}

TEST_F(DocumentsTest, ListsTheOwnPresetsThoseOfTodayFirst) {
  fs::path old = folder_ / "own/old.json", deep = folder_ / "own/below/deep.json";
  (void)write_file(old, R"({"title": "An old one", "organisms": []})");
  (void)write_file(deep, R"({"organisms": []})");
  (void)write_file(folder_ / "own/grammar.json", R"({"axiom": "F"})");
  (void)write_file(folder_ / "own/.hidden/a.json", kText);
  (void)write_file(folder_ / "own/broken.json", "{");
  fs::create_symlink(folder_ / "secret.json", folder_ / "own/link.json");
  auto when = fs::last_write_time(deep);
  fs::last_write_time(folder_ / "own/a.json", when - std::chrono::hours(1));
  fs::last_write_time(old, when - std::chrono::hours(48));
  Json list = documents().own();
  ASSERT_EQ(list.size(), 3u) << list;
  EXPECT_EQ(list[0]["name"], "below/deep.json");
  EXPECT_EQ(list[1]["name"], "a.json");
  EXPECT_EQ(list[2]["title"], "An old one");
  for (const Json& one : list) EXPECT_FALSE((*documents().read(one["file"]))["copy"].get<bool>());
}

TEST_F(DocumentsTest, KnowsWhenAFileHasChanged) {
  std::string before = disk(), path = (folder_ / "own/a.json").string();
  EXPECT_EQ(documents().disk(path), before);
  (void)write_file(path, "{}");
  EXPECT_NE(documents().disk(path), before);
  EXPECT_EQ(documents().disk(path), disk());
  EXPECT_EQ(documents().disk((folder_ / "own/none.json").string()), "");
  EXPECT_EQ(documents().disk((folder_ / "secret.json").string()), "");
}

TEST_F(DocumentsTest, MostShippedPresetsHaveAPictureInTheGallery) {
  std::size_t with = 0;
  Json shipped = documents().shipped();
  for (const Json& one : shipped) {
    with += !one["picture"].is_null();
    EXPECT_TRUE(one["name"] != "reef_dusk" || one["picture"] == "reef-dusk.jpg");
  }
  EXPECT_GT(with, shipped.size() / 2);
}

TEST_F(DocumentsTest, AMeshGetsAPlainNameOfItsOwn) {
  Documents d = documents();
  Answer saved = d.add_file("../../my rock!.obj", ".obj", "v 0 0 0", "");
  EXPECT_EQ(saved.status, 200);
  EXPECT_EQ(saved.json["file"], "my_rock_.obj");
  EXPECT_TRUE(fs::exists(folder_ / "own/my_rock_.obj"));
  EXPECT_EQ((saved = d.add_file("my rock!.obj", ".obj", "v 0 0 0", "")).status, 200);  // the same once
  EXPECT_EQ(saved.json["file"], "my_rock_.obj");
  EXPECT_EQ((saved = d.add_file("my rock!.obj", ".obj", "v 1 0 0", "")).status, 200);
  EXPECT_EQ(saved.json["file"], "my_rock_-2.obj");
}

TEST_F(DocumentsTest, ACopyTakesTheFilesThatItNamesAlong) {
  Documents d = documents();
  fs::path ivy = fs::weakly_canonical(fs::absolute(FROND_ROOT "/tests/presets/ivy_on_arch.json"));
  std::string text = *read_file(ivy);
  Answer saved = d.save("mine.json", {text, ivy}, "", false);
  ASSERT_EQ(saved.status, 200);
  std::string moved = *read_file(folder_ / "own/mine.json");
  EXPECT_EQ(moved, saved.json["text"]);
  std::string expected = text;
  std::string_view mesh = "../../presets/models/arch.obj";
  expected.replace(expected.find(mesh), mesh.size(), "arch.obj");
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
