#pragma once

#include <optional>

#include "core/result.h"
#include "geometry/rock.h"
#include "model/model.h"

namespace frond {

enum class StoneKind { granite, limestone, basalt };

/// The surface of rocks.
struct StoneLook {
  StoneKind kind = StoneKind::granite;
  std::optional<Color> color, second;  ///< of the stone and of what differs in it; empty: those of its kind
  double scale = 0.12;                 ///< metres, size of the pattern
  double relief = 0.5;                 ///< depth of its grain and cracks
  double moss = 0;                     ///< 0 none .. 1: moss and lichen
  double variation = 0.08;             ///< how much single ones differ in brightness
};

/// One rock.
struct RockParams {
  RockShape shape;
  StoneLook stone;
  double buried = 0.06;  ///< share of its height that is in the ground
  bool native = false;   ///< drawn as an isosurface: the blobs alone, exact and without weathering
};

/// Many small ones that lie about.
struct PebblesParams {
  RockShape shape;  ///< of each but for its size
  StoneLook stone;
  int shapes = 8;            ///< different ones; each lies in many places, turned and sized at random
  int number = 150;          ///< fewer where there is no room
  double radius = 1.2;       ///< metres of the field
  double inner = 0;          ///< metres round its middle that stay free
  double least_size = 0.03;  ///< metres, the longest side; small ones are more frequent
  double most_size = 0.12;
  double buried = 0.25;  ///< share of the height that is in the ground

  PebblesParams();
};

/// Builds a rock, its foot at the origin. Blobs without an inside are an error.
Result<Model> build_rock(const RockParams& params, Seed seed);

/// Lays a field of pebbles round the origin. Each follows the ground below it.
Result<Model> build_pebbles(const PebblesParams& params, Seed seed);

/// The faults of what can have no inside, and of ranges upside down.
Errors check_rock(const RockShape& shape);
Errors check_pebbles(const PebblesParams& params);

}  // namespace frond
