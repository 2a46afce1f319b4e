#include "passes/traced_film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <new>
#include <tuple>

#include "passes/frame_passes.h"
#include "passes/mesh_group.h"
#include "scene_at.h"

namespace frond {
namespace {

/// Calls `look(hit, place)` for rays all over the picture that meet something.
template <class Look>
void each_hit(const TracedFrame& frame, const Look& look) {
  constexpr int kRays = 60;  // along each side
  for (int y = 0; y < kRays; ++y)
    for (int x = 0; x < kRays; ++x) {
      Vec2 place = (Vec2(x, y) + 0.5f) / static_cast<float>(kRays);
      if (std::optional<PassHit> hit = frame.trace(frame.eye.at, picture_ray(frame.eye, place)))
        look(*hit, place);
    }
}

class Traced : public testing::TestWithParam<const char*> {};

TEST_P(Traced, SpotsAreWhereTheirRaysMetThem) {
  Scene scene = scene_at(GetParam());
  TracedFilm film = taken(TracedFilm::of(scene));
  TracedFrame frame = taken(film.at(scene.film.time(scene.film.frames)));
  int hits = 0;
  each_hit(frame, [&](const PassHit& hit, Vec2 place) {
    ++hits;
    EXPECT_NEAR(glm::length(hit.normal), 1, 1e-4);
    EXPECT_LE(glm::dot(hit.normal, hit.at - frame.eye.at), 0);
    std::optional<PlaceNormal> where = frame.where(hit.spot);
    ASSERT_TRUE(where);
    EXPECT_LT(glm::distance(where->at, hit.at), 1e-4f * (1 + hit.away));
    EXPECT_GT(std::abs(glm::dot(where->normal, hit.normal)), 0.999f);
    std::optional<Vec2> seen = picture_place(frame.eye, hit.at);
    ASSERT_TRUE(seen);
    EXPECT_LT(glm::distance(*seen, place), 1e-4f);
  });
  EXPECT_GT(hits, 200);
}

TEST_P(Traced, SpotsMoveToWhereTheyAreSeenLater) {
  Scene scene = scene_at(GetParam());
  TracedFilm film = taken(TracedFilm::of(scene));
  int last = scene.film.frames;
  TracedFrame before = taken(film.at(scene.film.time(std::max(1, last - 1))));
  TracedFrame after = taken(film.at(scene.film.time(last)));
  int seen = 0, met = 0, there = 0;
  each_hit(before, [&](const PassHit& hit, Vec2) {
    ++met;
    std::optional<PlaceNormal> where = after.where(hit.spot);
    if (!where) return;
    ++there;
    Vec3 offset = where->at - after.eye.at;
    std::optional<PassHit> again = after.trace(after.eye.at, glm::normalize(offset));
    // Another thing may have come before it, but nothing lets the ray pass through where the spot is.
    ASSERT_TRUE(again);
    EXPECT_LT(again->away, glm::length(offset) * 1.01f + 0.01f);
    seen += again->spot.thing == hit.spot.thing && again->away > 0.98f * glm::length(offset);
  });
  EXPECT_GT(there, 0.98 * met);
  EXPECT_GT(seen, 0.9 * met);
}

INSTANTIATE_TEST_SUITE_P(All, Traced,
                         testing::Values("tests/presets/tiny_film.json", "tests/presets/tiny_plant.json",
                                         "tests/presets/tiny_reef.json", "tests/presets/tiny_garden.json",
                                         "tests/presets/tiny_vases.json", "presets/reef/chromis.json"),
                         [](const auto& one) {
                           std::string name = one.param;
                           name = name.substr(name.rfind('/') + 1);
                           return name.substr(0, name.find('.'));
                         });

TEST(TracedFrame, RaysThroughTheLensMeetWhereItIsInFocus) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  scene.setup.camera.aperture = 2;
  TracedFilm film = taken(TracedFilm::of(scene));
  TracedFrame frame = taken(film.at(0));
  ASSERT_GT(frame.lens, 0);
  Vec2 place(0.3f, 0.7f);
  Vec3 middle = picture_ray(frame.eye, place);
  Vec3 focus = frame.eye.at + middle * (frame.sharp / glm::dot(middle, frame.eye.ahead));
  float widest = 0;
  for (int i = 0; i < 64; ++i) {
    auto [from, along] = frame.ray(place, i, 0.1f);
    EXPECT_LT(glm::length(glm::cross(focus - from, along)), 1e-5f);
    widest = std::max(widest, glm::distance(from, frame.eye.at));
  }
  EXPECT_LE(widest, frame.lens / 2);
  EXPECT_GT(widest, 0.45f * frame.lens);
  EXPECT_LT(frame.blur(focus), 1e-5f);
}

TEST(TracedFrame, FacetsFaceTheLightAsTheyAreShadedNotAsTheyLie) {
  Scene scene = scene_at("tests/presets/tiny_reef.json");
  TracedFilm film = taken(TracedFilm::of(scene));
  TracedFrame frame = taken(film.at(0));
  std::map<std::tuple<Thing, std::uint32_t, std::uint32_t>, std::pair<float, float>>
      facets;  // least and most
  each_hit(frame, [&](const PassHit& hit, Vec2) {
    EXPECT_LE(std::abs(hit.spot.facing), 1.0001f);
    if (hit.spot.thing.kind == ThingKind::branches) return;
    auto& [least, most] =
        facets.try_emplace({hit.spot.thing, hit.spot.part, hit.spot.face}, 2.0f, -2.0f).first->second;
    least = std::min(least, hit.spot.facing), most = std::max(most, hit.spot.facing);
  });
  EXPECT_TRUE(std::ranges::any_of(
      facets, [](const auto& one) { return one.second.second - one.second.first > 0.01f; }));
}

TEST(TracedFilm, KnowsGrassAndWater) {
  Scene scene = scene_at("tests/presets/tiny_garden.json");
  TracedFilm film = taken(TracedFilm::of(scene));
  std::map<ThingKind, int> met;
  each_hit(taken(film.at(0)), [&](const PassHit& hit, Vec2) { ++met[hit.spot.thing.kind]; });
  EXPECT_GT(met[ThingKind::cover], 10);
  EXPECT_GT(met[ThingKind::water], 20);
}

TEST(TracedFrame, WhatMovesMayLieWhereSomethingStill) {
  Scene scene = scene_at("tests/presets/tiny_vases.json");
  for (Specimen& one : scene.specimens) one.motion = {};
  std::size_t count = scene.specimens.size();
  for (std::size_t i = count; i-- > 0;) {  // so that each has another number among its like
    scene.specimens.push_back(scene.specimens[i]);
    scene.specimens.back().motion.flutter.amplitude = 1;  // of organs, which it has none of
  }
  TracedFilm film = taken(TracedFilm::of(scene));
  TracedFrame frame = taken(film.at(0));
  int met = 0;
  each_hit(frame, [&](const PassHit& hit, Vec2) {
    std::optional<PlaceNormal> where = frame.where(hit.spot);
    ASSERT_TRUE(where);
    EXPECT_LT(glm::distance(where->at, hit.at), 1e-4f * (1 + hit.away));
    met += hit.spot.thing.kind == ThingKind::body;
  });
  EXPECT_GT(met, 100);
}

/// Lets Embree have so many bytes, and then none, as long as it lives.
class EmbreeMemory {
 public:
  explicit EmbreeMemory(std::int64_t bytes) : left_(bytes) {
    rtcSetDeviceMemoryMonitorFunction(
        embree_device(),
        [](void* own, ssize_t more, bool) {
          return (static_cast<EmbreeMemory*>(own)->left_ -= more) >= 0 || more <= 0;
        },
        this);
  }
  ~EmbreeMemory() { rtcSetDeviceMemoryMonitorFunction(embree_device(), nullptr, nullptr); }

 private:
  std::atomic<std::int64_t> left_;
};

TEST(TracedFilm, IsNoneWhereMemoryRunsOut) {
  Scene scene = scene_at("tests/presets/tiny_vases.json");
  for (std::int64_t bytes : {0, 100, 1000, 10'000, 100'000}) {
    EmbreeMemory little(bytes);
    EXPECT_THROW((void)TracedFilm::of(scene), std::bad_alloc) << bytes;
  }
  EXPECT_TRUE(TracedFilm::of(scene)) << "what went wrong is over";
}

TEST(FramePasses, SharesAddUpToTheCoverage) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  FramePasses passes = *frame_passes(scene, *TracedFilm::of(scene), 3);
  bool open = false, full = false;
  for (std::size_t i = 0; i < passes.coverage.size(); ++i) {
    float sum = 0;
    for (const auto& [thing, share] : passes.things[i]) sum += share;
    EXPECT_NEAR(sum, passes.coverage[i], 1e-4);
    EXPECT_LE(passes.sun[i], passes.coverage[i]);
    (passes.coverage[i] > 0.5f ? full : open) = true;
  }
  EXPECT_TRUE(open && full);
}

TEST(FramePasses, MotionsOfTwoFramesAreOpposite) {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  TracedFilm film = taken(TracedFilm::of(scene));
  FramePasses first = *frame_passes(scene, film, 3), second = *frame_passes(scene, film, 4);
  int compared = 0;
  float moved = 0;
  for (int y = 0; y < first.height; ++y)
    for (int x = 0; x < first.width; ++x) {
      auto i = static_cast<std::size_t>(y * first.width + x);
      Vec2 to = Vec2(x, y) + 0.5f + first.forward[i];
      if (first.coverage[i] < 1 || glm::any(glm::lessThan(to, Vec2(0))) ||
          glm::any(glm::greaterThanEqual(to, Vec2(first.width, first.height))))
        continue;
      auto there = static_cast<std::size_t>(static_cast<int>(to.y) * first.width + static_cast<int>(to.x));
      if (second.things[there] != first.things[i] || first.things[i].size() != 1) continue;
      ++compared;
      moved = std::max(moved, glm::length(first.forward[i]));
      EXPECT_LT(glm::length(first.forward[i] + second.backward[there]), 0.7f);
    }
  EXPECT_GT(compared, 300);
  EXPECT_GT(moved, 0.5f);
}

}  // namespace
}  // namespace frond
