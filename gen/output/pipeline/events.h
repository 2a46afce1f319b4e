#pragma once

#include <cstddef>
#include <string_view>

namespace frond {

/// How far the pictures of a run are.
struct RenderedSoFar {
  int done = 0, all = 0;   ///< frames
  int percent = 0;         ///< of what is to be rendered in this run
  bool whole = false;      ///< a frame has just ended; else some of one has been traced
  bool last = false;       ///< it was the last one
  int wanted = 0;          ///< frames that this run renders
  std::string_view words;  ///< all of this for people, with the time that is left
};

/// Whom a run tells how far it is. All but step() and cancelled() are called by the thread that runs it.
class RunEvents {
 public:
  virtual ~RunEvents() = default;

  /// What begins now, which may take its time: "growing what stands in the scene". Of static text.
  virtual void doing(const char* /*what*/) {}
  /// A line for people that wants attention.
  virtual void note(std::string_view /*line*/) {}
  /// A line for people: what was found, what was made.
  virtual void report(std::string_view /*line*/) {}
  /// A phase of so many steps begins, and ends at end().
  virtual void begin(std::string_view /*phase*/, std::size_t /*steps*/) {}
  virtual void step() {}
  virtual void end() {}
  virtual void rendered(const RenderedSoFar& /*frames*/) {}
  /// Whether nobody waits for the run any more. Called often, and by several threads.
  virtual bool cancelled() { return false; }
};

}  // namespace frond
