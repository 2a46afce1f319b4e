#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "core/files.h"
#include "scene/describe.h"
#include "scene/preset.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

/// Folders with presets that name each other.
class SpeciesFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "frond-species-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& file, const std::string& text) {
    ASSERT_TRUE(write_file(folder_ / file, text).ok());
  }
  Result<Preset> read(const std::string& file, const std::vector<std::string>& sets = {}) {
    return read_preset(*read_file(folder_ / file), (folder_ / file).string(), sets);
  }
  /// What a preset says in all, or what is wrong with it.
  static std::string said_by(const Result<Preset>& preset) {
    if (!preset) return preset.errors()[0].text();
    return preset->text;
  }
  static bool says(const Result<Preset>& preset, const std::string& words) {
    return said_by(preset).find(words) != std::string::npos;
  }

  fs::path folder_;
};

TEST_F(SpeciesFiles, OfABaseInAnotherFolderAreThoseBesideTheBase) {
  write("there/vase.json", R"({"organisms": [{"kind": "vase", "height": 0.7}]})");
  write("there/base.json", R"({"organisms": [{"species": "vase.json"}]})");
  write("here/vase.json", R"({"organisms": [{"kind": "vase", "height": 0.3}]})");
  write("here/own.json", R"({"base": "../there/base.json"})");
  write("here/set.json", R"({"organisms": [{"kind": "vase"}]})");
  EXPECT_TRUE(says(read("here/own.json"), "\"height\":0.7")) << said_by(read("here/own.json"));
  // What is set on the command line counts from the preset's own folder.
  Result<Preset> set = read("here/own.json", {"/organisms/0/species=vase.json"});
  EXPECT_TRUE(says(set, "\"height\":0.3")) << said_by(set);
}

TEST_F(SpeciesFiles, MayNameASpeciesThemselvesEachSeenFromItsOwnFolder) {
  write("deep/root.json", R"({"organisms": [{"kind": "vase", "height": 0.9, "name": "root"}]})");
  write("there/tall.json", R"({"organisms": [{"species": "../deep/root.json", "name": "tall"}]})");
  write("here/own.json", R"({"organisms": [{"species": "../there/tall.json"}]})");
  Result<Preset> preset = read("here/own.json");
  EXPECT_TRUE(says(preset, "\"height\":0.9")) << said_by(preset);
  EXPECT_TRUE(says(preset, "\"name\":\"tall\"")) << said_by(preset);
}

TEST_F(SpeciesFiles, ThatAreTheirOwnAreToldNotReadForEver) {
  write("own.json", R"({"organisms": [{"species": "own.json"}]})");
  Result<Preset> preset = read("own.json");
  ASSERT_FALSE(preset.ok());
  EXPECT_NE(preset.errors()[0].text().find("more than 8 species"), std::string::npos)
      << preset.errors()[0].text();
}

}  // namespace
}  // namespace frond
