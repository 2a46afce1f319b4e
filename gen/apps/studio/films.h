#pragma once

#include <condition_variable>
#include <filesystem>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "studio/documents.h"

namespace frond {

/// How a film is to be rendered.
struct FilmOrder {
  std::array<int, 2> size{480, 270};  ///< pixels
  std::string quality = "draft";      ///< a name of kRenderings
  std::string frames;                 ///< A-B, as `frond render --frames`; empty: all
  bool rough = true;                  ///< a small draft of a few frames over the whole film comes first
  bool farm = false;                  ///< Slurm renders it, by `frond farm`
};

/// Films that are rendered for the studio, one after the other. Each has a folder of its own that
/// stays, `out/films/NAME-1` in the folder of presets, with a copy of its preset: a film that is paused is
/// gone on with by this studio or a later one. Where nothing can be written there, a temporary folder.
class Films {
 public:
  explicit Films(const Documents& documents);
  /// Pauses what is at work.
  ~Films();

  /// Begins one; its name. Errors of the preset are told at once.
  Result<std::string> begin(const Doc& doc, const FilmOrder& order);
  /// How far it is, see docs/studio-wire.md; nothing where there is none of that name.
  std::optional<Json> state(const std::string& id);
  /// All of them, the newest first.
  Json list();
  /// These are false where there is none of that name.
  bool pause(const std::string& id);
  bool resume(const std::string& id);
  /// Ends it and removes its folder.
  bool remove(const std::string& id);
  /// A file of it that the page may have: `film.mp4`, `rough.mp4` or these of another format, `watch.png`, or
  /// the picture of a frame by its number. Nothing where it is not there.
  std::optional<std::filesystem::path> file(const std::string& id, const std::string& name);

 private:
  struct Job;
  std::shared_ptr<Job> find(const std::string& id);
  void find_earlier();
  Result<std::filesystem::path> make_folder(const Doc& doc) const;
  void start(const std::shared_ptr<Job>& job);
  void work(Job& job);
  void make(Job& job);
  std::string hand_to_farm(const Job& job, const std::vector<std::string>& sets);
  Json told(const Job& job) const;

  const Documents& documents_;
  std::filesystem::path folder_;
  std::mutex mutex_;              // guards the jobs
  std::condition_variable turn_;  // one renders at a time
  bool busy_ = false;
  std::list<std::shared_ptr<Job>> jobs_;
};

}  // namespace frond
