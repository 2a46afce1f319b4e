#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "world/specimen.h"

namespace frond {

/// Specimens that were grown for earlier scenes, so that a change of one organism grows that one alone. They
/// are known by a hash of all that they grew from. Those used last are kept. May be asked from many threads.
class Nursery {
 public:
  /// Keeps up to so many bytes, about, and always what was brought last.
  explicit Nursery(std::size_t bytes = std::size_t{2} << 30) : most_(bytes) {}

  std::optional<std::vector<Specimen>> find(const std::string& key);
  void keep(const std::string& key, std::vector<Specimen> grown);

 private:
  struct Kept {
    std::vector<Specimen> specimens;
    std::size_t bytes = 0;
    std::uint64_t used = 0;  // when, as a count of questions
  };

  std::size_t most_;
  std::mutex in_work_;
  std::map<std::string, Kept> kept_;
  std::size_t bytes_ = 0;
  std::uint64_t now_ = 0;
};

}  // namespace frond
