#pragma once

#include <string>

#include "core/assets.h"
#include "core/result.h"
#include "preset/value.h"

// Presets that another one names: its base, and the species of its organisms.

namespace frond {

/// An organism with the defaults behind it, as it was read.
Value merged_organism(const Value& root, std::size_t index);

/// Lays a preset over the one that it names as its base, and that over its own; `depth` of them are below.
Errors lay_on_base(Value& root, const std::string& file_name, const Assets& assets, int depth = 0);

/// Lays each organism that names a species over the first one of that preset, with the defaults there: how it
/// grows and looks, not where it stands. That one may name a species itself.
Errors lay_on_species(Value& root, const std::string& file_name, const Assets& assets, int depth = 0);

}  // namespace frond
