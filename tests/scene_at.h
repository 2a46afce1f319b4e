#pragma once

#include "core/files.h"
#include "scene/scene.h"

namespace frond {

/// The scene of a preset, by its path below the sources.
inline Scene scene_at(const std::string& path) {
  return *build_scene(*read_preset(*read_file(FROND_ROOT "/" + path), path, {}));
}

/// What a result holds, moved out of it.
template <class Value>
Value taken(Result<Value> result) {
  return std::move(*result);
}

}  // namespace frond
