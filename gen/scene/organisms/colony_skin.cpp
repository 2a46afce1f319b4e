#include "organisms/colony.h"

// What colonies that are bodies have in common, wherever they stand: see colony.h.

namespace frond {

AccretionWorld accretion_world(const Surroundings& around) {
  return {[&](Vec3 at, float within) { return around.room(at, within); },
          [&](Vec3 at) { return around.light(at); }};
}

Model model_of(Surface skin, std::vector<std::vector<Vec3>> past, const Material& material) {
  Solid solid{std::move(skin), material};
  solid.past = std::move(past);
  Model model;
  model.solids.place(model.solids.add_shape(std::move(solid)));
  return model;
}

}  // namespace frond
