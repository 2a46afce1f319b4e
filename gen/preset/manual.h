#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "preset/value.h"

namespace frond {

/// One property of presets in words, as the schema has it.
struct Topic {
  std::string path;      ///< `tree/habit/internode`, `film/frames`; of what all kinds have, `organism/place`
  std::string sentence;  ///< what it is; without a full stop
  std::string kind;      ///< `number`, `true or false`, `colour`, `[x, y, z]`, `list of objects` ...
  std::string range;     ///< `0 to 90 degrees`, `1 or more`; empty: all that the kind allows
  std::string unit;      ///< as in the range
  std::string initial;   ///< the default as JSON; empty: none
  std::vector<std::pair<std::string, std::string>> choices;  ///< names that it may have, and what they mean
};

/// All properties of presets, those of an object after it. `schema` is that of presets.
std::vector<Topic> topics_of(const Value& schema);

/// What a user asks for: the topics of that path or of a path that ends with it, each followed by those
/// within; where there is none, those in whose path or words all the words occur. Those that say the same of
/// several kinds are one, and the path names all of them: `coral, plant: wave/speed`.
std::vector<Topic> topics_about(const std::vector<Topic>& topics, std::string_view asked);

/// What a user may have meant by words that topics_about finds nothing for: the nearest path, or the same
/// words with the nearest name for each that is none. Empty where nothing is near.
std::string nearest_topic(const std::vector<Topic>& topics, std::string_view asked);

/// A topic in two lines for a terminal.
std::string topic_text(const Topic& topic);

}  // namespace frond
