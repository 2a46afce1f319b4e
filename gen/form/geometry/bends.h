#pragma once

#include <glm/vec4.hpp>
#include <span>

namespace frond {

/// Marks with 1 those points of a chain that are farther than `within` metres from the line between their
/// neighbours that are marked (Douglas and Peucker 1973), its ends always. w is their radius: by how much it
/// differs counts, too.
void mark_bends(std::span<const glm::vec4> chain, float within, std::span<char> marks);

}  // namespace frond
