#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/result.h"
#include "motion/motion.h"
#include "pruning/address.h"
#include "scene/scene.h"
#include "studio/packet.h"

namespace frond {

/// The specimens of a scene that have branches, as they stand at one time.
struct PosedScene {
  struct One {
    std::size_t entry = 0, plant = 0;  ///< which of the preset's organisms, and of that one's plantings
    std::shared_ptr<const Specimen> now;
    std::vector<AxisNode> axes;
    Pose pose;
  };
  double time = 0;
  std::vector<One> specimens;
  std::size_t bytes() const;
};

/// The specimens of a scene in their poses at a time, seconds. Needs the scene as long as it is used.
Result<PosedScene> posed(const Scene& scene, double time);

/// The branch that a ray from a point through another meets first, and its address, for edits by hand; the
/// answer of POST /api/pick (docs/studio-wire.md), null where the ray meets none. `entry`: only branches of
/// that entry.
Json picked(const PosedScene& scene, Vec3 from, Vec3 to, std::optional<std::size_t> entry = {});

/// The answer of picked() for the place that an address names on a plant; null where it finds no branch.
Json picked_at(const PosedScene& scene, std::size_t entry, std::size_t plant, const Address& address);

}  // namespace frond
