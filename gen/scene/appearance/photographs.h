#pragma once

#include "core/assets.h"
#include "core/content.h"
#include "core/lru_cache.h"
#include "core/result.h"

namespace frond {

/// What `read` makes of a photograph that a preset names, which is read again and again where somebody works
/// on it: the last ones are kept, 64 MB for each type. `bytes`: of what was made.
template <class T, class Read, class Bytes>
Result<std::shared_ptr<const T>> photograph(const NamedFile& file, Read read, Bytes bytes) {
  constexpr std::size_t kRoom = 64 << 20;
  static LruCache<T> kept(kRoom);
  std::string name = content_id(file.text);
  if (std::shared_ptr<const T> found = kept.find(name)) return found;
  Result<T> made = read(file.text);
  if (!made) return made.errors();
  auto photo = std::make_shared<const T>(std::move(*made));
  kept.put(name, photo, bytes(*photo));
  return std::shared_ptr<const T>(photo);
}

}  // namespace frond
