#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "preset/value.h"

namespace frond {

/// The documentation of one property of presets, from the schema.
struct Topic {
  std::string path;      ///< `tree/habit/internode`, `film/frames`; common to all kinds: `organism/place`
  std::string sentence;  ///< description without a full stop
  std::string kind;      ///< `number`, `true or false`, `colour`, `[x, y, z]`, `list of objects` ...
  std::string range;     ///< `0 to 90 degrees`, `1 or more`; empty: no limits
  std::string unit;      ///< as in the range
  std::string initial;   ///< the default as JSON; empty: none
  std::vector<std::pair<std::string, std::string>> choices;  ///< allowed names, and their meanings
};

/// All properties of presets; those of an object follow it. `schema` is that of presets.
std::vector<Topic> topics_of(const Value& schema);

/// Search: the topics of that path or of paths that end with it, each followed by its members; otherwise
/// those whose path or text says all the words, the best first. Equal topics of several kinds are merged,
/// with all of them in the path: `coral, plant: wave/speed`.
std::vector<Topic> topics_about(const std::vector<Topic>& topics, std::string_view asked);

/// A suggestion for words without result: the nearest path, or the same words with unknown ones replaced by
/// the names that they are slips of the keys for. Empty if nothing is near.
std::string nearest_topic(const std::vector<Topic>& topics, std::string_view asked);

/// A topic in two lines for a terminal.
std::string topic_text(const Topic& topic);

}  // namespace frond
