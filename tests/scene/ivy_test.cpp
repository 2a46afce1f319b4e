#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/files.h"
#include "core/parallel.h"
#include "motion/unfold.h"
#include "scene/scene.h"

namespace frond {
namespace {

const std::string kIvyWall = R"({"kind": "wall", "name": "wall", "width": 2, "height": 1.2,
  "place": {"at": [[1, -2]], "turn_variation": 0, "turn": 30, "lean": 0, "size_variation": 0}})";

Result<Preset> read_ivy(const std::string& organisms, const std::string& film = R"("film": {"frames": 96})") {
  return read_preset("{" + film + R"(, "scene": {"setting": "studio"}, "organisms": [)" + organisms + "]}",
                     "test.json", {});
}

std::string ivy_on(const std::string& name, const std::string& more = "") {
  return R"({"kind": "ivy", "on": [")" + name +
         R"("], "count": 3, "crawl": {"max_age": 70}, "flutter": {"amplitude": 8},
    "growth": {"duration": 3.4, "ripen": 0.3}, "breeze": {"amplitude": 8})" +
         more + "}";
}

TEST(IvyScene, GrowsOnABodyWhereItStands) {
  Scene scene = *build_scene(*read_ivy(kIvyWall + "," + ivy_on("wall")));
  ASSERT_EQ(scene.specimens.size(), 2u);
  const Specimen& ivy = scene.specimens[1];
  ASSERT_TRUE(ivy.life.hanging.has_value());
  ASSERT_GT(ivy.model.organs.size(), 30u);
  // In the wall's own axes every strand that holds on lies on its skin.
  Quat back = glm::angleAxis(static_cast<float>(-radians(30.0)), Vec3(0, 1, 0));
  for (std::size_t i = 0; i < ivy.model.skeleton.size(); ++i) {
    if (ivy.life.hanging->strands.hanging[i]) continue;
    Vec3 p = back * (ivy.model.skeleton.position[i] - Vec3(1, 0, -2));
    EXPECT_LT(std::abs(p.x), 1.06f);
    EXPECT_LT(std::abs(p.z), 0.21f);
    EXPECT_TRUE(std::abs(std::abs(p.z) - 0.12f) < 0.08f || p.y > 1.15f || std::abs(p.x) > 0.9f) << p.z;
  }
}

TEST(IvyScene, IsTheSameAtAnyThreadCount) {
  Preset preset = *read_ivy(kIvyWall + "," + ivy_on("wall"));
  limit_threads(1);
  Scene one = *build_scene(preset);
  limit_threads(2);
  Scene two = *build_scene(preset);
  limit_threads(0);
  EXPECT_EQ(one.specimens[1].model.skeleton.position, two.specimens[1].model.skeleton.position);
  EXPECT_EQ(one.specimens[1].model.organs.position, two.specimens[1].model.organs.position);
}

TEST(IvyScene, NamesWhatItCannotGrowOn) {
  Result<Preset> wrong = read_ivy(kIvyWall + "," + ivy_on("wal"));
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(wrong.errors()[0].text().find("/organisms/1/on/0: no organism \"wal\" to grow on"),
            std::string::npos)
      << wrong.errors()[0].text();
  EXPECT_NE(wrong.errors()[0].text().find("did you mean \"wall\"?"), std::string::npos);
  // Without any body there is nothing to hold on to.
  Result<Preset> alone = read_ivy(R"({"kind": "ivy", "name": "green"})");
  ASSERT_TRUE(alone.ok());
  Result<Scene> scene = build_scene(*alone);
  ASSERT_FALSE(scene.ok());
  EXPECT_NE(scene.errors()[0].text().find("/organisms/0/on: nothing stands here to grow on"),
            std::string::npos)
      << scene.errors()[0].text();
}

/// Where the tip of each leaf is and how large it is, at a time.
struct Shown {
  std::vector<Vec3> tip;
  std::vector<float> size;
};

Shown shown(const Specimen& b, double time) {
  Pose pose;
  pose_specimen(b, time, pose);
  Shown all;
  for (std::size_t i = 0; i < b.model.organs.size(); ++i) {
    const Organs& o = b.model.organs;
    float size = o.scale[i].x * unfolded(o.birth[i], pose.front, b.motion.unfold);
    Quat turn = carried_turn(pose, o.node[i]) * o.turn[i] *
                fluttering(b.motion.flutter, b.motion.film_length, time, o.position[i], o.id[i], o.supple[i]);
    all.tip.push_back(carried(b.model.skeleton, pose, o.node[i], o.position[i]) + turn * Vec3(0, size, 0));
    all.size.push_back(size);
  }
  return all;
}

TEST(IvyScene, UnfoldsWithoutJumps) {
  // While it grows no leaf appears at once: it starts from nothing and no step of a frame is large.
  Scene scene = *build_scene(*read_ivy(kIvyWall + "," + ivy_on("wall")));
  const Specimen& ivy = scene.specimens[1];
  Shown last = shown(ivy, 0);
  double total = 0, count = 0;
  float most = 0;
  EXPECT_LT(*std::max_element(last.size.begin(), last.size.end()), 0.001f);
  for (int frame = 2; frame <= scene.film.frames; ++frame) {
    Shown now = shown(ivy, scene.film.time(frame));
    for (std::size_t i = 0; i < now.size.size(); ++i) {
      EXPECT_GE(now.size[i], last.size[i]);
      EXPECT_LT(now.size[i] - last.size[i], 0.3f * ivy.model.organs.scale[i].x)
          << "leaf " << i << " frame " << frame;
      float step = glm::distance(now.tip[i], last.tip[i]);
      total += step, count += 1, most = std::max(most, step);
    }
    last = now;
  }
  EXPECT_LT(most, 8 * total / count) << "leaves are carried by the tips of their strands";
  for (std::size_t i = 0; i < last.size.size(); ++i)
    EXPECT_NEAR(last.size[i], ivy.model.organs.scale[i].x, 1e-5);
}

TEST(IvyScene, MasksNeedPaintOnTheHost) {
  auto said = [](const std::string& mask) {
    Result<Scene> scene = build_scene(
        *read_ivy(kIvyWall + "," + R"({"kind": "ivy", "crawl": {"max_age": 20, "mask": )" + mask + "}}"));
    return scene.ok() ? "" : scene.errors()[0].text();
  };
  EXPECT_NE(
      said("{}").find("/organisms/1/crawl/mask: what the ivy grows on has no vertex colours; expected a "
                      "mesh whose OBJ file has them"),
      std::string::npos)
      << said("{}");
}

/// Expects that leaves are where they began when a film ends. Returns how far some is from there in between.
float moved_and_back(const Specimen& ivy, double length) {
  Shown first = shown(ivy, 0), again = shown(ivy, length), between = shown(ivy, 0.9);
  float apart = 0, moved = 0;
  for (std::size_t i = 0; i < first.tip.size(); ++i) {
    apart = std::max(apart, glm::distance(first.tip[i], again.tip[i]));
    moved = std::max(moved, glm::distance(first.tip[i], between.tip[i]));
  }
  EXPECT_LT(apart, 1e-4f);
  return moved;
}

TEST(IvyScene, SwingsInGustsAsAFilmThatRepeats) {
  Scene scene = *build_scene(*read_ivy(
      kIvyWall + "," +
      R"({"kind": "ivy", "count": 3, "crawl": {"max_age": 70, "let_go": 1}, "breeze": {"speed": 2}})"));
  const Specimen& ivy = scene.specimens[1];
  ASSERT_TRUE(ivy.life.hanging->paths);
  EXPECT_GT(ivy.life.hanging->paths->node.size(), 20u);
  float moved = moved_and_back(ivy, scene.film.length());
  EXPECT_GT(moved, 2e-3f);
}

TEST(IvyScene, LoopsOnceItIsGrown) {
  Scene scene = *build_scene(
      *read_ivy(kIvyWall + "," + R"({"kind": "ivy", "count": 3, "crawl": {"max_age": 70, "let_go": 1},
      "flutter": {"amplitude": 8}, "breeze": {"amplitude": 8}})"));
  const Specimen& ivy = scene.specimens[1];
  float moved = moved_and_back(ivy, scene.film.length());
  EXPECT_GT(moved, 2e-3f);
}

}  // namespace
}  // namespace frond
