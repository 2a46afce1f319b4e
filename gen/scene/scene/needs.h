#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "preset/value.h"

namespace frond {

/// What the sentence of a property says that it does nothing without: `Needs "shape": "own"`, `Needs "build":
/// "fused" or "rough"`, `Needs "sprig": true`, `Needs a patch above 0`, `Needs fading other than diffuse`.
/// Always of a property beside it.
struct Need {
  std::string_view name;  ///< of that property
  enum class Of { equal, other, above_0 } of = Of::equal;
  std::string_view value;  ///< as JSON, but for a text without its first and last quote
  std::string_view words;  ///< what follows the word "Needs"
};

/// The need in a sentence; nothing where it has none, or one of another kind, such as `Needs a coat`.
std::optional<Need> need_of(std::string_view sentence);

/// Calls `unmet` with each property of an organism that does nothing, for want of what its sentence needs:
/// the value, the pointer to it below the organism, and the words of the need. `organism` is as a preset has
/// it, with what the defaults say.
void find_unmet(const Value& organism,
                const std::function<void(const Value&, const std::string&, std::string_view)>& unmet);

}  // namespace frond
