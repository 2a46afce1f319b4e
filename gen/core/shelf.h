#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace frond {

/// Things that were made once and may be wanted again, by name. Where they come to more bytes than there is
/// room for, those that were not asked for longest go; what was put there last stays. May be asked from many
/// threads.
template <class T>
class Shelf {
 public:
  explicit Shelf(std::size_t bytes) : room_(bytes) {}

  /// Empty where there is none of that name.
  std::shared_ptr<const T> find(const std::string& name) {
    std::lock_guard lock(in_work_);
    auto found = things_.find(name);
    if (found == things_.end()) return nullptr;
    found->second.used = ++now_;
    return found->second.thing;
  }

  /// Where there is one of that name already, it stays.
  void put(const std::string& name, std::shared_ptr<const T> thing, std::size_t bytes) {
    std::lock_guard lock(in_work_);
    if (!things_.try_emplace(name, std::move(thing), bytes, ++now_).second) return;
    taken_ += bytes;
    while (taken_ > room_ && things_.size() > 1) {
      auto oldest =
          std::ranges::min_element(things_, {}, [](const auto& entry) { return entry.second.used; });
      taken_ -= oldest->second.bytes;
      things_.erase(oldest);
    }
  }

 private:
  struct Thing {
    Thing(std::shared_ptr<const T> of, std::size_t size, std::uint64_t at)
        : thing(std::move(of)), bytes(size), used(at) {}
    std::shared_ptr<const T> thing;
    std::size_t bytes;
    std::uint64_t used;  // when, as a count of questions
  };

  std::size_t room_, taken_ = 0;
  std::mutex in_work_;
  std::map<std::string, Thing> things_;
  std::uint64_t now_ = 0;
};

}  // namespace frond
