#pragma once

#include <span>
#include <string>

#include "scene/scene.h"

// What organisms wear whose look changes over a film, as by their health: each frame declares it once, and
// what is the same in all frames names it.

namespace frond {

/// The name of the macro of a shape's textures, `Worn3_0`.
std::string worn_name(std::size_t organism, std::size_t shape);

/// Declares these, and the skins of such organisms, as they are in a frame at its time. `first_skin`: of each
/// organism, in the array of skins.
std::string worn_text(const Scene& scene, std::span<const std::size_t> first_skin, double time);

/// Solids of such an organism in what it wears at a time.
Solids worn_at(const Solids& solids, const Specimen& specimen, double time);

}  // namespace frond
