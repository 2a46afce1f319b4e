#include "studio/view.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <tuple>
#include <utility>

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

TEST(View, StoneSaysHowMossyItIs) {
  std::string path = FROND_ROOT "/presets/garden/rocks.json";
  Result<Preset> preset = read_preset(*read_file(path), path, {"/organisms/0/depth=3"});
  ASSERT_TRUE(preset) << preset.errors().front().text();
  preset->organisms.resize(1);
  Scene scene = *build_scene(*preset);
  auto parts = specimen_parts(scene.specimens.at(0), 0);
  ASSERT_TRUE(parts && parts->size() == 1u);
  EXPECT_DOUBLE_EQ(parts->front().head["material"]["moss"]["share"], 0.6);
}

TEST(View, ACrownOfLooseLeavesIsThinnedAndKeepsItsArea) {
  Surface crown;
  for (int i = 0; i < 600; ++i) {
    Vec3 at(0.1f * static_cast<float>(i % 25), 0.1f * static_cast<float>(i / 25), 0);
    auto first = static_cast<std::uint32_t>(crown.position.size());
    for (Vec3 corner : {Vec3(0), Vec3(0.05f, 0, 0), Vec3(0, 0.05f, 0)}) {
      crown.position.push_back(at + corner);
      crown.normal.emplace_back(0, 0, 1);
    }
    crown.triangle.push_back({first, first + 1, first + 2});
  }
  std::vector<float> places;
  for (int i = 0; i < 100; ++i) places.insert(places.end(), {0, 0, 0, 0, 0, 0, 1, 20, 20, 20});
  DrawnPart part;
  add_placed(part, crown, places, false);
  ASSERT_GE(part.head["coarse"].size(), 2u);
  EXPECT_EQ(count_of(part, "/coarse/0/index"), 3 * 100u);
  // A leaf of 5 cm that stands for six, 20 times as large.
  EXPECT_NEAR(part.head["coarse"][0]["size"], 20 * std::sqrt(6 * 0.05 * 0.05 / 2), 0.01);
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
  std::string path = FROND_ROOT "/tests/presets/staghorn.json";
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

TEST(View, AnyNumberOfTheFirstBranchesHangsTogether) {
  for (auto [name, set] : {std::pair{"../tests/presets/staghorn", "/organisms/0/steps=4"},
                           {"trees/birch", "/organisms/0/years=6"}}) {
    std::string path = std::string(FROND_ROOT "/presets/") + name + ".json";
    Result<Preset> preset = read_preset(*read_file(path), path, {set});
    ASSERT_TRUE(preset) << preset.errors().front().text();
    preset->organisms.resize(1);
    Scene scene = *build_scene(*preset);
    auto parts = specimen_parts(scene.specimens.at(0), 0);
    ASSERT_TRUE(parts);
    auto tubes = std::ranges::find_if(*parts, [](const DrawnPart& p) { return p.head["kind"] == "tubes"; });
    ASSERT_NE(tubes, parts->end());
    std::vector<Sent> segments = sent(*tubes);
    ASSERT_GT(segments.size(), 100u) << name;
    auto order = [](Vec3 a, Vec3 b) { return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z); };
    std::set<Vec3, decltype(order)> reached(order);
    reached.insert(segments.front().from);
    std::size_t afloat = 0;
    for (const Sent& s : segments) {
      afloat += !reached.contains(s.from);
      reached.insert(s.to);
    }
    EXPECT_EQ(afloat, 0u) << name << ", of " << segments.size();
  }
}

TEST(View, SnowLiesOnTheBoughs) {
  std::string path = FROND_ROOT "/presets/trees/birch.json";
  std::string snow = R"(/scene/snow={"depth": 0.2})";
  for (bool snowy : {false, true}) {
    std::vector<std::string> sets{"/organisms/0/years=6"};
    if (snowy) sets.push_back(snow);
    Result<Preset> preset = read_preset(*read_file(path), path, sets);
    ASSERT_TRUE(preset) << preset.errors().front().text();
    preset->organisms.resize(1);
    Scene scene = *build_scene(*preset);
    auto parts = specimen_parts(scene.specimens.at(0), 0);
    ASSERT_TRUE(parts);
    auto white = std::ranges::count_if(*parts, [](const DrawnPart& p) {
      return p.head["kind"] == "mesh" && p.head["material"]["color"][0].get<double>() > 0.98;
    });
    EXPECT_EQ(white > 0, snowy);
  }
}

TEST(View, ThePathOfAForestIsToBeSeen) {
  Result<Preset> preset = read_preset(
      R"({"scene": {"setting": "forest", "forest": {"terrain": {"path": {"points": [[-20, 0], [20, 0]]}}}}, "organisms": []})",
      "wood.json", {});
  ASSERT_TRUE(preset) << preset.errors().front().text();
  Result<Scene> scene = build_scene(*preset);
  ASSERT_TRUE(scene) << scene.errors().front().text();
  ViewCache cache(std::make_shared<CacheBudget>(std::size_t{1} << 26));
  Result<std::string> packet = view_of(*scene, *preset, {}, cache, Json::object());
  ASSERT_TRUE(packet);
  EXPECT_NE(packet->find("\"colors\""), packet->npos);
}

}  // namespace
}  // namespace frond
