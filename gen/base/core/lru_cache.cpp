#include "core/lru_cache.h"

namespace frond {

namespace {

/// What one takes besides itself: its name twice, the nodes of list and map.
constexpr std::size_t kBookkeeping = 400;

}  // namespace

int CacheBudget::add_cache() {
  std::lock_guard lock(mutex_);
  return caches_++;
}

CacheBudget::Thing CacheBudget::find(const Name& name) {
  std::lock_guard lock(mutex_);
  auto found = places_.find(name);
  if (found == places_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, found->second);
  return found->second->thing;
}

void CacheBudget::put(Name name, Thing thing, std::size_t bytes) {
  std::list<Kept> gone;
  std::lock_guard lock(mutex_);
  if (places_.contains(name)) return;
  kept_.push_front({name, std::move(thing), bytes + kBookkeeping});
  places_.emplace(std::move(name), kept_.begin());
  used_ += kept_.front().bytes;
  gone = surplus();
}

std::size_t CacheBudget::used() const {
  std::lock_guard lock(mutex_);
  return used_;
}

std::size_t CacheBudget::evicted() const {
  std::lock_guard lock(mutex_);
  return evicted_;
}

std::list<CacheBudget::Kept> CacheBudget::surplus() {
  std::list<Kept> gone;
  while (used_ > capacity_ && kept_.size() > 1) {
    gone.splice(gone.begin(), kept_, std::prev(kept_.end()));
    places_.erase(gone.front().name);
    used_ -= gone.front().bytes, evicted_ += gone.front().bytes;
  }
  return gone;
}

}  // namespace frond
