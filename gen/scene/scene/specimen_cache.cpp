#include "scene/specimen_cache.h"

namespace frond {

void SpecimenCache::keep(const std::string& key, std::vector<Specimen> grown) {
  std::size_t bytes = grown.capacity() * sizeof(Specimen);
  for (const Specimen& s : grown) bytes += bytes_of(s);
  put(key, std::make_shared<const std::vector<Specimen>>(std::move(grown)), bytes);
}

}  // namespace frond
