#pragma once

#include <atomic>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "scene/nursery.h"
#include "studio/documents.h"
#include "studio/view.h"

namespace frond {

/// An answer to the page: JSON, or a packet.
struct Answer {
  int status = 200;
  Json json;
  std::string packet;  ///< where not empty, in place of the JSON
};

/// Reads, grows and packs what the page asks to see. What was grown before is kept, so that a change grows
/// what it touches. May be asked from many threads.
class Scenes {
 public:
  explicit Scenes(const Documents& documents) : documents_(documents) {}

  /// A scene at a time, for question number `number` of a session. Where a newer one has come meanwhile the
  /// answer is 409 and nothing more is done for it.
  Answer view(const Doc& doc, const Json& question, const std::string& session, std::uint64_t number);

  /// The word of an organism's grammar and what becomes of it.
  Answer derive(const Doc& doc, const Json& question) const;

  /// A picture of a leaf or bark that a scene has named.
  Result<std::string> picture(const std::string& name);

 private:
  struct Built {
    std::string key;
    Preset preset;
    Scene scene;
  };
  struct Session {
    std::atomic<std::uint64_t> newest{0};
    std::mutex in_work;  // one question at a time
  };

  std::shared_ptr<Session> session(const std::string& name);
  std::shared_ptr<const Built> find(const std::string& key);
  Result<std::shared_ptr<const Built>> build(std::string key, Preset preset,
                                             const std::function<bool()>& given_up);
  /// Where growing what is new takes longer than that many seconds, or more than the machine has.
  Result<Json> foretold(const Preset& preset, double seconds);

  const Documents& documents_;
  Nursery nursery_;
  Greenhouse models_;
  std::mutex in_work_;
  std::map<std::string, std::shared_ptr<Session>> sessions_;
  std::list<std::shared_ptr<const Built>> built_;  // the newest first
  std::set<std::string> known_;                    // organisms that were grown once
  std::map<std::string, Drawing> drawings_;        // by the names of their pictures
  std::map<std::string, std::string> pictures_;
};

}  // namespace frond
