#include "scene/rain.h"

#include <algorithm>

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
  parallel_for(static_cast<std::size_t>(grid.side), [&](std::size_t r) {
    auto row = static_cast<int>(r);
    for (int column = 0; column < grid.side; ++column)
      grid.height[grid.index(column, row)] = ground.height(grid.low + grid.cell * Vec2(column, row));
  });
  grid.drain.resize(count);
  for (int row = 0; row < grid.side; ++row)
    for (int column = 0; column < grid.side; ++column)
      grid.drain[grid.index(column, row)] = ground.under_water(grid.low + grid.cell * Vec2(column, row));
  return grid;
}

Model water_model(const GroundGrid& grid, double fallen) {
  Model model;
  Surface water = puddles(grid, puddle_depth(fallen));
  if (!water.triangle.empty())
    model.solids.place(model.solids.add_shape(
        {std::move(water), {.matter = Matter::water, .color = {0.42f, 0.43f, 0.42f}}}));
  return model;
}

}  // namespace

std::optional<Specimen> standing_water(const Scene& scene, const Grounds& ground) {
  if (!is_rainy(scene.stage)) return {};
  const Animated<double>& fallen = scene.stage.rain->fallen;
  GroundGrid grid = grid_of(ground, seen_ground(scene.stage.camera, scene.film.length()).first);
  Specimen water;
  water.name = "puddles";
  water.model = water_model(grid, highest(fallen));
  if (water.model.solids.size() == 0) return {};
  if (!fallen.constant())
    water.life.develop = [fallen, grid = std::move(grid)](double time) -> Result<Model> {
      return water_model(grid, fallen.at(time));
    };
  return water;
}

}  // namespace frond
