#pragma once

#include <functional>

namespace frond {

/// Thrown out of work that nobody waits for any more.
struct GivenUp {};

/// Runs `body`, which ends with GivenUp soon after `given_up()` has become true: at the next round of a
/// parallel_for, on whatever thread, or at stay_wanted(). `given_up` is called often and from several
/// threads; empty: what holds outside of this holds within.
void while_wanted(const std::function<bool()>& given_up, const std::function<void()>& body);

/// For long loops that are no parallel_for: throws GivenUp where nobody waits for this work.
void stay_wanted();

/// Runs `body` so that while it waits for tasks of its own, this thread takes up none of others. For
/// libraries that build by tasks while a lock is held: what was taken up might ask for the lock.
void isolated(const std::function<void()>& body);

}  // namespace frond
