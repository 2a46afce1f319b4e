#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace frond {

/// Calls `body(i)` for each i in 0..count-1 on all threads of the machine, or as many as `limit_threads`
/// allows. The calls must not depend on each other and must write to separate places. May be nested. An
/// exception of one call is rethrown here once all running calls have ended; the remaining calls are skipped.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// What calls have put into a list each, in the order of the calls.
template <class T>
std::vector<T> joined(const std::vector<std::vector<T>>& lists) {
  std::vector<T> all;
  for (const std::vector<T>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Limits parallel_for to that number of threads for the rest of the process; 0 = as many as the machine has.
void limit_threads(int threads);

/// The number of threads that parallel_for uses.
int thread_count();

}  // namespace frond
