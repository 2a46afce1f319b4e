// Branches to which edits give another bark, in POV-Ray's text.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/bounds.h"
#include "draw/draw_list.h"
#include "emit/texts.h"
#include "scene/scene.h"

namespace frond {
namespace {

std::string frame_of(const std::string& organism, const std::string& edits) {
  const std::string text =
      R"({"film": {"frames": 1, "size": [160, 120]}, "scene": {"setting": "studio"}, "organisms": [{"name": "one",
  "place": {"at": [[0, 0]], "size_variation": 0}, )" +
      organism + (edits.empty() ? "" : R"(, "edits": [)" + edits + "]") + "}]}";
  Result<Preset> preset = read_preset(text, "bark.json", {});
  EXPECT_TRUE(preset) << preset.errors().front().text();
  return text_of(*build_scene(*preset), 1);
}

const std::string kCross =
    R"("kind": "plant", "height": 0, "grammar": {"axiom": "FF[+(90)FFFF][-(90)FFFF]FF", "length": 0.3},
       "bark": {"young_length": 0, "variation": 0})";
const std::string kAspen =
    R"("kind": "weber_penn", "tree": {"scale": 4, "levels": 2, "leaves": 0, "branches": {"branches": 12}},
       "coat": {"pixels": 16})";

TEST(OtherBark, IsDeclaredAndWornBySweeps) {
  const std::string plain = frame_of(kCross, ""),
                    painted = frame_of(kCross, R"({"at": "1", "bark": {"kind": "ink", "color": [1, 0, 0]}})");
  EXPECT_EQ(count(plain, "Plant_Bark("), 1u);
  EXPECT_EQ(count(painted, "Plant_Bark("), 2u);
  EXPECT_EQ(count(painted, "Plant_Bark(1,3,srgb<1,0,0>"), 1u) << "ink, red";
  EXPECT_EQ(count(plain, "Skin[1]"), 0u);
  EXPECT_GT(count(painted, "texture{Skin[1]"), 0u);
  EXPECT_EQ(count(plain, "sphere_sweep"), count(painted, "sphere_sweep"));
}

TEST(OtherBark, IsWornByFusedBodies) {
  const std::string fused = kCross + R"(, "body": {"build": "fused", "voxel": 0.02})";
  const std::string painted = frame_of(fused, R"({"at": "1", "bark": {"kind": "ink", "color": [1, 0, 0]}})");
  EXPECT_EQ(count(frame_of(fused, ""), "Skin[1]"), 0u);
  EXPECT_GT(count(painted, "Skin[1]"), 0u);
}

TEST(OtherBark, IsAPictureOfItsOwnOnATreeThatWearsOne) {
  const std::string plain = frame_of(kAspen, ""),
                    dead = frame_of(kAspen, R"({"at": "3", "bark": {"color": "#998f88", "lichens": 0.6}})");
  EXPECT_EQ(count(plain, "Tree_Bark("), 1u);
  EXPECT_EQ(count(dead, "Tree_Bark("), 2u);
  EXPECT_EQ(count(dead, "sphere_sweep"), 0u);
  // One that is not of wood wears no picture.
  const std::string metal = frame_of(kAspen, R"({"at": "3", "bark": {"kind": "metal"}})");
  EXPECT_EQ(count(metal, "Tree_Bark("), 1u);
  EXPECT_GT(count(metal, "sphere_sweep"), 0u);
  EXPECT_GT(count(metal, "texture{Skin[1]}"), 0u);
  // What does not wear the picture is not in its mesh.
  auto corners = [](const std::string& text) {
    const std::string begin = "vertex_vectors{";
    const std::size_t at = text.find(begin);
    return at == text.npos ? 0 : std::stoi(text.substr(at + begin.size()));
  };
  EXPECT_LT(corners(metal), corners(plain));
  EXPECT_GT(corners(metal), corners(plain) / 2);
}

TEST(OtherBark, BeginsWhereItIsToOnAStraightStemWhoseRingsDoNotShow) {
  const std::string text =
      R"({"film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [{"place": {"at": [[0, 0]],
  "size_variation": 0, "lean": 0}, )" +
      kAspen + R"(, "edits": [{"at": ":0.7", "bark": {"pattern": "banded"}}]}]})";
  const Scene scene = *build_scene(*read_preset(text, "bark.json", {}));
  const DrawList drawn(scene.specimens[0], 0);
  const auto coats = drawn.branches->coat_surfaces(Vec3(0, 1, 9), 0.02);
  ASSERT_EQ(coats.size(), 2u);
  auto lowest = [](const Surface& s) {
    float low = 1e9f;
    for (const Vec3& p : s.position) low = std::min(low, p.y);
    return low;
  };
  const Bounds box = bounds_of(drawn.model);
  EXPECT_GT(lowest(coats[1].second), box.low.y + 0.5f * box.size().y);
  EXPECT_LT(lowest(coats[0].second), box.low.y + 0.2f * box.size().y);
}

}  // namespace
}  // namespace frond
