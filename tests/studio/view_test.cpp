#include "studio/view.h"

#include <gtest/gtest.h>

#include <cstring>

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

/// A segment as it is sent.
struct Sent {
  Vec3 from, to;
  std::int8_t headings[8];
  std::uint8_t colors[8];

  std::uint32_t along() const { return colors[3] | static_cast<std::uint32_t>(colors[7]) << 8; }
};
std::vector<Sent> sent(const DrawnPart& part) {
  const std::string& bytes = *part.arrays.at(0).bytes;
  std::vector<Sent> list(bytes.size() / 48);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const char* at = bytes.data() + 48 * i;
    std::memcpy(&list[i].from, at, 12), std::memcpy(&list[i].to, at + 16, 12);
    std::memcpy(list[i].headings, at + 32, 8), std::memcpy(list[i].colors, at + 40, 8);
  }
  return list;
}

TEST(View, APictureOfTheBarkGoesOnFromSegmentToSegment) {
  std::string path = FROND_ROOT "/presets/staghorn.json";
  Result<Preset> preset = read_preset(*read_file(path), path, {"/organisms/0/steps=2"});
  ASSERT_TRUE(preset) << preset.errors().front().text();
  Scene scene = *build_scene(*preset);
  auto parts = specimen_parts(scene.specimens.at(0), 0);
  ASSERT_TRUE(parts);
  auto tubes = std::ranges::find_if(*parts, [](const DrawnPart& p) { return p.head["kind"] == "tubes"; });
  ASSERT_NE(tubes, parts->end());
  double high = tubes->head["tile"]["high"];
  std::vector<Sent> segments = sent(*tubes);
  std::size_t joints = 0;
  for (const Sent& below : segments)
    for (const Sent& above : segments) {
      // Forks begin with a picture of their own direction, but as far along.
      if (above.from != below.to || std::memcmp(below.headings + 4, above.headings, 3) != 0) continue;
      double reached = below.along() / 65536.0 + glm::distance(below.from, below.to) / high,
             gap = reached - above.along() / 65536.0;
      EXPECT_NEAR(gap, std::round(gap), 1e-3);
      ++joints;
    }
  EXPECT_GT(joints, segments.size() / 2);
}

}  // namespace
}  // namespace frond
