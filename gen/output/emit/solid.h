#pragma once

#include <string>
#include <vector>

#include "draw/polyps.h"
#include "draw/septa.h"
#include "draw/solids.h"
#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// Appends the share of growth that what lives has reached, by which its texture knows what is young.
void append_front(std::string& text, double front);

/// The names of the povinc files that the solids of a scene need, each once, as `stone` for frond_stone.inc.
std::vector<std::string_view> solid_includes(const Scene& scene);

/// The `texture{...}` of a material, on it its bands and, where it is wet, water, and what is inside; the
/// name of the povinc file that it needs.
std::string material_text(const Material& material, bool wet = false);
std::string_view material_include(const Material& material);

/// Declares the shapes of all solids and places them, but for those that a film sees grow or become others;
/// the same in each frame. Without `drawn` they are written as they are.
ObjectText solids_text(const PovSpace& space, const Scene& scene, const DrawnSolids& drawn = {});

/// One shape of an organism, declared and placed, or as far as it has grown; `wet`: with rain on it; `worn`:
/// in what worn_text() declares.
ObjectText solid_text(const PovSpace& space, const DrawnBody& body, std::size_t organism, bool wet = false,
                      bool worn = false);

/// One union of polyps, as open as they are at a time.
ObjectText polyps_text(const PovSpace& space, const DrawnPolyps& drawn, double time);
/// One union of septa, with the texture of their body.
ObjectText septa_text(const PovSpace& space, const DrawnSepta& drawn);

}  // namespace frond
