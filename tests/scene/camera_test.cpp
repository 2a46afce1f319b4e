#include "scene/camera.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/fit.h"
#include "scene/scene.h"

namespace frond {
namespace {

TEST(Camera, FollowsTheGround) {
  auto scene_of = [](const std::string& camera) {
    return *build_scene(*read_preset(R"({"film": {"frames": 96, "fps": 24}, "scene": {"setting": "forest",
        "forest": {"terrain": {"hills": 16}}, "camera": {"look_at": [0, 1, 0], )" +
                                         camera + "}}}",
                                     "test.json", {}));
  };
  const std::string walk = R"("location": [[0, [-60, 1.7, 20]], [2, [0, 1.7, 35]], [4, [50, 3, -10]]])";
  Scene still = scene_of(walk), follows = scene_of(walk + R"(, "follow": true)");
  const Heights& heights = follows.ground->heights();
  double least = 1e9, most = -1e9;
  for (double t = 0; t <= 4; t += 0.05) {
    Vec3 given = still.setup.camera.location.at(t), at = follows.setup.camera.location.at(t);
    EXPECT_NEAR(at.x, given.x, 0.1);
    EXPECT_NEAR(at.z, given.z, 0.1);
    double ground = heights(at.x, at.z);
    EXPECT_NEAR(at.y - ground, given.y, 0.5) << t;
    least = std::min(least, ground), most = std::max(most, ground);
  }
  EXPECT_GT(most - least, 3) << "hill and dale";
  EXPECT_TRUE(follows.setup.camera.look_at.constant());
  EXPECT_NEAR(follows.setup.camera.look_at.at(0).y, 1, 0.2);
  EXPECT_EQ(still.setup.camera.location.at(1).y, 1.7f);
}

/// A bush of one rule and a column, before a camera that fits.
Scene fitting(const std::string& camera, const std::string& size) {
  return *build_scene(*read_preset(R"({"film": {"frames": 1, "size": )" + size +
                                       R"(}, "scene": {"setting": "studio", "camera": {)" + camera + R"(}},
      "organisms": [
        {"kind": "plant", "name": "bush", "height": 2, "place": {"at": [[3, -2]]},
         "grammar": {"axiom": "A", "steps": 5, "angle": 28, "rules": ["A -> F[+A][-A]&A"]}},
        {"kind": "column", "name": "column", "place": {"at": [[-4, 1]]}}]})",
                                   "test.json", {}));
}

TEST(Camera, ComesCloseToAPart) {
  auto scene_of = [](const std::string& part) {
    return *build_scene(*read_preset(
        R"({"film": {"frames": 1}, "taxon": {"latin": "X", "leaf": {"organ": "L", "size": [0.1, 0.2]}},
        "scene": {"setting": "studio", "camera": {"location": [0, 1.5, 9], "look_at": [0, 1, 0], "fit": ["bush"], "part": ")" +
            part + R"("}},
        "organisms": [{"kind": "plant", "name": "bush", "height": 1, "place": {"at": [[0, 0]]},
          "grammar": {"axiom": "A", "steps": 4, "angle": 28, "rules": ["A -> F[+A~L][-A~L]&A"]},
          "organs": [{"symbol": "L", "shape": "leaf", "size": 0.15}]}]
})",
        "test.json", {}));
  };
  for (const char* part : {"leaf", "L"}) {
    Scene scene = scene_of(part);
    Lens lens = lens_at(scene.setup.camera, 0, scene.film.aspect());
    const Organs& organs = scene.specimens.at(0).model.organs;
    ASSERT_GT(organs.size(), 4u);
    bool shown = false;
    for (const Vec3& at : organs.position) {
      Vec3 seen = lens.seen(at);
      shown = shown || (seen.z > 0 && seen.z < 2 && std::abs(seen.x) < 0.6f && std::abs(seen.y) < 0.6f);
    }
    EXPECT_TRUE(shown) << part;
    EXPECT_LT(glm::distance(scene.setup.camera.location.at(0), scene.setup.camera.look_at.at(0)), 1);
    EXPECT_TRUE(scene.notes.empty());
  }
  Scene none = scene_of("fruit");
  ASSERT_EQ(none.notes.size(), 1u);
  EXPECT_NE(none.notes[0].find("there is no \"fruit\" to come close to; organs here are L"),
            std::string::npos)
      << none.notes[0];
}

TEST(Camera, FitsWhatIsNamedIntoAPictureOfAnyShape) {
  for (const char* size : {"[640, 360]", "[360, 640]", "[900, 100]"})
    for (const char* way : {R"("location": [0, 1.7, 9], "look_at": [0, 1.2, 0])",
                            R"("location": [7, 6, 5], "look_at": [0, 0.5, 0], "angle": 70)",
                            R"("location": [0, 9, 0], "look_at": [0, 0, 0])"})
      for (const char* whom : {R"(["bush"])", R"(["all"])"}) {
        Scene scene = fitting(std::string(way) + R"(, "margin": 0.1, "fit": )" + whom, size);
        double aspect = static_cast<double>(scene.film.size[1]) / scene.film.size[0];
        Lens lens = lens_at(scene.setup.camera, 0, aspect);
        float most = 0;
        for (const Specimen& s : scene.specimens) {
          if (s.name != "bush" && (s.name != "column" || std::string(whom) == R"(["bush"])")) continue;
          std::vector<Vec3> places = s.model.skeleton.position;
          for (std::size_t i = 0; i < s.model.solids.size(); ++i)
            for (const Vec3& p : s.model.solids.shapes[s.model.solids.shape[i]].surface.position)
              places.push_back(s.model.solids.position[i] +
                               s.model.solids.turn[i] * (p * s.model.solids.scale[i]));
          for (const Vec3& p : places) {
            Vec3 at = lens.seen(p);
            EXPECT_GT(at.z, 0);
            most = std::max({most, std::abs(at.x), std::abs(at.y)});
          }
        }
        EXPECT_LE(most, 0.82) << size << way << whom << ": a margin of a tenth at each edge";
        EXPECT_GE(most, 0.74) << size << way << whom << ": it fills the picture";
        Vec3 at = lens.at;
        EXPECT_GT(at.y, scene.ground->heights()(at.x, at.z)) << size << way << whom;
      }
}

TEST(Camera, FitsAtEachKeyframe) {
  Scene scene = fitting(R"("location": [[0, [0, 2, 9]], [1, [9, 2, 0]], [2, [0, 5, -9]]], "fit": ["column"])",
                        "[320, 240]");
  EXPECT_EQ(scene.setup.camera.location.keys().size(), 3u);
  for (double time : {0.0, 1.0, 2.0}) {
    Vec3 at = lens_at(scene.setup.camera, time, 0.75).seen(Vec3(-4, 0.5f, 1));
    EXPECT_LT(std::max(std::abs(at.x), std::abs(at.y)), 1) << time;
  }
}

/// Points of a box, as wide and as high, a metre before the origin on uneven ground.
std::vector<Vec3> box_of(float wide, float high) {
  std::vector<Vec3> points;
  for (float x : {-wide / 2, wide / 2})
    for (float y : {0.0f, high})
      for (float z : {-wide / 2, wide / 2}) points.push_back({x + 2, y, z - 1});
  return points;
}

TEST(Camera, ComposesByLightThirdsAndHeight) {
  const Heights ground([](double x, double z) { return 0.02 * x - 0.01 * z; });
  constexpr double kOff[] = {40, 80, 140};
  for (Vec3 sun : {Vec3(0.7, 0.3, 0.2), Vec3(-0.2, 0.8, -0.9)})
    for (auto [wide, high] : {std::pair{2.0f, 9.0f}, {6.0f, 1.5f}, {0.3f, 0.4f}})
      for (int light = 0; light < 3; ++light)
        for (Third third : {Third::left, Third::middle, Third::right}) {
          Camera camera;
          camera.compose = Composition{.light = static_cast<LightSide>(light + 1), .third = third};
          camera.compose->height = std::min(0.7, 0.8 * static_cast<double>(high));
          constexpr double kAspect = 9.0 / 16;
          Camera moved = fitted(camera, box_of(wide, high), kAspect, ground, sun);
          EXPECT_FALSE(moved.compose);
          Vec3 at = moved.location.at(0), toward = glm::normalize(moved.look_at.at(0) - at);
          EXPECT_NEAR(at.y - ground(at.x, at.z), camera.compose->height, 0.01) << wide << " " << high;
          Vec2 flat = glm::normalize(Vec2(toward.x, toward.z)), to_sun = glm::normalize(Vec2(sun.x, sun.z));
          EXPECT_NEAR(degrees(std::acos(glm::dot(flat, to_sun))), kOff[light], 0.5);
          Vec3 right = glm::cross(toward, Vec3(0, 1, 0));
          bool from_right = glm::dot(sun, right) > 0;
          EXPECT_TRUE(third == Third::middle || from_right == (third == Third::left));
          Lens lens = lens_at(moved, 0, kAspect);
          float left = 1, most = -1, low = 1, top = -1;  // shares of half the picture
          for (const Vec3& p : box_of(wide, high)) {
            Vec3 seen = lens.seen(p);
            ASSERT_GT(seen.z, 0);
            left = std::min(left, seen.x), most = std::max(most, seen.x);
            low = std::min(low, seen.y), top = std::max(top, seen.y);
          }
          EXPECT_GT(left, -1.001);
          EXPECT_LT(most, 1.001);
          EXPECT_LT(top, 1 - 2 * 0.1 + 0.001) << "headroom";
          EXPECT_GT(low, -1 + 2 * 0.22 - 0.001) << "foreground";
          double middle = third == Third::left ? -1.0 / 3 : third == Third::right ? 1.0 / 3 : 0;
          EXPECT_NEAR((left + most) / 2, middle, 0.25);
          EXPECT_TRUE(top - low > 1.3 || most - left > 1.0) << "it is as large as there is room for";
        }
}

TEST(Camera, ComposesAPreset) {
  Scene scene = fitting(R"("compose": {"light": "back", "height": 0.5})", "[640, 360]");
  EXPECT_NEAR(scene.setup.camera.location.at(0).y, 0.5, 0.02);
  EXPECT_FALSE(scene.setup.camera.compose);
  Scene other = fitting(R"("fit": ["column"], "compose": {"third": "left"})", "[640, 360]");
  EXPECT_NE(scene.setup.camera.location.at(0), other.setup.camera.location.at(0));
}

TEST(Camera, SaysThatItSeesNothing) {
  auto said = [](const std::string& camera) {
    Scene scene = fitting(camera, "[320, 240]");
    return std::ranges::any_of(scene.notes, [](const std::string& note) {
      return note.find("nothing that grows is in the picture") != note.npos;
    });
  };
  EXPECT_TRUE(said(R"("location": [0, 2, 9], "look_at": [0, 2, 20])"));
  EXPECT_FALSE(said(R"("location": [0, 2, 9], "look_at": [0, 2, 0])"));
}

/// A grey picture would not tell what it shows.
TEST(Camera, SaysThatItLiesInsideOfABody) {
  auto note_of = [](const std::string& organisms, const std::string& location, const char* setting) {
    Scene scene = *build_scene(*read_preset(
        fmt::format(R"({{"film": {{"frames": 30}}, "scene": {{"setting": "{}", "camera": {{"location": {},
            "look_at": [0, 1, -30]}}}}, "organisms": [{}]}})",
                    setting, location, organisms),
        "test.json", {}));
    for (const std::string& note : scene.notes)
      if (note.find("lies inside of") != note.npos) return note;
    return std::string();
  };
  const std::string rock =
      R"({"kind": "rock", "name": "boulder", "depth": 5, "size": 4, "place": {"at": [[0, 0]]}})";
  std::string note = note_of(rock, "[0, 1, 0]", "meadow");
  EXPECT_NE(note.find("/scene/camera/location"), note.npos) << note;
  EXPECT_NE(note.find("\"boulder\""), note.npos) << note;
  EXPECT_EQ(note_of(rock, "[0, 1, 9]", "meadow"), "");
  // On its way through.
  note = note_of(rock, "[[0, [0, 1, 9]], [1, [0, 1, -9]]]", "meadow");
  EXPECT_NE(note.find("first at 0."), note.npos) << note;
  const std::string trunk =
      R"({"kind": "tree", "name": "stem", "years": 14, "leaves": {"size": 0}, "flare": 4, "place": {"at": [[0, 0]], "lean": 0}})";
  EXPECT_NE(note_of(trunk, "[0, 0.3, 0]", "meadow").find("\"stem\""), note.npos);
  const std::string vase = R"({"kind": "vase", "name": "vase", "place": {"at": [[0, 0]]}})";
  EXPECT_EQ(note_of(vase, "[0, 0.8, 0]", "studio"), "") << "above a vessel";
}

TEST(Camera, FitsOnlyWhatIsThere) {
  auto wrong = read_preset(
      R"({"scene": {"camera": {"fit": ["oka"]}}, "organisms": [{"kind": "column", "name": "oak"}]})",
      "test.json", {});
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.errors()[0].what.find("oak"), std::string::npos) << wrong.errors()[0].text();
  EXPECT_NE(wrong.errors()[0].where.find("/scene/camera/fit/0"), std::string::npos);
}

}  // namespace
}  // namespace frond
