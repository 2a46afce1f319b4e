#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/files.h"
#include "organisms/coral/coral.h"
#include "scene/preset.h"

namespace frond {
namespace {

/// Presets that build on each other, in a folder of their own.
class Base : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::path(testing::TempDir()) /
             ("base_" + std::to_string(getpid()) +
              std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder / "below");
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  void put(const std::string& name, const std::string& text) { ASSERT_TRUE(write_file(folder / name, text)); }
  Result<Preset> read(const std::string& name, const std::vector<std::string>& sets = {}) {
    std::string path = (folder / name).string();
    return read_preset(*read_file(path), path, sets);
  }

  std::filesystem::path folder;
};

TEST_F(Base, StandsWhereThePresetHasNothing) {
  put("below/wood.json", R"({"title": "wood", "seed": 5, "film": {"frames": 8, "fps": 12},
                             "organisms": [{"kind": "coral"}, {"kind": "coral", "steps": 2}]})");
  put("walk.json",
      R"({"base": "below/wood.json", "title": "walk", "film": {"frames": 9}, "defaults": {"steps": 3}})");
  Result<Preset> preset = read("walk.json", {"/film/fps=6"});
  ASSERT_TRUE(preset) << preset.errors().front().text();
  EXPECT_EQ(preset->title, "walk");
  EXPECT_EQ(preset->seed, 5u);
  EXPECT_EQ(preset->film.frames, 9);
  EXPECT_EQ(preset->film.fps, 6);
  ASSERT_EQ(preset->organisms.size(), 2u);
  EXPECT_EQ(grower_of<Holding<CoralParams>>(preset->organisms[0]).params.steps, 3);
  EXPECT_EQ(grower_of<Holding<CoralParams>>(preset->organisms[1]).params.steps, 2);
}

TEST_F(Base, MayHaveABaseOfItsOwn) {
  put("a.json", R"({"seed": 5, "film": {"frames": 8}, "organisms": []})");
  put("b.json", R"({"base": "a.json", "film": {"fps": 3}})");
  put("c.json", R"({"base": "b.json", "seed": 6})");
  Result<Preset> preset = read("c.json");
  ASSERT_TRUE(preset) << preset.errors().front().text();
  EXPECT_EQ(preset->seed, 6u);
  EXPECT_EQ(preset->film.frames, 8);
  EXPECT_EQ(preset->film.fps, 3);
}

TEST_F(Base, ASpeciesThatIsNowhereNearIsOneOfFronds) {
  for (const char* name : {"oak", "trees/oak", "trees/oak.json", "presets/trees/oak.json"}) {
    put("mine.json", std::string(R"({"organisms": [{"species": ")") + name + R"(", "years": 3}]})");
    Result<Preset> preset = read("mine.json");
    ASSERT_TRUE(preset) << name << ": " << preset.errors().front().text();
    EXPECT_EQ(preset->organisms[0].name, "oak") << name;
    std::string path = (folder / "mine.json").string();
    EXPECT_TRUE(read_preset(*read_file(path), path, {}, folder)) << name << ", whatever else may be read";
  }
  // One of that name in the folder goes before.
  put("oak", R"({"organisms": [{"kind": "vase", "name": "no oak"}]})");
  put("mine.json", R"({"organisms": [{"species": "oak"}]})");
  EXPECT_EQ(read("mine.json")->organisms[0].name, "no oak");
  put("mine.json", R"({"base": "trees/oak", "title": "mine"})");
  EXPECT_EQ(read("mine.json")->title, "mine");
  put("mine.json", R"({"organisms": [{"species": "../presets/trees/oak.json"}]})");
  EXPECT_FALSE(read("mine.json")) << "a path that leads elsewhere names what is there";
}

TEST_F(Base, MessagesSayWhereAFaultStands) {
  put("below.json", "{\"organisms\": [],\n \"film\": {\"frmes\": 8}}");
  put("above.json", "{\"base\": \"below.json\"}");
  Result<Preset> preset = read("above.json");
  ASSERT_FALSE(preset);
  EXPECT_NE(preset.errors().front().where.find("below.json:2:"), std::string::npos)
      << preset.errors().front().text();
}

TEST_F(Base, ThatIsNotThereIsOneMessage) {
  put("above.json", "{\n \"base\": \"nothing.json\"}");
  Result<Preset> preset = read("above.json");
  ASSERT_FALSE(preset);
  ASSERT_EQ(preset.errors().size(), 1u);
  EXPECT_NE(preset.errors().front().where.find("above.json:2:"), std::string::npos)
      << preset.errors().front().text();
  EXPECT_NE(preset.errors().front().text().find("/base: "), std::string::npos);
}

/// Whoever builds on it need not stand where it stands.
TEST_F(Base, FilesThatItNamesAreSeenFromItsOwnFolder) {
  put("lib/house.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  put("lib/house.json", R"({"organisms": [{"kind": "mesh", "file": "house.obj"}]})");
  put("mine/above.json", R"({"base": "../lib/house.json", "title": "mine"})");
  put("mine/species.json", R"({"organisms": [{"species": "../lib/house.json", "size": 2}]})");
  for (const char* name : {"mine/above.json", "mine/species.json"}) {
    Result<Preset> preset = read(name);
    ASSERT_TRUE(preset) << preset.errors().front().text();
    EXPECT_EQ(preset->files.back().filename(), "house.obj");
  }
  // What lies over it counts from where that lies, and so does what the command line says.
  put("mine/hut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(read("mine/above.json", {"/organisms/0/file=hut.obj"}));
  EXPECT_FALSE(read("lib/house.json", {"/organisms/0/file=hut.obj"}));
}

TEST_F(Base, APlantMayHaveAGrammarOfAnotherProgram) {
  put("bush.ls", "3\n25\n20\nA\nA=F[+A]A\n");
  put("bush.json", R"({"organisms": [{"kind": "plant", "grammar": {"file": "bush.ls", "steps": 2}}]})");
  Result<Preset> preset = read("bush.json");
  ASSERT_TRUE(preset) << preset.errors().front().text();
  GrammarText text = (*preset->organisms[0].grower->grammar())->text;
  EXPECT_EQ(text.axiom, "A");
  EXPECT_EQ(text.angle, 25);
  EXPECT_EQ(text.steps, 2);
  put("bush.ls", "3\n25\n20\nA\nsecret\n");
  preset = read("bush.json");
  ASSERT_FALSE(preset);
  std::string said = preset.errors().front().text();
  EXPECT_NE(said.find("bush.json:1:"), std::string::npos) << said;
  EXPECT_NE(said.find("line 5"), std::string::npos) << said;
  EXPECT_EQ(said.find("secret"), std::string::npos) << said;
}

TEST_F(Base, MayBeSet) {
  put("a.json", R"({"seed": 5, "organisms": []})");
  put("b.json", R"({"title": "b"})");
  Result<Preset> preset = read("b.json", {"/base=a.json"});
  ASSERT_TRUE(preset) << preset.errors().front().text();
  EXPECT_EQ(preset->seed, 5u);
}

TEST_F(Base, OutsideOfTheAssetsIsNotRead) {
  put("mine/above.json", R"({"base": "../below/wood.json"})");
  put("below/wood.json", R"({"base": "../tree.json"})");
  put("tree.json", R"({"seed": 5, "organisms": []})");
  std::string path = (folder / "mine/above.json").string(), text = *read_file(path);
  EXPECT_TRUE(read_preset(text, path, {}).ok());
  EXPECT_TRUE(read_preset(text, path, {}, folder).ok());
  Result<Preset> preset = read_preset(text, path, {}, folder / "mine");
  ASSERT_FALSE(preset);
  EXPECT_NE(
      preset.errors()[0].text().find("/mine/above.json:1:10: /base: \"../below/wood.json\" lies outside"),
      std::string::npos)
      << preset.errors()[0].text();
  preset = read_preset(text, path, {}, folder / "below");
  ASSERT_FALSE(preset) << "the base of a base";
  EXPECT_NE(preset.errors()[0].text().find("/below/wood.json:1:10: /base: \"../tree.json\" lies outside"),
            std::string::npos)
      << preset.errors()[0].text();
}

TEST_F(Base, ThatIsNoPresetIsNotShown) {
  put("above.json", R"({"base": "below.json"})");
  for (const char* text : {"hunter2:x:0", "{\"hunter2\": 1}", "{\"film\": {\"hunter2\": 1, \"hunter2\": 2}}",
                           "[\"hunter2\"]", "\"hunter2\"", "{\"seed\": 1,\n \"hunter2\": {}}"}) {
    put("below.json", text);
    Result<Preset> preset = read("above.json");
    ASSERT_FALSE(preset) << text;
    ASSERT_EQ(preset.errors().size(), 1u);
    std::string said = preset.errors()[0].text();
    EXPECT_EQ(said.find("hunter2"), std::string::npos) << said;
    EXPECT_NE(said.find("below.json:"), std::string::npos) << said;
    EXPECT_NE(said.find("expected a preset, see `frond check "), std::string::npos) << said;
  }
}

TEST_F(Base, OfABaseThatIsNoTextIsRefused) {
  put("above.json", R"({"base": "below.json"})");
  put("below.json", R"({"base": 7})");
  Result<Preset> preset = read("above.json");
  ASSERT_FALSE(preset);
  EXPECT_NE(preset.errors()[0].text().find("below.json:1:10: /base: found 7; expected a text"),
            std::string::npos)
      << preset.errors()[0].text();
}

TEST_F(Base, OfItselfIsRefused) {
  put("above.json", R"({"base": "above.json"})");
  Result<Preset> preset = read("above.json");
  ASSERT_FALSE(preset);
  EXPECT_NE(preset.errors().front().text().find("is one its own?"), std::string::npos);
}

}  // namespace
}  // namespace frond
