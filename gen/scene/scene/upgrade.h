#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/result.h"

namespace frond {

struct Value;

/// A preset of an earlier version in today's form.
struct Upgrade {
  std::string text;  ///< comments and layout are as they were
  Errors changes;  ///< each with its place in the text as it was, and what stands there now; none: nothing is
                   ///< old
};

/// Carries a preset over to the names that properties have today. What a text holds that is no preset stays
/// as it is. `is_there` tells whether a preset may name a file.
Upgrade upgrade_preset(std::string_view text, const std::string& file_name,
                       const std::function<bool(const std::string& name)>& is_there);
/// The same of a text that was parsed.
Upgrade upgrade_preset(std::string_view text, const Value& root,
                       const std::function<bool(const std::string& name)>& is_there);

}  // namespace frond
