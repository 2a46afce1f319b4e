#include "draw/focus.h"

#include <gtest/gtest.h>

#include <cmath>

#include "emit/camera.h"
#include "scene/camera.h"
#include "scene_at.h"

namespace frond {
namespace {

/// A slender column of 2 m before a thick one, and a bush that sways.
Scene three(const std::string& camera) {
  return *build_scene(*read_preset(R"({"film": {"frames": 24, "fps": 24}, "scene": {"setting": "studio",
      "camera": {"aperture": 1.4, )" + camera +
                                       R"(}}, "organisms": [
        {"kind": "column", "name": "near", "height": 2, "place": {"at": [[0, 2]]}},
        {"kind": "column", "name": "far", "height": 2, "place": {"at": [[2, -3]]}},
        {"kind": "plant", "name": "bush", "height": 2, "place": {"at": [[-2, 0]]}, "wave": {"amplitude": 20},
         "grammar": {"axiom": "A", "steps": 5, "angle": 28, "rules": ["A -> F[+A][-A]&A"]}}]})",
                                   "test.json", {}));
}

/// Width on film of the blur of a point at that depth, where the camera focuses on another.
double blur_circle(double depth, double focus) { return std::abs(depth - focus) / depth / focus; }

TEST(Focus, BlurIsLeastOnTheOrganismNamed) {
  const std::string stands = R"("location": [0, 1, 8], "look_at": [0, 1, 0], "focus": )";
  for (const char* name : {"near", "far", "bush"}) {
    Scene scene = three(stands + '"' + name + '"');
    Lens lens = lens_at(scene.setup.camera, 0, scene.film.aspect());
    std::optional<Vec3> at = named_focus(scene, 0);
    ASSERT_TRUE(at) << name;
    Vec3 seen = lens.seen(*at);
    EXPECT_NEAR(seen.x, 0, 1e-4);
    EXPECT_NEAR(seen.y, 0, 1e-4);
    auto blur_of = [&](const Specimen& s) {
      double least = 1e9;
      for (const Vec3& p : s.model.skeleton.position)
        least = std::min(least, blur_circle(lens.seen(p).z, seen.z));
      for (std::size_t i = 0; i < s.model.solids.size(); ++i)
        for (const Vec3& p : s.model.solids.shapes[s.model.solids.shape[i]].surface.position)
          least = std::min(least, blur_circle(lens.seen(s.model.solids.placed(i, p)).z, seen.z));
      return least;
    };
    double own = 1e9, others = 1e9;
    for (const Specimen& s : scene.specimens)
      if (s.entry != Traits::kNoEntry)
        (s.name == name ? own : others) = std::min(s.name == name ? own : others, blur_of(s));
    EXPECT_LT(own, 0.002) << name;
    EXPECT_LT(own, 0.2 * others) << name;
  }
}

TEST(Focus, IsOnTheNearSideOfWhatStandsOnTheAxis) {
  Scene scene = three(R"("location": [0, 1, 8], "look_at": [0, 1, 0], "focus": "near")");
  double depth = 8 - named_focus(scene, 0)->z, front = 1e9;
  for (const Specimen& s : scene.specimens)
    if (s.name == "near")
      for (std::size_t i = 0; i < s.model.solids.size(); ++i)
        for (const Vec3& p : s.model.solids.shapes[s.model.solids.shape[i]].surface.position) {
          Vec3 at = s.model.solids.placed(i, p);
          if (std::abs(at.y - 1) < 0.3) front = std::min(front, 8.0 - at.z);
        }
  EXPECT_NEAR(depth, front, 0.03);
  EXPECT_LT(depth, 6) << "nearer than its middle";
}

TEST(Focus, GoesWithTheCameraAndWithWhatMoves) {
  Scene scene =
      three(R"("location": [[0, [0, 1, 8]], [1, [0, 1, 12]]], "look_at": [0, 1, 0], "focus": "near")");
  auto from_camera = [&](double time) {
    return glm::distance(*named_focus(scene, time), scene.setup.camera.location.at(time));
  };
  EXPECT_NEAR(from_camera(1) - from_camera(0), 4, 0.03);
  Scene sways = three(R"("location": [-2, 1.5, 5], "look_at": [-2, 1.5, 0], "focus": "bush")");
  bool moved = false;
  for (double t : {0.25, 0.5, 0.75})
    moved = moved || glm::distance(*named_focus(sways, t), *named_focus(sways, 0)) > 1e-3;
  EXPECT_TRUE(moved);
}

TEST(Focus, IsAskedForByNameAndLensOnly) {
  EXPECT_FALSE(named_focus(three(R"("location": [0, 1, 8], "focus": [0, 1, 0])"), 0));
  Scene sharp = three(R"("location": [0, 1, 8], "focus": "near")");
  sharp.setup.camera.aperture.reset();
  EXPECT_FALSE(named_focus(sharp, 0));
  Scene behind = three(R"("location": [0, 1, -20], "look_at": [0, 1, -30], "focus": "near")");
  EXPECT_FALSE(named_focus(behind, 0)) << "it is behind the camera";
  Camera plain = behind.setup.camera;
  plain.focus.reset();
  EXPECT_EQ(camera_text({}, behind.setup.camera, behind.film, 0), camera_text({}, plain, behind.film, 0))
      << "then what it looks at is sharp";
}

TEST(Focus, NamesOfOrganismsSownAreGood) {
  Scene scene = *build_scene(*read_preset(R"({"film": {"frames": 1}, "scene": {"setting": "meadow",
      "camera": {"location": [0, 1, 8], "look_at": [0, 0.5, 0], "aperture": 2, "focus": "herb"}}, "organisms": [
        {"kind": "plant", "name": "herb", "height": 0.5, "count": 1, "sown": {"where": {"radius": 0.2}}, "place": {"at": [[0, 0]]},
         "grammar": {"axiom": "F", "steps": 1}}]})",
                                          "test.json", {}));
  ASSERT_FALSE(scene.copy_sets.empty());
  std::optional<Vec3> at = named_focus(scene, 0);
  EXPECT_EQ(at.has_value(), scene.copy_sets[0].copies.size() > 0);
}

}  // namespace
}  // namespace frond
