#include <gtest/gtest.h>

#include <filesystem>

#include "emit/copies.h"
#include "film/film_files.h"
#include "scene/scene.h"

namespace frond {
namespace {

/// A sown reef of corals that say this besides.
Scene worn_reef(const std::string& more) {
  std::string text = R"({"version": 2, "film": {"frames": 60, "fps": 12, "size": [160, 100]},
    "scene": {"setting": "underwater", "camera": {"location": [0, 1, 5], "look_at": [0, 0.2, 0]}},
    "organisms": [
      {"species": "presets/species/corals/bird_nest.json", "count": 5, "wave": {"amplitude": 0},
       "sown": {"models": 2, "where": {"radius": 0.3, "reach": 1.5}})" +
                     more + R"(},
      {"species": "presets/species/corals/honeycomb.json", "count": 4,
       "sown": {"models": 1, "where": {"radius": 0.3, "reach": 1.5}})" +
                     more + R"(}]})";
  Result<Preset> preset = read_preset(text, "sown.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return *build_scene(*preset);
}

struct WornFilm {
  Scene scene;
  CopyPlan plan;

  explicit WornFilm(const std::string& more) : scene(worn_reef(more)) {
    std::filesystem::path folder = std::filesystem::path(testing::TempDir()) /
                                   testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder);
    ProgressSink watch{[](auto, auto) {}, [] {}};
    plan = *write_models(scene, folder, watch);
    std::filesystem::remove_all(folder);
  }
  std::string still() const { return still_copies_text({}, scene, plan, 0).text; }
  std::string worn(double time) const { return worn_copies_text(scene, plan, 0, time); }
};

std::size_t times(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t i = text.find(what); i != text.npos; i = text.find(what, i + 1)) ++n;
  return n;
}

TEST(WornCopies, ChangeTheirLooksAndNotTheirPlaces) {
  WornFilm ailing(R"(, "health": [[0, 1], [3, 0.4]])"), plain("");
  EXPECT_EQ(plain.worn(2), "");
  EXPECT_NE(ailing.worn(0), ailing.worn(2));
  EXPECT_EQ(ailing.worn(2), ailing.worn(2));
  // A macro for each part of a model, however many copies there are.
  EXPECT_GE(times(ailing.worn(2), "#macro"), 3u);
  EXPECT_LE(times(ailing.worn(2), "#macro"), 6u);
  EXPECT_EQ(times(ailing.still(), "object{"), times(plain.still(), "object{"));
  EXPECT_EQ(times(ailing.still(), "_Look(") - times(plain.still(), "_Look("), 0u);
  EXPECT_GE(times(ailing.still(), "Worn"), 2u);
  EXPECT_EQ(times(plain.still(), "Worn"), 0u);
  for (const auto& files : {ailing.plan.files, plain.plan.files})
    for (const ModelFile& file : files) EXPECT_FALSE(file.name.empty());
  EXPECT_EQ(ailing.plan.files[0].name, plain.plan.files[0].name) << "the files are those of healthy ones";
}

TEST(WornCopies, TakeTheirTintsInEachFrame) {
  WornFilm tinted(R"(, "tint": {"hue": [[0, 0], [3, 90]]})");
  EXPECT_EQ(times(tinted.still(), "#declare Tint"), 0u);
  EXPECT_EQ(times(tinted.worn(1), "#declare Tint"), 2u);
  EXPECT_NE(tinted.worn(0), tinted.worn(1));
}

TEST(WornCopies, GrowAndPaleAtOnce) {
  WornFilm both(R"(, "growth": {"start": 0, "duration": 4}, "health": [[0, 1], [3, 0.4]])");
  std::string early = swaying_copies_text({}, both.scene, both.plan, 1, 0.8).text,
              late = swaying_copies_text({}, both.scene, both.plan, 1, 3.9).text;
  EXPECT_NE(early.find("object{Growing"), std::string::npos);
  EXPECT_NE(early, late);
}

}  // namespace
}  // namespace frond
