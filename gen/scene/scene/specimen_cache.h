#pragma once

#include <string>
#include <vector>

#include "core/lru_cache.h"
#include "world/specimen.h"

namespace frond {

/// Specimens that were grown for earlier scenes, so that a change of one organism grows that one alone. They
/// are known by a hash of all that they grew from. May be asked from many threads.
class SpecimenCache : public LruCache<std::vector<Specimen>> {
 public:
  /// Keeps up to so many bytes, about.
  explicit SpecimenCache(std::size_t bytes = std::size_t{2} << 30) : LruCache(bytes) {}
  explicit SpecimenCache(std::shared_ptr<CacheBudget> budget) : LruCache(std::move(budget)) {}

  void keep(const std::string& key, std::vector<Specimen> grown) {
    std::size_t bytes = grown.capacity() * sizeof(Specimen);
    for (const Specimen& s : grown) bytes += bytes_of(s);
    put(key, std::make_shared<const std::vector<Specimen>>(std::move(grown)), bytes);
  }
};

}  // namespace frond
