#include "emit/solid.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

/// A level skin of a metre, grown from half of that.
Solids skin_with_polyps() {
  Solid skin;
  skin.surface.position = {{-0.5f, 0, -0.5f}, {0.5f, 0, -0.5f}, {0.5f, 0, 0.5f}, {-0.5f, 0, 0.5f}};
  skin.surface.triangle = {{0, 2, 1}, {0, 3, 2}};
  skin.surface.uv = {{1, 0}, {1, 0}, {1, 0}, {1, 0}};
  set_normals(skin.surface);
  skin.past = {{}};
  for (Vec3 p : skin.surface.position) skin.past[0].push_back(0.5f * p);
  skin.material.matter = Matter::polyps;
  skin.material.polyps.width = 0.05;
  Solids solids;
  solids.place(solids.add_shape(skin));
  return solids;
}

std::size_t count_of(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find("object{Polyp"); at != std::string::npos;
       at = text.find("object{Polyp", at + 1))
    ++count;
  return count;
}

std::string text_of(const Solids& solids, const Growth& growth, double time, const Eye& eye) {
  std::string text;
  for (const DrawnPolyps& polyps : drawn_polyps(solids, polyp_places(solids), growth, time, eye))
    text += polyps_text({}, polyps, time).text;
  return text;
}

TEST(Polyps, StandApartOnTheSideThatIsSeen) {
  Solids solids = skin_with_polyps();
  Growth grown{.start = -1, .duration = 0};
  Eye above = eye_toward({0, 2, 0.1f}, {0, 0, 0}, 1, 1, 0.001),
      below = eye_toward({0, -2, 0.1f}, {0, 0, 0}, 1, 1, 0.001);
  std::size_t seen = count_of(text_of(solids, grown, 1, above));
  // At 0.85 of their width apart, no two nearer; about as dense as darts that find no room any more.
  EXPECT_GT(seen, 250u);
  EXPECT_LT(seen, 640u);
  EXPECT_EQ(count_of(text_of(solids, grown, 1, below)), 0u);
  Eye far = eye_toward({0, 200, 0.1f}, {0, 0, 0}, 1, 1, 0.001);
  EXPECT_EQ(count_of(text_of(solids, grown, 1, far)), 0u) << "too small to be seen";
  EXPECT_EQ(text_of(solids, {.start = 5, .duration = 1}, 1, above), "") << "it has not begun to grow";
}

TEST(Polyps, OpenAndCloseByTheHour) {
  Solids solids = skin_with_polyps();
  solids.shapes[0].material.polyps.open = Animated<double>({{0, 0}, {4, 1}});
  Growth grown{.start = -1, .duration = 0};
  Eye eye = eye_toward({0, 2, 0.1f}, {0, 0, 0}, 1, 1, 0.001);
  std::string closed = text_of(solids, grown, 0, eye), open = text_of(solids, grown, 4, eye);
  EXPECT_EQ(count_of(closed), count_of(open));
  // Where they stand is the same, their shape is not.
  EXPECT_EQ(closed.substr(closed.find("union{")), open.substr(open.find("union{")));
  EXPECT_NE(closed, open);
}

TEST(Polyps, StandNowhereOnWhatIsDead) {
  Solids solids = skin_with_polyps();
  auto count = [&] {
    std::size_t all = 0;
    for (const auto& places : polyp_places(solids)) all += places.size();
    return all;
  };
  std::size_t whole = count();
  solids.shapes[0].material.dead = {{{0, 0, 0}, 0.3f}};
  EXPECT_NEAR(static_cast<double>(count()), (1 - kPi * 0.3 * 0.3) * static_cast<double>(whole),
              0.06 * static_cast<double>(whole));
  solids.shapes[0].material.dead = {{{0, 0, 0}, 2}};
  EXPECT_EQ(count(), 0u);
}

TEST(Polyps, StandRoundBranchesAndComeAsTheyGrow) {
  Specimen b;
  b.look.branches.skin = Skin{};
  b.look.branches.skin->polyps.width = 0.01;
  Skeleton& rod = b.model.skeleton;
  for (int i = 0; i <= 20; ++i) rod.add({0, 0.02f * static_cast<float>(i), 0}, 0.02f, i - 1, 0);
  set_births(rod), set_tip_distances(rod);
  Eye eye = eye_toward({0, 0.2f, 2}, {0, 0.2f, 0}, 1, 1, 0.0001);
  auto count_at = [&](double time) {
    b.motion.growth = {.start = 0, .duration = 1};
    return count_of(polyps_text({}, drawn_polyps(*DrawList(b, time).branches, eye), time).text);
  };
  // A little more than half of a tube of 0.4 m x 2 pi 0.02 m is seen, and each has a hexagon of 0.87 x 8.5 mm
  // squared.
  double all = 0.4 * 2 * kPi * 0.02 / (0.866 * 0.0085 * 0.0085);
  EXPECT_NEAR(static_cast<double>(count_at(9)), 0.6 * all, 0.12 * all);
  EXPECT_EQ(count_at(-0.1), 0u);
  EXPECT_GT(2 * count_at(0.9), 3 * count_at(0.35));
  eye = eye_toward({0, 0.2f, 900}, {0, 0.2f, 0}, 1, 1, 0.0001);
  EXPECT_EQ(count_at(9), 0u) << "too small to be seen";
}

}  // namespace
}  // namespace frond
