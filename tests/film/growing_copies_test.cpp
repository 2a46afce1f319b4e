#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "emit/copies.h"
#include "film/film_files.h"
#include "scene/scene.h"

namespace frond {
namespace {

/// A sown reef that grows from second 1 on for two seconds, and sways.
Scene sown_reef(const std::string& film = R"({"frames": 60, "fps": 12, "size": [160, 100]})") {
  std::string text = R"({"film": )" + film + R"(, "scene": {"setting": "underwater",
      "camera": {"location": [0, 1, 5], "look_at": [0, 0.2, 0]}},
    "defaults": {"wave": {"amplitude": 6, "speed": 0.7}, "growth": {"start": 1, "duration": 2}},
    "organisms": [
      {"species": "presets/species/corals/bird_nest.json", "count": 5, "sown": {"models": 2, "where": {"radius": 0.3, "reach": 1.5}}},
      {"species": "presets/species/corals/honeycomb.json", "count": 4, "sown": {"models": 1, "where": {"radius": 0.3, "reach": 1.5}}}]})";
  Result<Preset> preset = read_preset(text, "sown.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return *build_scene(*preset);
}

class GrowingCopies : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    ProgressSink watch{[](auto, auto) {}, [] {}};
    plan_ = *write_models(scene_, folder_, watch);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string at(double time) const { return swaying_copies_text({}, scene_, plan_, 1, time).text; }
  static std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t i = text.find(what); i != text.npos; i = text.find(what, i + 1)) ++n;
    return n;
  }

  Scene scene_ = sown_reef();
  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                  testing::UnitTest::GetInstance()->current_test_info()->name();
  CopyPlan plan_;
};

TEST_F(GrowingCopies, AreNotThereBeforeTheyGrowAndAreTheirModelsWhenTheyHave) {
  EXPECT_EQ(at(0.9).find("object{"), std::string::npos);
  std::string half = at(2), grown = at(4.5);
  EXPECT_GE(count(half, " = mesh2{"), 3u);
  EXPECT_LE(count(half, " = mesh2{"), 6u) << "one for each model at a level, however many copies";
  EXPECT_EQ(count(grown, "mesh2"), 0u);
  EXPECT_EQ(count(half, "object{Growing"), 9u);
  EXPECT_EQ(count(grown, "object{Model"), 9u);
}

TEST_F(GrowingCopies, AreNoMeshWithoutTrianglesWhereTheyHaveOnlyBegun) {
  for (double time = 1; time < 1.2; time += 0.004) {
    std::string text = at(time);
    for (std::size_t i = text.find("face_indices{"); i != text.npos; i = text.find("face_indices{", i + 1))
      EXPECT_NE(std::stoi(text.substr(i + 13)), 0) << time;
  }
}

TEST_F(GrowingCopies, GrowOnWithoutAJump) {
  auto tall = [&](double time) {
    std::optional<Model> now =
        grown_by(*plan_.growing.at({0, 0}), scene_.copy_sets[0].appearance.motion, time);
    float top = 0;
    for (const Vec3& p : now ? now->skeleton.position : std::vector<Vec3>{}) top = std::max(top, p.y);
    return top;
  };
  float last = 0, whole = tall(9);
  for (double time = 1; time < 4; time += 0.05) {
    float now = tall(time);
    EXPECT_GE(now, last - 1e-3f) << time;
    EXPECT_LT(now - last, 0.12f * whole) << time;
    last = now;
  }
  EXPECT_NEAR(last, whole, 0.01f * whole);
}

TEST_F(GrowingCopies, CarryTheirPoresAsTheySway) {
  // The look stands before the matrix, which so moves it, too.
  std::regex line(R"(object\{Model\w+ scale [0-9.]+ Model\w+_Look\(Tint\d\[\d+\]\) matrix<)");
  std::string grown = at(4.5);
  EXPECT_EQ(std::distance(std::sregex_iterator(grown.begin(), grown.end(), line), std::sregex_iterator()), 9);
  EXPECT_NE(at(2).find("Copy_Coral("), std::string::npos);
}

TEST_F(GrowingCopies, OfAStillAreGrown) {
  Scene still = sown_reef(R"({"frames": 1, "size": [160, 100]})");
  EXPECT_FALSE(copy_growth(still.copy_sets[0].organism, still.film, 0));
}

}  // namespace
}  // namespace frond
