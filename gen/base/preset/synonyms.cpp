#include "preset/synonyms.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "core/text.h"

namespace frond {

namespace {

/// Words that people ask for, and those of presets that are meant.
constexpr std::pair<std::string_view, std::string_view> kLike[] = {
    // flowers and plants that no preset is called by
    {"tulip daffodil narcissus hyacinth snowdrop bulb", "crocus flower"},
    {"lily iris orchid peony poppy dahlia marigold aster gerbera petal bloom blossom", "flower sunflower"},
    {"rose shrub hedge lavender hydrangea azalea box", "bush flower"},
    {"daisy", "dandelion flower"},
    {"vine climber creeper liana wisteria", "ivy creeps"},
    {"lawn turf blade pasture", "grass meadow"},
    {"reed rush bamboo wheat corn", "sedge grass"},
    {"conifer fir evergreen needle christmas", "spruce pine"},
    {"fungus toadstool", "mushroom"},
    {"fruit berry apple", "blueberry organ"},
    {"kelp seaweed alga anemone polyp", "coral reef"},
    {"sponge", "tube coral"},
    {"snail clam mussel seashell", "shell"},
    {"bonsai sapling seedling", "tree years"},
    {"log deadwood stump", "dead fallen"},
    {"foliage frond", "leaves leaf"},
    {"trunk stem bole", "bark thickness"},
    {"twig limb bough", "branch"},
    // weather and seasons
    {"winter ice cold", "snow frost season year"},
    {"spring summer autumn fall", "season year"},
    {"storm gale breeze hurricane gust blow", "wind storm"},
    {"fog mist haze smog", "haze mist fog"},
    {"shower drizzle wet puddle", "rain"},
    {"cloud weather", "clouds sky rain snow"},
    {"night moon sunset sunrise dusk dawn noon evening morning", "hour sun moon"},
    // land and what is built
    {"hill mountain valley slope terrain", "hills relief far mountain"},
    {"water lake river brook sea ocean", "pond stream underwater water"},
    {"flash torch flashlight headlight spotlight", "strobe"},
    {"stone boulder pebble gravel", "rock pebbles"},
    {"fence lattice wire", "trellis"},
    {"pot bowl jar planter", "vase"},
    {"house building ruin pillar", "wall column mesh"},
    {"horizon background backdrop", "far setting"},
    // how things look and move
    {"colour tone hue", "color tint"},
    {"thick girth fat width", "thickness radius"},
    {"droop sag hang bend weeping", "tropism gravity sag"},
    {"random variation chance individual", "seed variation"},
    {"shine glossy wetness", "gloss"},
    {"sway motion animate movement", "wave wind"},
    {"photo image", "picture photo"},
    // pictures and films
    {"speed slow fast rate", "fps speed"},
    {"duration length time", "frames seconds duration"},
    {"resolution pixel dimension", "size quality"},
    {"zoom telephoto wide lens", "angle camera"},
    {"blur bokeh sharp", "aperture focus"},
    {"bright exposure dark", "exposure light"},
    {"transparency alpha", "transparent background"},
    {"lamp lighting illumination", "light sun"},
};

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// The end of the word that begins there.
std::size_t end_of_word(std::string_view text, std::size_t at) {
  while (at < text.size() && is_letter(text[at])) ++at;
  return at;
}

}  // namespace

std::string singular(std::string_view word) {
  std::string one(word);
  auto ends = [&](std::string_view end) { return one.size() > end.size() + 1 && one.ends_with(end); };
  if (ends("ies"))
    one.replace(one.size() - 3, 3, "y");
  else if (ends("xes") || ends("sses") || ends("shes") || ends("ches"))
    one.resize(one.size() - 2);
  else if (ends("s") && !ends("ss") && !ends("us") && !ends("is"))
    one.pop_back();
  return one;
}

int says(std::string_view text, std::string_view word) {
  constexpr std::string_view kEndings[] = {"y", "ed", "ing", "er", "d", "like"};
  int best = 0;
  std::string one = singular(word);
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!is_letter(text[at]) || (at > 0 && is_letter(text[at - 1]))) continue;
    std::string_view there = text.substr(at, end_of_word(text, at) - at);
    if (there == word || singular(there) == one) return 3;
    if (!there.starts_with(one)) continue;
    bool ending = std::ranges::find(kEndings, there.substr(one.size())) != std::end(kEndings);
    best = std::max(best, ending ? 2 : 1);
  }
  return best;
}

std::vector<std::string> words_like(std::string_view word) {
  std::string one = singular(word);
  for (const auto& [asked, meant] : kLike) {
    std::vector<std::string> names = split(asked, ' ');
    if (std::ranges::find(names, one) == names.end()) continue;
    std::vector<std::string> like = split(meant, ' ');
    std::erase(like, one);
    return like;
  }
  return {};
}

}  // namespace frond
