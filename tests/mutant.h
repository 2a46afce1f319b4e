#pragma once

#include <span>
#include <string>

#include "core/seed.h"

namespace frond {

/// A text with one to three changes: something taken out, a piece or a part of itself put in, or another
/// byte.
inline std::string mutant(std::string text, std::span<const std::string> pieces, Seed seed) {
  for (std::uint64_t i = 0, n = 1 + seed.child("count").bits() % 3; i < n; ++i) {
    Seed place = seed.child("place", i);
    std::size_t at = place.bits() % (text.size() + 1), length = place.child("length").bits() % 8;
    switch (place.child("kind").bits() % 4) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, pieces[place.child("piece").bits() % pieces.size()]);
        break;
      case 2:
        text.insert(at, text.substr(place.child("from").bits() % text.size(), length * 4));
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(place.child("byte").bits());
    }
    if (text.empty()) text = " ";
  }
  return text;
}

}  // namespace frond
