#include "passes/frame_passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr std::string_view kKinds[] = {"nothing", "branches", "organ", "blades", "body", "copy",
                                       "floor",   "stone",    "food",  "cover",  "water"};

/// Fills pixel after pixel.
class PassMaker {
 public:
  PassMaker(FramePasses& passes, const TracedFrame& now, int side)
      : passes_(passes), now_(now), side_(side) {}

  const TracedFrame *next = nullptr, *before = nullptr;

  void pixel(int x, int y) {
    std::size_t i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(passes_.width) + static_cast<std::size_t>(x);
    middle(i, Vec2(x, y) + 0.5f);
    int all = side_ * side_, met = 0, lit = 0;
    float spread = pixel_spread(Vec2(x, y));
    std::vector<std::pair<Thing, float>>& things = passes_.things[i];
    for (int ray = 0; ray < all; ++ray) {
      auto [from, along] = now_.ray((Vec2(x, y) + place_in_pixel(ray, side_)) / size(), ray, spread);
      std::optional<PassHit> hit = now_.trace(from, along);
      if (!hit) continue;
      ++met, lit += now_.lit(*hit);
      auto found = std::ranges::find(things, hit->spot.thing, &std::pair<Thing, float>::first);
      if (found == things.end()) found = things.insert(things.end(), {hit->spot.thing, 0.0f});
      found->second += 1 / static_cast<float>(all);
    }
    passes_.coverage[i] = static_cast<float>(met) / static_cast<float>(all);
    passes_.sun[i] = static_cast<float>(lit) / static_cast<float>(all);
  }

 private:
  Vec2 size() const { return Vec2(passes_.width, passes_.height); }
  std::optional<PassHit> trace(Vec2 place) const {
    return now_.trace(now_.eye.at, picture_ray(now_.eye, place / size()));
  }

  void middle(std::size_t i, Vec2 place) {
    std::optional<PassHit> hit = trace(place);
    if (!hit) return;
    passes_.depth[i] = glm::dot(hit->at - now_.eye.at, now_.eye.ahead);
    passes_.position[i] = hit->at;
    passes_.normal[i] = hit->normal;
    passes_.forward[i] = motion(hit->spot, place, next);
    passes_.backward[i] = motion(hit->spot, place, before);
  }

  Vec2 motion(const SurfaceSpot& spot, Vec2 place, const TracedFrame* other) const {
    std::optional<PlaceNormal> there = other ? other->where(spot) : std::nullopt;
    std::optional<Vec2> seen = there ? picture_place(other->eye, there->at) : std::nullopt;
    return seen ? *seen * size() - place : Vec2(0);
  }

  FramePasses& passes_;
  const TracedFrame& now_;
  int side_;
};

}  // namespace

Result<FramePasses> frame_passes(const Scene& scene, const TracedFilm& film, int number, int side) {
  std::optional<TracedFrame> traced[3];  // before, now, next
  for (int k = 0; k < 3; ++k) {
    int frame = number + k - 1;
    if (frame < 1 || frame > scene.film.frames) continue;
    Result<TracedFrame> one = film.at(scene.film.time(frame));
    if (!one) return one.errors();
    traced[k].emplace(std::move(*one));
  }
  FramePasses passes;
  passes.width = scene.film.size[0], passes.height = scene.film.size[1];
  std::size_t count = static_cast<std::size_t>(passes.width) * static_cast<std::size_t>(passes.height);
  passes.depth.assign(count, std::numeric_limits<float>::infinity());
  for (std::vector<Vec3>* of : {&passes.position, &passes.normal}) of->assign(count, Vec3(0));
  for (std::vector<Vec2>* of : {&passes.forward, &passes.backward}) of->assign(count, Vec2(0));
  for (std::vector<float>* of : {&passes.coverage, &passes.sun}) of->assign(count, 0.0f);
  passes.things.resize(count);
  PassMaker maker(passes, *traced[1], side);
  if (traced[0]) maker.before = &*traced[0];
  if (traced[2]) maker.next = &*traced[2];
  parallel_for(static_cast<std::size_t>(passes.height), [&](std::size_t y) {
    for (int x = 0; x < passes.width; ++x) maker.pixel(x, static_cast<int>(y));
  });
  return passes;
}

ThingNames names_of(const Scene& scene, const Thing& thing) {
  ThingNames names;
  std::string_view kind = kKinds[static_cast<std::size_t>(thing.kind)];
  if (thing.kind == ThingKind::copy) {
    names.entry = scene.copy_sets[thing.owner].organism.name;
    names.organism = names.part = fmt::format("{}/copy {}", names.entry, thing.number + 1);
    return names;
  }
  if (thing.kind >= ThingKind::floor) {
    bool loose = thing.kind == ThingKind::stone || thing.kind == ThingKind::food;
    names.entry = names.organism = names.part = kind;
    if (loose) names.part = fmt::format("{} {}", kind, thing.number + 1);
    return names;
  }
  names.entry = scene.specimens[thing.owner].name;
  names.organism = fmt::format("{}/{}", names.entry, thing.owner + 1);
  names.part = fmt::format("{}/{} {}", names.organism, kind, thing.number + 1);
  return names;
}

}  // namespace frond
