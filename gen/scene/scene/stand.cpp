#include "scene/stand.h"

#include <cmath>

#include "settings/settings.h"

namespace frond {

namespace {

constexpr double kVerge = 1.2;    // metres along paths on which no tree stands
constexpr double kNoSoil = -100;  // moisture at which nothing comes up

/// The events of a preset in the years of its stand. Trees are felled and pruned by the organism that they
/// are drawn as.
std::vector<StandEvent> events_of(const Preset& preset) {
  std::vector<StandEvent> events;
  for (const Event& event : preset.events) {
    int year = std::max(1, static_cast<int>(std::lround(event.year)));
    if (event.storm > 0) events.push_back({.year = year, .storm = event.storm});
    for (const TreeText& tree : preset.stand->species) {
      if (event.cut && concerns(event.cut->entry, tree.organism))
        events.push_back({.year = year, .cut = tree.name, .share = event.cut->share});
      if (event.prune && concerns(event.prune->entry, tree.organism))
        events.push_back({.year = year, .pruned = tree.name, .below = event.prune->below});
    }
  }
  return events;
}

}  // namespace

StandHistory stand_history(const Preset& preset, const Grounds& ground) {
  Land laid = ground.land({});
  auto land = [&](double x, double z) {
    Vec2 at(x, z);
    bool trodden = laid.path && laid.path(at) < kVerge;
    return StandGround{static_cast<double>(ground.height(at)), trodden ? kNoSoil : preset.stand->moisture};
  };
  StandOptions options = options_of(*preset.stand);
  options.events = events_of(preset);
  return simulate_stand(options, land, Seed{preset.seed}.child("stand"));
}

StandFilm stand_film(const Film& film, const std::optional<Vec2>& shown, int years) {
  Vec2 all = shown.value_or(Vec2(0, years));
  return {film.frames <= 1 ? all.y - 0.01 : double{all.x}, double{all.y}, film.length()};
}

std::optional<std::size_t> drawn_as(const Preset& preset, const std::string& name) {
  if (name.empty()) return std::nullopt;
  for (std::size_t entry = 0; entry < preset.organisms.size(); ++entry)
    if (preset.organisms[entry].sown && preset.organisms[entry].name == name) return entry;
  return std::nullopt;
}

StandHistory stand_history(const Preset& preset) {
  const StandText& text = *preset.stand;
  const SettingAnswers& setting = settings()[preset.setup.setting].answers;
  double reach = static_cast<double>(std::max(text.area.x, text.area.y)) / 2;
  return stand_history(preset, *setting.lay(preset.setup, preset.film, reach, Seed{preset.seed}));
}

}  // namespace frond
