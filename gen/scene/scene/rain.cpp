#include "scene/rain.h"

#include "core/parallel.h"
#include "land/puddles.h"
#include "scene/camera.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr float kPuddlesReach = 18;  // metres from its middle within which puddles are
constexpr float kPuddleCell = 0.1f;  // metres

GroundGrid grid_of(const Grounds& ground, Vec2 middle) {
  GroundGrid grid{
      middle - kPuddlesReach, kPuddleCell, static_cast<int>(2 * kPuddlesReach / kPuddleCell) + 1, {}, {}};
  auto count = static_cast<std::size_t>(grid.side) * static_cast<std::size_t>(grid.side);
  grid.height.resize(count);
  parallel_for(count, [&](std::size_t k) { grid.height[k] = ground.height(grid.place(k)); });
  grid.drain.resize(count);
  for (std::size_t k = 0; k < count; ++k) grid.drain[k] = ground.under_water(grid.place(k));
  return grid;
}

Model water_model(const GroundGrid& grid, const std::vector<float>& full, double fallen) {
  Model model;
  Surface water = puddles(grid, full, puddle_depth(fallen));
  if (!water.triangle.empty())
    model.solids.place(model.solids.add_shape(
        {std::move(water), {.matter = Matter::water, .color = {0.42f, 0.43f, 0.42f}}}));
  return model;
}

}  // namespace

std::optional<Specimen> standing_water(const Scene& scene, const Grounds& ground) {
  if (!is_rainy(scene.setup)) return {};
  const Animated<double>& fallen = scene.setup.rain->fallen;
  GroundGrid grid = grid_of(ground, seen_ground(scene.setup.camera, scene.film.length()).first);
  std::vector<float> full = priority_flood(grid).level;
  Specimen water;
  water.name = "puddles";
  water.model = water_model(grid, full, highest(fallen));
  if (water.model.solids.size() == 0) return {};
  if (!fallen.constant())
    water.life.develop = [fallen, grid = std::move(grid),
                          full = std::move(full)](double time) -> Result<Model> {
      return water_model(grid, full, fallen.at(time));
    };
  return water;
}

}  // namespace frond
