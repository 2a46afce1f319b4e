#pragma once

#include <string>
#include <vector>

#include "core/shelf.h"
#include "world/specimen.h"

namespace frond {

/// Specimens that were grown for earlier scenes, so that a change of one organism grows that one alone. They
/// are known by a hash of all that they grew from. May be asked from many threads.
class Nursery : public Shelf<std::vector<Specimen>> {
 public:
  /// Keeps up to so many bytes, about.
  explicit Nursery(std::size_t bytes = std::size_t{2} << 30) : Shelf(bytes) {}
  explicit Nursery(std::shared_ptr<Storeroom> room) : Shelf(std::move(room)) {}

  void keep(const std::string& key, std::vector<Specimen> grown);
};

}  // namespace frond
