#pragma once

#include <string>

// Numbers formatted for people.

namespace frond {

/// A number of bytes: "123 kB", "12.3 GB".
std::string bytes_text(double bytes);

/// Seconds: "0.4 s", "42 s", "12 min", "3.5 h", "12 days".
std::string seconds_text(double seconds);

/// A whole number, rounded where it is large: "12345", "3.2 million", "45 billion", "10^23".
std::string count_text(double count);

}  // namespace frond
