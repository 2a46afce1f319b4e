#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace frond {

/// A word in small letters without the ending of its plural: berries, berry; boxes, box; leaves stays.
std::string singular(std::string_view word);

/// How well a text says a word, both in small letters: 3 as a whole word, be it one or many; 2 with an
/// ending, as windy says wind; 1 by a word that begins with it, as window does; 0 not at all.
int says(std::string_view text, std::string_view word);

/// Words of presets that stand for one that people may ask for, the nearest in sense first: of winter snow,
/// frost, season; of tulip crocus, flower. Empty where none is known.
std::vector<std::string> words_like(std::string_view word);

}  // namespace frond
