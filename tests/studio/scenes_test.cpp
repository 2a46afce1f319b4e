#include "studio/scenes.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include "core/files.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

class ScenesTest : public testing::Test {
 protected:
  Answer view(Scenes& scenes, const std::string& text, double time = 0) {
    return scenes.view({text, kFile}, {{"time", time}}, "tab", ++number_);
  }
  Preset preset(const std::string& text, const std::vector<std::string>& sets = {}) const {
    Result<Preset> read = documents_.preset({text, kFile}, sets);
    EXPECT_TRUE(read);
    return read ? *read : Preset{};
  }
  static std::string text_of(int seed) {
    return R"({"seed": )" + std::to_string(seed) +
           R"(, "film": {"frames": 8, "fps": 8}, "scene": {"setting": "studio"},)" +
           R"( "organisms": [{"kind": "massive", "place": {"at": [[0, 0]]}}, {"kind": "coral"}]})";
  }

  const fs::path kFile = fs::weakly_canonical(fs::absolute(FROND_ROOT "/presets/made_up.json"));
  Documents documents_{{.home = FROND_ROOT, .preset = {}, .assets = {}, .ready = {}}};
  std::uint64_t number_ = 0;
};

TEST_F(ScenesTest, ARenderTakesTheSceneOfTheView) {
  Scenes scenes(documents_, std::size_t{1} << 30);
  std::string text = text_of(1);
  ASSERT_EQ(view(scenes, text).status, 200);
  auto same = scenes.scene({text, kFile}, preset(text), {}),
       again = scenes.scene({text, kFile}, preset(text), {});
  ASSERT_TRUE(same && again);
  EXPECT_EQ(*same, *again);
  auto larger = scenes.scene({text, kFile}, preset(text, {"/film/size=[640,480]"}), {});
  ASSERT_TRUE(larger);
  EXPECT_NE(*larger, *same) << "it has another size";
  EXPECT_TRUE((*larger)->grown.empty()) << "but grows nothing anew";
  EXPECT_EQ((*larger)->film.size[0], 640);
}

TEST_F(ScenesTest, KeepsNoMoreThanItMayAndGrowsAgainWhatItGaveUp) {
  constexpr std::size_t kRoom = 6 << 20;
  Scenes scenes(documents_, kRoom);
  ASSERT_EQ(view(scenes, text_of(1)).status, 200);
  for (int seed = 2; seed < 8; ++seed)
    for (double time : {0.0, 0.5}) {
      ASSERT_EQ(view(scenes, text_of(seed), time).status, 200);
      EXPECT_LE(scenes.kept(), kRoom);
    }
  auto first = scenes.scene({text_of(1), kFile}, preset(text_of(1)), {});
  ASSERT_TRUE(first);
  EXPECT_FALSE((*first)->grown.empty());
}

TEST_F(ScenesTest, CountsTheMemoryThatItKeeps) {
  Scenes scenes(documents_, std::size_t{1} << 30);
  auto in_use = [] {
    struct mallinfo2 now = mallinfo2();
    return static_cast<double>(now.uordblks + now.hblkhd);
  };
  ASSERT_EQ(view(scenes, text_of(1)).status, 200);  // with all that is made once
  double kept = static_cast<double>(scenes.kept()), used = in_use();
  for (int seed = 2; seed < 6; ++seed) ASSERT_EQ(view(scenes, text_of(seed)).status, 200);
  kept = static_cast<double>(scenes.kept()) - kept, used = in_use() - used;
  EXPECT_GT(kept, 1e6);
  EXPECT_NEAR(kept / used, 1, 0.25) << kept << " bytes are counted, " << used << " were taken";
}

}  // namespace
}  // namespace frond
