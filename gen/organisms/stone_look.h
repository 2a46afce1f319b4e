#pragma once

#include <optional>

#include "core/result.h"
#include "core/seed.h"
#include "model/model.h"
#include "rocks/rock.h"

namespace frond {

enum class StoneKind { granite, limestone, basalt, reef };

/// The surface of rocks.
struct StoneLook {
  StoneKind kind = StoneKind::granite;
  std::optional<Color> color, second;  ///< of the stone and of what differs in it; empty: those of its kind
  double scale = 0.12;                 ///< metres, size of the pattern
  double relief = 0.5;                 ///< depth of its grain and cracks
  double moss = 0;                     ///< 0 none .. 1: moss and lichen
  double variation = 0.08;             ///< how much single ones differ in brightness
};

/// The material of one stone.
Material material_of(const StoneLook& look, Seed seed);

/// The faults of a shape that can have no inside, and of ranges upside down.
Errors check_rock(const RockShape& shape);
/// That blobs have no inside, as it shows when they are meshed.
Error hollow_rock();

/// About how many triangles a rock will have: as many as its tolerance asks for and its finest cells can
/// make.
double estimate_triangles(const RockShape& shape);

/// How high a mesh on the ground is, metres.
float height_of(const Surface& surface);

}  // namespace frond
