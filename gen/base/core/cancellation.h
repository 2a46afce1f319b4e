#pragma once

#include <functional>

namespace frond {

/// Thrown out of work that nobody waits for any more.
struct Cancelled {};

/// Runs `body`, which ends with Cancelled soon after `cancelled()` has become true: at the next round of a
/// parallel_for, on whatever thread, or at stay_wanted(). `cancelled` is called often and from several
/// threads; empty: what holds outside of this holds within.
void while_wanted(const std::function<bool()>& cancelled, const std::function<void()>& body);

/// For long loops that are no parallel_for: throws Cancelled where nobody waits for this work.
void stay_wanted();

/// Runs `body` so that while it waits for tasks of its own, this thread takes up none of others. For
/// libraries that build by tasks while a lock is held: what was taken up might ask for the lock.
void isolated(const std::function<void()>& body);

}  // namespace frond
