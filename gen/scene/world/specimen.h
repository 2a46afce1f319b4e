#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "appearance/appearance.h"
#include "appearance/condition.h"
#include "core/curve.h"
#include "core/seed.h"
#include "creeping/crawl.h"
#include "creeping/swing_paths.h"
#include "land/ground.h"
#include "model/model.h"
#include "motion/fall.h"
#include "pruning/edits.h"
#include "world/style.h"

namespace frond {

struct Specimen;

/// Position, rotation and size factor of an organism.
struct Placement {
  Vec3 foot{0};
  Quat turn{1, 0, 0, 0};
  float size = 1;
};

/// Strands of a creeper that hang in the wind: its skeleton with the points where it holds on.
struct Hanging {
  Strands strands;
  Breeze breeze;
  std::shared_ptr<const SwingPaths> paths{};  ///< where its motion is simulated
};

/// How the shape of a specimen changes over the film, besides growth and swaying.
struct Life {
  /// The model at a time in seconds, at its place, fully revealed: a pure function. Empty: the model does not
  /// change.
  std::function<Result<Model>(double)> develop;
  std::optional<Seasons> season;  ///< if given, its organs are in full summer leaf
  Seed season_seed;
  std::optional<Condition> condition;     ///< if given, its look is another at each time
  std::shared_ptr<const Heights> ground;  ///< on which its leaves fall, and it itself
  std::shared_ptr<const Fall> fall;       ///< of a tree that loses its balance
  std::optional<Hanging> hanging;
  /// Makes the specimen once more with edits by hand, from what it grew from. Empty: its model is edited.
  std::function<void(Specimen&, std::span<const Edit>)> edit;
  std::function<double(double)> age;  ///< years, at a time in seconds; empty: it does not grow over years
  std::size_t held = 0;               ///< bytes of memory of `develop` and `edit`, if significant

  /// Whether its shape differs in each frame.
  bool reshapes() const { return develop || season; }
  /// Whether its shape or its look does; see developed().
  bool changes() const { return reshapes() || condition; }
};

/// The snow on the branches of a specimen.
struct SnowLoad {
  Animated<double> depth;           ///< metres, on open level ground
  std::vector<float> share;         ///< of each node, of what a level branch of its thickness carries
  std::vector<std::int32_t> bough;  ///< of each node, what drops its snow as one
  std::vector<float> drops;         ///< of each bough, when that is: seconds; infinity: never
  Seed powder{};                    ///< of what then hangs in the air

  /// What is left at a node at a time, 0..1.
  float left(std::size_t node, double time) const {
    constexpr float kTakes = 0.4f;  // seconds
    float since = static_cast<float>(time) - drops[static_cast<std::size_t>(bough[node])];
    return 1 - smooth_step(0.0f, kTakes, since);
  }
};

/// Height of the snow on what is so broad, metres: half as much again as its breadth where that is small, as
/// snow holds together, and no more than lies on the ground.
inline double heap_height(double depth, double breadth) {
  return depth > 0 ? depth * (1 - std::exp(-1.5 * breadth / depth)) : 0;
}

/// The properties of an individual, except its shape.
struct Traits {
  static constexpr std::size_t kNoEntry = SIZE_MAX;

  std::string name;
  std::size_t entry = kNoEntry;  ///< index of its entry in the preset's organisms; none: part of the setting
  Placement placement{};         ///< of the frame that it grew in, upright
  Look look{};
  double brightness = 1;  ///< its individual factor
  ColorShift shift{};     ///< what its pictures are changed by, of one that is developed()
  Motion motion{};
  Style style{};  ///< its voxel is never 0
  Life life{};
  bool snowy = false;                      ///< whether snow lies on what of it looks up
  std::shared_ptr<const SnowLoad> load{};  ///< the snow on its branches; null: none but by their texture
  bool wet = false;                        ///< whether rain makes it wet
};

/// One grown organism or built body at its place. Always moved as a whole, never field by field.
struct Specimen : Traits {
  Model model;  ///< at its place in the world, fully grown, at rest

  /// Checks all invariants: one line for the first violation, empty if there is none.
  std::string find_fault() const;
};

/// Approximate memory, bytes; shared parts count fully.
std::size_t bytes_of(const Specimen& specimen);

/// Rotates, scales and moves a model from the origin to its place.
void transform(Model& model, Vec3 foot, Quat turn, float size);

/// The outer surface of its bodies, without `uv`; empty if it has none.
Surface skin_of(const Model& model);

/// Edits it by hand, at all times of its life.
void edit_specimen(Specimen& specimen, std::span<const Edit> edits);

/// Lets it fare as its entry says, at all times of its life; its leaves fall on the ground that it knows.
void set_courses(Specimen& specimen, const Courses& courses, Seed seed);

/// Lets it sway in a wind, by its wood and leaves.
void set_wind(Specimen& specimen, std::shared_ptr<const WindField> wind);

/// The specimen at a time, with life and season applied; itself, not a copy, where it does not change.
Result<std::shared_ptr<const Specimen>> developed(const Specimen& specimen, double time);

/// Its branches at a time.
void pose_specimen(const Specimen& specimen, double time, Pose& pose);

/// Where its nodes are once it has fallen; empty if it does not fall.
std::vector<Vec3> fallen_nodes(const Specimen& specimen);

}  // namespace frond
