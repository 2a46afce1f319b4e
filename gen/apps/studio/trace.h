#pragma once

#include <memory>
#include <optional>
#include <set>

#include "passes/traced_film.h"
#include "studio/packet.h"

namespace frond {

/// What stands in a scene at one time, made to be hit by rays. Copies of what is sown are left out: nothing
/// is drawn on them.
struct Traceable {
  std::shared_ptr<const Scene> scene;
  TracedFilm film;
  TracedFrame frame;
  /// About: that of the scene once more.
  std::size_t bytes() const { return scene->bytes(); }
};

/// An error where something cannot be developed.
Result<std::shared_ptr<const Traceable>> traceable(std::shared_ptr<const Scene> scene, double time);

/// Where a ray first meets the ground or, where they are given, one of those entries of the preset:
/// `{"at", "normal", "entry"}`, -1 for the ground; null: nowhere.
Json hit_json(const Traceable& things, const CameraRay& ray, const std::optional<std::set<std::size_t>>& on);

}  // namespace frond
