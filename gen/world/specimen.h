#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/result.h"
#include "creeping/crawl.h"
#include "creeping/swing.h"
#include "dress/dress.h"
#include "land/ground.h"
#include "model/model.h"
#include "world/style.h"

namespace frond {

/// Strands of a creeper that hang in the wind: what its skeleton is, and where it holds on.
struct Hanging {
  Strands strands;
  Breeze breeze;
};

/// How a specimen becomes another shape over the film, beyond being revealed and swaying.
struct Life {
  /// The model at a time in seconds, where it stands, fully revealed: a pure function. Empty: it stays the
  /// model that it has.
  std::function<Result<Model>(double)> develop;
  std::optional<Seasons> season;  ///< where given, its organs are in full leaf
  Seed season_seed;
  std::shared_ptr<const Heights> ground;  ///< on which its leaves fall
  std::optional<Hanging> hanging;
  std::size_t held = 0;  ///< bytes of memory that `develop` holds, where that is much

  /// Whether it is another shape in each frame; see developed().
  bool changes() const { return develop || season; }
};

/// What one individual is, but for its shape.
struct Traits {
  static constexpr std::size_t kNoEntry = SIZE_MAX;

  std::string name;
  std::size_t entry = kNoEntry;  ///< which of the preset's organisms it is one of; none: of the setting
  Look look{};
  double brightness = 1;  ///< factor, its own
  Motion motion{};
  Style style{};  ///< its voxel is never 0
  Life life{};
};

/// One grown organism, or built body, where it stands. Moved whole, never field by field.
struct Specimen : Traits {
  Model model;  ///< at its place in the world, fully grown, unmoved

  /// Where it is not what it promises: one line for the first fault, empty when all is well.
  std::string check() const;
};

/// What it holds in memory, bytes, about; what it shares with others counts as its own.
std::size_t bytes_of(const Specimen& specimen);

/// Turns, sizes and moves a model from the origin to its place.
void transform(Model& model, Vec3 foot, Quat turn, float size);

/// The outside of the bodies that it is, without `uv`; empty where it is none.
Surface skin_of(const Model& model);

/// The specimen as it is at a time, life and season taken in.
Result<Specimen> developed(const Specimen& specimen, double time);

/// Its branches as they are at a time.
void pose_specimen(const Specimen& specimen, double time, Pose& pose);

}  // namespace frond
