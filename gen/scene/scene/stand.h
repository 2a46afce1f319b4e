#pragma once

#include <algorithm>
#include <optional>

#include "scene/scene.h"

namespace frond {

/// The history of a preset's stand, which it must have, on the ground that its setting lays. The preset's
/// seed decides it.
StandHistory stand_history(const Preset& preset);
StandHistory stand_history(const Preset& preset, const Grounds& ground);

/// The years of a stand or a reef that a film shows.
struct StandFilm {
  double from = 0, to = 1;  ///< years
  double length = 1;        ///< seconds

  double time(double year) const { return length * (year - from) / std::max(1e-6, to - from); }  ///< seconds
};

/// The film of these years, or else of all; a still is one of the last year that hardly moves.
StandFilm stand_film(const Film& film, const std::optional<Vec2>& shown, int years);

/// Index of the first organism of that name that is sown, which trees or colonies are drawn as; none for an
/// empty name.
std::optional<std::size_t> drawn_as(const Preset& preset, const std::string& name);

/// Draws the trees of a preset's stand over its years as copies that come, grow, die, fall and rot: adds to
/// `scene.copy_sets`. Each of its species has a library: the models of the organism that it names, grown
/// until they have a few heights, alive and dead, and fitted to what trees of the stand of that height
/// measure on average. A tree goes through them as it grows taller. Its copies are scaled so that height and
/// crown are those of the tree at any time, also where one takes over from another. What is sown below the
/// trees shows in the years in which the shade suits it.
void add_stand(Scene& scene, const Preset& preset, const Grounds& ground, const StandHistory& history);

}  // namespace frond
