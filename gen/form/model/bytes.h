#pragma once

#include "core/bytes.h"
#include "model/model.h"

namespace frond {

std::size_t bytes_of(const Surface& surface);
std::size_t bytes_of(const Skeleton& skeleton);
std::size_t bytes_of(const Organs& organs);
std::size_t bytes_of(const Blades& blades);
std::size_t bytes_of(const Solids& solids);
std::size_t bytes_of(const std::vector<Prototype>& prototypes);
std::size_t bytes_of(const Model& model);

}  // namespace frond
