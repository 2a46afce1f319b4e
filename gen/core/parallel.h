#pragma once

#include <cstddef>
#include <functional>

namespace frond {

/// Calls `body(i)` for each i in 0..count-1, on as many threads as the machine has or `limit_threads` allows.
/// The calls must not depend on one another; what they return must go to places of their own. May be nested.
/// An exception of one call comes out here, once the calls that have begun are over; others are left out.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// Holds parallel_for to so many threads for the rest of the process; 0 = as many as the machine has.
void limit_threads(int threads);

/// How many threads that is.
int thread_count();

}  // namespace frond
