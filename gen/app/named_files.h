#pragma once

#include <string>

#include "core/assets.h"
#include "scene/preset.h"

namespace frond {

/// Reads the files that a preset names: meshes, silhouettes, maps, species, guides. All faults are told, each
/// at the property that names the file.
Errors load_files(Preset& preset, const Assets& assets);

/// Reads the OBJ file of lines that a grammar's guide names, if it names one. The error has no place.
Errors load_guide(GuideText& guide, const Assets& assets);

}  // namespace frond
