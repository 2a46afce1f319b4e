#pragma once

#include <atomic>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "scene/specimen_cache.h"
#include "studio/answers.h"
#include "studio/documents.h"
#include "studio/pick.h"
#include "studio/tiles.h"
#include "studio/trace.h"
#include "studio/view.h"

namespace frond {

/// Reads, grows and packs what the page asks to see. What was grown before is kept, so that a change grows
/// what it touches; all of it together, scenes, organisms, models and what was made ready to be sent, comes
/// to `memory` bytes at most. May be asked from many threads.
class Scenes {
 public:
  Scenes(const Documents& documents, std::size_t memory, BakeOptions bake = {});

  /// A scene at a time, for question number `number` of a session. Where a newer one has come meanwhile the
  /// answer is 409 and nothing more is done for it.
  Answer view(const Doc& doc, const Json& question, const std::string& session, std::uint64_t number);

  /// The scene of a preset that was read from that, grown with what is kept.
  Result<std::shared_ptr<const Scene>> scene(const Doc& doc, Preset preset,
                                             const std::function<bool()>& cancelled);

  /// The branch that a ray meets in a scene, see studio/pick.h.
  Answer pick(const Doc& doc, const Json& question);

  /// A small quick look at a preset that Frond brings or that may be read, as a PNG; an error where it takes
  /// long to grow, or where a scene is asked for meanwhile, which goes first.
  Result<std::string> look(const std::string& file);

  /// A small quick look at a scene at a time, as a PNG; an error where it has not been grown yet.
  Result<std::string> moment(const Doc& doc, double time);

  /// Gives memory that was freed back to the system. For after what has taken much, as a render.
  void tidy();
  /// Bytes that are kept.
  std::size_t kept() const { return budget_->used(); }
  /// How far the growing is that a session waits for: `{"done", "of"}` organisms.
  Json progress(const std::string& session);
  /// Nobody waits for the answer to that question of a session any more.
  void leave(const std::string& session, std::uint64_t number);
  /// Nobody waits for anything any more: what grows ends soon.
  void end() { ending_ = true; }

  /// The word of an organism's grammar and what becomes of it.
  Answer derive(const Doc& doc, const Json& question) const;

  /// Where rays `[x, y, z, dx, dy, dz]` first meet the ground or the entries that are `on`, at a time: what
  /// is drawn in the view comes to lie there.
  Answer trace(const Doc& doc, const Json& question);

  /// The material of an organism on a ball, as a PNG, see studio/ball.cpp.
  Result<std::string> ball(const Doc& doc, std::size_t entry) const;

  /// A picture of a leaf, a bark or a material that a scene has named.
  Result<std::string> picture(const std::string& name);

 private:
  struct Built {
    Preset preset;
    Scene scene;
    std::string sky;  // name of its picture; empty: none
    bool coarse = false;
  };
  /// What the page asks for while somebody drags: just some organisms, and these coarsely.
  struct Hurry {
    EntryFilter only;
    double share = 1;  // of the time that these take
  };
  static Hurry hurry_of(const Json& question);

  struct Session {
    std::atomic<std::uint64_t> newest{0};
    std::atomic<std::size_t> done{0}, of{0};  // organisms that grow
    /// Makes a question the newest, if no newer one has come.
    void ask(std::uint64_t number);
    std::mutex in_work;  // one question at a time
  };

  /// Calls tidy() after so many bytes that were sent or given up, since these lie scattered where many
  /// threads have asked for them.
  void tidy_at_times(std::size_t sent);
  std::shared_ptr<Session> session(const std::string& name);
  std::shared_ptr<const Built> find(const std::string& key);
  Result<std::shared_ptr<const Built>> build(const std::string& key, Preset preset, const ProgressSink& watch,
                                             const Hurry& hurry);
  /// The most that is grown unasked: seconds until it is there, and nodes, which are sent and drawn then.
  struct Bearable {
    double seconds = kAny, nodes = kAny;
    static constexpr double kAny = std::numeric_limits<double>::infinity();
  };
  static Bearable bearable(const Json& question);
  /// What growing what is new takes where that is not bearable, else null; an error where it is more than
  /// the machine has.
  Result<Json> estimate(const Preset& preset, const EntryFilter& only, const Bearable& most);

  /// What `make` makes of the scene of a question at its time: kept, as a tool asks again and again.
  template <class T, class Make>
  Result<std::shared_ptr<const T>> at_time(LruCache<T>& kept, const Doc& doc, const Json& question,
                                           Make make);

  /// Notes how pictures of what bodies and branches are made of are drawn.
  void add_tiles(const Scene& scene);

  const Documents& documents_;
  BakeOptions bake_;
  std::shared_ptr<CacheBudget> budget_;
  SpecimenCache cache_{budget_};
  ViewCache models_{budget_};
  LruCache<Built> built_{budget_};
  LruCache<PosedScene> posed_{budget_};
  LruCache<Traceable> traced_{budget_};
  LruCache<std::string> pictures_{budget_};
  LruCache<Drawing> drawings_;                       // by the names of their pictures
  std::atomic<std::size_t> sent_{0}, tidied_at_{0};  // bytes, see tidy_at_times()
  std::mutex looking_;                               // one at a time
  std::atomic<std::uint64_t> views_{0};              // scenes that were asked for
  std::atomic<bool> ending_{false};
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Session>> sessions_;
  std::set<std::string> known_;  // organisms that were grown once
};

}  // namespace frond
