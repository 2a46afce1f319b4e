#include <frond/frond.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

// The public library, linked as others link it: what its header promises.

namespace {

namespace api = frond::api;
namespace fs = std::filesystem;

constexpr const char* kVase = R"({"film": {"frames": 3, "size": [32, 18]}, "scene": {"setting": "studio"},
  "organisms": [{"kind": "vase", "name": "v", "height": 0.4}]})";

class FrondApi : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "frond-api-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
};

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

TEST_F(FrondApi, ReadsWhatComesWithFrondByItsName) {
  api::Preset oak = api::Preset::read("oak");
  EXPECT_EQ(oak.file().filename(), "oak.json");
  EXPECT_EQ(oak.title(), "An oak in a meadow");
  EXPECT_EQ(oak.frames(), 1);
}

TEST_F(FrondApi, TellsWhereAPresetIsWrongAndLeavesItAsItWas) {
  api::Preset preset = api::Preset::parse(kVase, "mine.json");
  std::string before = preset.text();
  try {
    preset.set("/organisms/0/height", "-1");
    FAIL() << "a height below 0 was taken";
  } catch (const api::Failure& failure) {
    EXPECT_TRUE(failure.of_input());
    ASSERT_EQ(failure.messages().size(), 1u);
    EXPECT_NE(failure.messages()[0].where.find("/organisms/0/height"), std::string::npos);
  }
  EXPECT_EQ(preset.text(), before);
  preset.set("/organisms/0/height", "0.5");
  EXPECT_NE(preset.text(), before);
}

TEST_F(FrondApi, GrowsLooksAndExports) {
  api::Scene scene = api::grow(api::Preset::parse(kVase));
  ASSERT_EQ(scene.organisms().size(), 1u);
  EXPECT_EQ(scene.organisms()[0].name, "v");
  EXPECT_TRUE(scene.look().starts_with("\x89PNG"));
  EXPECT_TRUE(scene.passes(1, 1).starts_with("v/1\x01"));
  scene.export_to(folder_ / "v.glb", {.detail = 400, .texture = 0});
  EXPECT_TRUE(text_of(folder_ / "v.glb").starts_with("glTF"));
  EXPECT_THROW(scene.look(4), api::Failure) << "the film has three frames";
  EXPECT_THROW(scene.export_to(folder_ / "v.docx"), api::Failure);
}

/// Cancels at the first step.
class Impatient : public api::Listener {
 public:
  void step() override { over_ = true; }
  bool cancelled() override { return over_; }

 private:
  std::atomic<bool> over_ = false;
};

TEST_F(FrondApi, EndsWhereAListenerCancels) {
  Impatient listener;
  EXPECT_THROW(api::grow(api::Preset::parse(kVase), &listener), api::Cancelled);
}

TEST_F(FrondApi, WritesTheFramesThatTheProgramWrites) {
  api::write_frames(api::Preset::parse(kVase), folder_ / "frames", {.frames = {{2, 3}}});
  EXPECT_FALSE(fs::exists(folder_ / "frames/frames/frame_0001.pov"));
  EXPECT_TRUE(fs::exists(folder_ / "frames/frames/frame_0003.pov"));
  EXPECT_TRUE(fs::exists(folder_ / "frames/build.ninja"));
  EXPECT_THROW(api::write_frames(api::Preset::parse(kVase), folder_ / "x", {.frames = {{2, 4}}}),
               api::Failure);
}

TEST_F(FrondApi, ResolvesByThePresetsOwnFileWhereItHasOne) {
  fs::path file = folder_ / "mine.json";
  std::ofstream(file) << kVase;
  api::write_frames(api::Preset::read(file), folder_ / "read", {.frames = {{1, 1}}, .resolve = true});
  api::write_frames(api::Preset::parse(kVase), folder_ / "parsed", {.frames = {{1, 1}}, .resolve = true});
  EXPECT_FALSE(fs::exists(folder_ / "read/preset.json"));
  EXPECT_NE(text_of(folder_ / "read/build.ninja").find("mine.json"), std::string::npos);
  EXPECT_EQ(text_of(folder_ / "parsed/preset.json"), kVase);
}

/// A variable of the environment that has another value for a while.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value, 1);
  }
  ~Variable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST_F(FrondApi, AMissingProgramIsNoFaultOfTheInput) {
  api::Preset preset = api::Preset::parse(kVase);
  Variable home("FROND_HOME", folder_.c_str()), program("FROND_BIN", ""), path("PATH", "");
  try {
    api::write_frames(preset, folder_ / "frames");
    FAIL() << "frames were written for a program that is not there";
  } catch (const api::Failure& failure) {
    EXPECT_NE(failure.messages().at(0).what.find("set FROND_BIN"), std::string::npos);
    EXPECT_FALSE(failure.of_input());
  }
}

/// Notes how many frames it was told of.
class Counter : public api::Listener {
 public:
  void rendered(int done, int all, std::string_view) override { most_ = done, all_ = all; }
  int most_ = 0, all_ = 0;
};

TEST_F(FrondApi, RendersAFilmAndGoesOnFromWhatIsThere) {
  api::Preset preset = api::Preset::parse(kVase);
  Counter first, second;
  auto files = api::render(preset, folder_ / "film", {}, &first);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].filename(), "film.mp4");
  EXPECT_TRUE(fs::exists(files[0])) << "and its contact sheet " << files[1];
  EXPECT_EQ(first.most_, 3);
  EXPECT_EQ(first.all_, 3);
  EXPECT_EQ(api::render(preset, folder_ / "film", {}, &second), files);
  EXPECT_EQ(second.most_, 0) << "what is finished is not rendered again";
}

TEST_F(FrondApi, DerivesGrammars) {
  std::ofstream(folder_ / "a.json") << R"({"axiom": "A", "rules": ["A -> AB", "B -> A"], "steps": 3})";
  api::Grammar grammar = api::Grammar::read(folder_ / "a.json");
  EXPECT_EQ(grammar.derive(), "ABAAB");
  EXPECT_EQ(grammar.derive(1), "AB");
}

}  // namespace
