#pragma once

#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "studio/documents.h"
#include "studio/scenes.h"

namespace frond {

/// Stills that POV-Ray renders, one after the other, each in a thread of its own. They live as long as this.
class Renders {
 public:
  /// Scenes that are at hand are not grown anew.
  Renders(const Documents& documents, Scenes& scenes, std::filesystem::path home);
  /// Ends what is at work, and removes its files.
  ~Renders();

  /// Begins one of a preset at a time in seconds. Errors of the preset are told at once.
  Result<std::string> begin(Doc doc, double time, std::array<int, 2> size, const std::string& quality);
  /// How far it is, see docs/studio.md; nothing where there is none of that name.
  std::optional<Json> state(const std::string& id);
  Json list();
  std::optional<Doc> doc(const std::string& id);
  /// The picture as it is: a small one, over which what is traced is laid, and then the whole.
  Result<std::string> picture(const std::string& id);
  bool cancel(const std::string& id);
  /// Cancels all of them.
  void end();

 private:
  struct Job;
  std::shared_ptr<Job> find(const std::string& id);
  void work(Job& job);
  Errors make(Job& job);
  void clear(Job& job);
  Errors write(Job& job);
  Errors render(Job& job, std::array<int, 2> size, std::string_view flags, const std::string& name);
  void show_traced(Job& job, const std::filesystem::path& notes, std::array<int, 2> size);

  const Documents& documents_;
  Scenes& scenes_;
  std::filesystem::path home_, folder_;
  std::mutex mutex_;              // guards the jobs
  std::condition_variable turn_;  // one renders at a time
  bool busy_ = false;
  std::list<std::shared_ptr<Job>> jobs_;
  int count_ = 0;
};

}  // namespace frond
