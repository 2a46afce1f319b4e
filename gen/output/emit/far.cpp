#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/linear.h"
#include "emit/setting_parts.h"
#include "settings/forest.h"
#include "settings/settings.h"

namespace frond {

namespace {

constexpr std::array<std::string_view, kFarCovers> kCoverNames{
    "Meadow", "Hay", "Pasture", "Wheat", "Barley", "Rape", "Earth", "Wood", "Mountain"};
constexpr std::array<std::string_view, kFarKinds> kKindNames{"Broadleaf", "Conifer", "Hedge", "House"};

/// Far places need no more decimals than show: a POV-Ray unit is a tenth of a metre.
constexpr MeshText kLandText{.decimals = 1, .uv_decimals = -1},
    kMountainText{.decimals = 1, .uv_decimals = 2};

/// All copies of one kind, shape and tint as one union.
void append_objects(std::string& text, const PovSpace& space, const DistantTerrain& far, FarKind kind,
                    int shape, int tint) {
  std::string_view name = kKindNames[static_cast<std::size_t>(kind)];
  std::string lines, object = fmt::format("Far_{}{}", name, shape);
  for (const FarObject& o : far.objects) {
    if (o.kind != kind || o.shape != shape || o.tint != tint) continue;
    glm::mat3 axes = axes_of(glm::angleAxis(o.turn, Vec3(0, 1, 0)), o.size);
    append_object(lines, space, object, axes, o.foot, {.decimals = 3, .shift_decimals = 1});
  }
  if (lines.empty()) return;
  text += std::string(group_opening(lines)) + lines;
  text += fmt::format("Far_{}({})}}\n", name, tint);
}

}  // namespace

std::string far_air_text(const Scene& scene, double time) {
  SceneSetup setup = setup_at(scene.setup, time);
  const auto& meadow = setup.block<Meadow>();
  std::optional<double> year;
  if (scene.setup.year) year = scene.setup.year->at(time);
  Color grass = year ? grass_at(meadow.grass, *year) : meadow.grass;
  // Where it is not said what time of the year it is, woods are bare under snow.
  double snow = snow_cover(setup), leaves = year ? leaf_share(*year) : 1 - snow;
  return call_text("Far_Air", eye_text(scene, time), drawn_daylight(setup).fog, meadow.haze) + '\n' +
         call_text("Far_Year", linear(grass), number_text(leaves, 3), number_text(snow, 3));
}

std::string far_text(const PovSpace& space, const Scene& scene) {
  const DistantTerrain& far = *scene.far;
  std::string text;
  append_comment(text, "far land");
  double along = degrees(std::atan2(double{far.along.y}, double{far.along.x}));
  for (const FarPart& part : far.parts) {
    if (!has_faces(part.surface)) continue;
    text += "object{\n";
    append_mesh(text, space, part.surface, part.cover == FarCover::mountain ? kMountainText : kLandText);
    text += fmt::format("\nFar_{}({})}}\n", kCoverNames[static_cast<std::size_t>(part.cover)],
                        number_text(along + (part.across ? 90 : 0), 1));
  }
  for (int kind = 0; kind < kFarKinds; ++kind) {
    const std::vector<Surface>& shapes = far.shapes[static_cast<std::size_t>(kind)];
    append_shapes(text, space, shapes, fmt::format("Far_{}", kKindNames[static_cast<std::size_t>(kind)]));
    for (int shape = 0; shape < static_cast<int>(shapes.size()); ++shape)
      for (int tint = 0; tint < kFarTints; ++tint)
        append_objects(text, space, far, static_cast<FarKind>(kind), shape, tint);
  }
  return text;
}

}  // namespace frond
