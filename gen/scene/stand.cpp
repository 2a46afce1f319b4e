#include "scene/stand.h"

#include "settings/settings.h"

namespace frond {

StandHistory stand_history(const Preset& preset) {
  const StandText& text = *preset.stand;
  const SettingAnswers& setting = settings()[preset.stage.setting].answers;
  Seed seed{preset.seed};
  double reach = static_cast<double>(std::max(text.area.x, text.area.y)) / 2;
  std::unique_ptr<Grounds> ground = setting.lay(preset.stage, preset.film, reach, seed);
  auto land = [&](double x, double z) {
    Vec2 at(static_cast<float>(x), static_cast<float>(z));
    return StandGround{static_cast<double>(ground->height(at)), text.moisture};
  };
  return simulate_stand(options_of(text), land, seed.child("stand"));
}

}  // namespace frond
