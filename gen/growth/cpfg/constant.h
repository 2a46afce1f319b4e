#pragma once

#include <optional>
#include <string_view>

namespace frond::cpfg {

/// The value of the formula of an `#if`: whole numbers, names (which are 0), and C's operators but `?:` and
/// those on bits. Nothing where it is none.
std::optional<long long> constant_value(std::string_view text);

}  // namespace frond::cpfg
