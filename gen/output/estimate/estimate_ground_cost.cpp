#include "estimate/estimate_ground_cost.h"

#include <algorithm>
#include <cmath>

#include "draw/ambience.h"
#include "emit/pov.h"
#include "emit/setting.h"
#include "film/soft_light.h"
#include "scene/bounds.h"
#include "scene/camera.h"
#include "scene/far.h"
#include "scene/snow.h"
#include "settings/settings.h"

namespace frond {

namespace {

// Ground that is not laid for the forecast, as measured over the presets: bytes of text of a triangle, of one
// whose triangles share few corners, of a placement; bytes of memory of a triangle and of a placement.
constexpr double kLaidTriangleText = 39, kGrassTriangleText = 100, kLaidPlacementText = 122;
constexpr double kLaidTriangleHeld = 40, kLaidPlacementHeld = 60;
constexpr double kLaidAtOnce = 1e6;                        // triangles and placements
constexpr double kGroundLaid = 1e6, kGroundWritten = 5e7;  // triangles and placements a second; bytes
// Soft light: bytes of a line of its file; lines for a column of cells on bare land, on land where grass or
// litter stands, and for each cell in grass or litter.
constexpr double kProbeText = 61, kProbesBare = 4, kProbesCovered = 9, kProbesCover = 6;
constexpr double kCrowdedProbes = 2.2;  // times as many where what is sown or dense grass fills the view
constexpr double kDenseCover = 2;       // m2 of leaves a square metre
// Bytes of memory that a cell and a line take; seconds of each.
constexpr double kCellHeld = 29, kProbeHeld = 150;
constexpr double kCellLit = 5.4e-8, kProbeLit = 4.1e-6;
constexpr double kTriangleLit = 1.4e-7;  // of one that stands before it is in the grids
constexpr double kFarVertexLaid = 5e-6;  // seconds: of the far land, for the forecast and again
constexpr double kPlainLight = 0.65;     // of the time that rays take whose light passes through a picture
// Snow on the ground, for each triangle: bytes of text and of memory, seconds. Puddles: bytes of text,
// seconds.
constexpr double kSnowText = 40, kSnowHeld = 190, kSnowLaid = 8e-6;
constexpr double kPuddlesText = 3e5, kPuddlesFilled = 0.05;
// A picture that a frame has of its own, for each pixel: bytes, seconds.
constexpr double kOwnPixelBytes = 0.25, kOwnPixelSeconds = 8e-7;

}  // namespace

double tallest_of(const Preset& preset) {
  const Camera& camera = preset.setup.camera;
  Vec3 at = camera.location.at(0), to = camera.look_at.at(0);
  constexpr double kTallest = 20;  // metres, of what does not know it
  double half = std::tan(radians(camera.angle.at(0)) / 2) * preset.film.aspect();
  double seen = std::min(kTallest, to.y + glm::distance(at, to) * half), tall = 0;
  for (const Organism& organism : preset.organisms) {
    if (organism.count == 0 && !organism.sown) continue;
    double most = organism.grower->traits().tallest;
    double own = most * (1 + organism.place.size_variation) + organism.place.raise;
    tall = std::max(tall, most > 0 ? own : seen);
  }
  return tall;
}

GroundCostEstimate estimate_ground_cost(const Preset& preset, double tall, bool crowded, double standing) {
  GroundCostEstimate cost;
  const SettingAnswers& setting = settings()[preset.setup.setting].answers;
  GroundSizeEstimate laid = setting.estimate_size(preset.setup, preset.film);
  cost.pictures = kOwnPixelBytes * laid.pixels;
  cost.picture_seconds = kOwnPixelSeconds * laid.pixels;
  if (has_pictures(preset.setup) && laid.pixels == 0) cost.tracing = kPlainLight;
  double pieces = laid.triangles + laid.grass + laid.placed;
  cost.memory = kLaidTriangleHeld * (laid.triangles + laid.grass) + kLaidPlacementHeld * laid.placed;

  Scene scene;
  scene.film = preset.film;
  scene.setup = preset.setup;
  std::unique_ptr<Grounds> ground =
      setting.lay(preset.setup, preset.film, reach_of(preset), Seed{preset.seed});
  if (preset.setup.camera.follow) scene.setup.camera = over_ground(preset.setup.camera, ground->heights());
  bool moment = pieces < kLaidAtOnce;
  if (moment) {
    TakenSpots taken;
    ground->strew(taken);
    ground->lay_litter(scene.setup.camera);
  }
  scene.ground = std::move(ground);
  if (std::optional<DistantTerrain> far = far_land_round(scene, Seed{preset.seed}.child("far"))) {
    for (const FarPart& part : far->parts)
      cost.seconds += kFarVertexLaid * static_cast<double>(part.surface.position.size());
    scene.far = std::make_shared<const DistantTerrain>(std::move(*far));
  }
  cost.bytes = moment ? static_cast<double>(ground_text(PovSpace{}, scene).size())
                      : kLaidTriangleText * laid.triangles + kGrassTriangleText * laid.grass +
                            kLaidPlacementText * laid.placed;
  cost.seconds += pieces / kGroundLaid + cost.bytes / kGroundWritten;
  if (is_snowy(preset.setup) && preset.setup.snow.deepest() > 0) {
    double rings = snow_rings(preset.film.quality), triangles = 4 * rings * rings;
    cost.bytes += kSnowText * triangles, cost.memory += kSnowHeld * triangles;
    cost.seconds += kSnowLaid * triangles;
  }
  if (is_rainy(preset.setup)) cost.bytes += kPuddlesText, cost.seconds += kPuddlesFilled;
  if (!has_soft_light(preset.setup)) return cost;
  SoftLight::Size light = estimate_light(scene, tall);
  crowded = crowded || scene.ground->low_cover().area > kDenseCover;
  double probes = light.cover > 0 || crowded ? kProbesCovered * light.land + kProbesCover * light.cover
                                             : kProbesBare * light.land;
  if (crowded) probes *= kCrowdedProbes;
  cost.light_bytes = kProbeText * probes;
  cost.light_memory = kCellHeld * light.cells + kProbeHeld * probes;
  cost.light_seconds = kCellLit * light.cells + kProbeLit * probes + kTriangleLit * standing;
  return cost;
}

}  // namespace frond
