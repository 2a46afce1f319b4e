#include "core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <memory>

#include "core/cancellation.h"

namespace frond {

namespace {

/// Whether what this thread is at is given up; null: nobody asks. Threads take it over with their rounds.
thread_local const std::function<bool()>* asks = nullptr;

/// Has it asked for as long as this lives.
class Asking {
 public:
  explicit Asking(const std::function<bool()>* now) : before_(asks) { asks = now; }
  ~Asking() { asks = before_; }
  Asking(const Asking&) = delete;
  Asking& operator=(const Asking&) = delete;

 private:
  const std::function<bool()>* before_;
};

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  // Without isolation a thread that waits for a loop within another takes one more round of the outer one
  // meanwhile: there would be more of them, and of what they hold, than threads.
  isolated([&, whether = asks] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      if (!whether) return body(i);
      Asking asking(whether);
      stay_wanted();
      body(i);
    });
  });
}

void while_wanted(const std::function<bool()>& cancelled, const std::function<void()>& body) {
  if (!cancelled) return body();
  Asking asking(&cancelled);
  body();
}

void stay_wanted() {
  if (asks && (*asks)()) throw Cancelled();
}

void isolated(const std::function<void()>& body) {
  tbb::this_task_arena::isolate([&] { body(); });
}

void limit_threads(int threads) {
  static std::unique_ptr<tbb::global_control> limit;
  limit.reset();
  if (threads > 0) {
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(threads));
  }
}

int thread_count() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace frond
