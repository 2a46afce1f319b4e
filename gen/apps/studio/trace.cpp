#include "studio/trace.h"

namespace frond {

namespace {

constexpr int kMostThings = 64;   // that a ray goes through on its way to what is asked for
constexpr float kBeyond = 1e-3f;  // metres, to behind what it went through

/// The entry of the preset that a hit belongs to; none: the ground and what lies on it.
std::optional<std::size_t> entry_of(const Scene& scene, const Thing& thing) {
  if (thing.kind >= ThingKind::floor || thing.kind == ThingKind::copy) return std::nullopt;
  std::size_t entry = scene.specimens[thing.owner].entry;
  return entry == Specimen::kNoEntry ? std::nullopt : std::optional(entry);
}

}  // namespace

Result<std::shared_ptr<const Traceable>> traceable(std::shared_ptr<const Scene> scene, double time) {
  Result<TracedFilm> film = TracedFilm::of(*scene);
  if (!film) return film.errors();
  Result<TracedFrame> frame = film->at(time);
  if (!frame) return frame.errors();
  return std::make_shared<const Traceable>(Traceable{std::move(scene), std::move(*film), std::move(*frame)});
}

Json hit_json(const Traceable& things, const CameraRay& ray, const std::optional<std::set<std::size_t>>& on) {
  Vec3 from = ray.from;
  for (int k = 0; k < kMostThings; ++k) {
    std::optional<PassHit> hit = things.frame.trace(from, ray.along);
    if (!hit) return nullptr;
    std::optional<std::size_t> entry = entry_of(*things.scene, hit->spot.thing);
    bool ground = hit->spot.thing.kind == ThingKind::floor;
    if (on ? entry && on->contains(*entry) : ground)
      return {{"at", json_of(hit->at)},
              {"normal", json_of(hit->normal)},
              {"entry", entry ? static_cast<int>(*entry) : -1}};
    from = hit->at + kBeyond * ray.along;
  }
  return nullptr;
}

}  // namespace frond
