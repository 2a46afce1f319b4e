#pragma once

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace frond {

/// A memory limit shared by several caches. When they exceed it, the least recently used entries of any cache
/// are dropped; the newest always stays. Thread-safe.
class CacheBudget {
 public:
  using Thing = std::shared_ptr<const void>;
  using Name = std::pair<int, std::string>;  ///< the cache, and the key in it

  explicit CacheBudget(std::size_t bytes) : capacity_(bytes) {}

  int add_cache();
  Thing find(const Name& name);
  void put(Name name, Thing thing, std::size_t bytes);

  std::size_t capacity() const { return capacity_; }
  std::size_t used() const;
  /// Bytes dropped so far.
  std::size_t evicted() const;

 private:
  struct Kept {
    Name name;
    Thing thing;
    std::size_t bytes;
  };
  using Place = std::list<Kept>::iterator;

  /// Takes out the entries to drop; they are destroyed after the lock is released.
  std::list<Kept> surplus();

  std::size_t capacity_, used_ = 0, evicted_ = 0;
  int caches_ = 0;
  mutable std::mutex mutex_;
  std::list<Kept> kept_;  // most recently used first
  std::map<Name, Place> places_;
};

/// A cache of objects of one type by name.
template <class T>
class LruCache {
 public:
  /// With a memory limit of its own.
  explicit LruCache(std::size_t bytes) : LruCache(std::make_shared<CacheBudget>(bytes)) {}
  explicit LruCache(std::shared_ptr<CacheBudget> budget)
      : budget_(std::move(budget)), own_(budget_->add_cache()) {}

  /// Empty where there is none of that name.
  std::shared_ptr<const T> find(const std::string& name) {
    return std::static_pointer_cast<const T>(budget_->find({own_, name}));
  }

  /// An existing entry of that name is kept.
  void put(const std::string& name, std::shared_ptr<const T> thing, std::size_t bytes) {
    budget_->put({own_, name}, std::move(thing), bytes);
  }

 private:
  std::shared_ptr<CacheBudget> budget_;
  int own_;
};

}  // namespace frond
