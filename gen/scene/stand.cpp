#include "scene/stand.h"

#include "settings/settings.h"

namespace frond {

namespace {

constexpr double kVerge = 1.2;    // metres along paths on which no tree stands
constexpr double kNoSoil = -100;  // moisture at which nothing comes up

}  // namespace

StandHistory stand_history(const Preset& preset, const Grounds& ground) {
  Land laid = ground.land({});
  auto land = [&](double x, double z) {
    Vec2 at(static_cast<float>(x), static_cast<float>(z));
    bool trodden = laid.path && laid.path(at) < kVerge;
    return StandGround{static_cast<double>(ground.height(at)), trodden ? kNoSoil : preset.stand->moisture};
  };
  return simulate_stand(options_of(*preset.stand), land, Seed{preset.seed}.child("stand"));
}

StandHistory stand_history(const Preset& preset) {
  const StandText& text = *preset.stand;
  const SettingAnswers& setting = settings()[preset.stage.setting].answers;
  double reach = static_cast<double>(std::max(text.area.x, text.area.y)) / 2;
  return stand_history(preset, *setting.lay(preset.stage, preset.film, reach, Seed{preset.seed}));
}

}  // namespace frond
