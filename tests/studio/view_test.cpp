#include "studio/view.h"

#include <gtest/gtest.h>

#include "core/files.h"

namespace frond {
namespace {

std::size_t count_of(const DrawnPart& part, std::string_view place) {
  for (const WireArray& array : part.arrays)
    if (array.place == place) return array.count;
  return 0;
}

TEST(View, EachCornerOfABodyHasItsColor) {
  for (const char* build : {"voxels", "fused"}) {
    std::string path = FROND_ROOT "/presets/voxel.json";
    Result<Preset> preset = read_preset(
        *read_file(path), path, {"/organisms/0/steps=2", std::string("/organisms/0/body/build=") + build});
    ASSERT_TRUE(preset) << preset.errors().front().text();
    Scene scene = *build_scene(*preset);
    auto parts = specimen_parts(scene.specimens.at(0), 0);
    ASSERT_TRUE(parts && parts->size() == 1u);
    std::size_t corners = count_of(parts->front(), "/position") / 3;
    EXPECT_GT(corners, 100u);
    EXPECT_EQ(count_of(parts->front(), "/colors"), 4 * corners) << build;
  }
}

}  // namespace
}  // namespace frond
