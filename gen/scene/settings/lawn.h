#pragma once

#include <vector>

#include "core/mask.h"
#include "land/turf.h"
#include "settings/garden.h"
#include "settings/setting.h"

namespace frond {

inline constexpr int kTurfShapes = 4;  ///< number of patches per size and mixture
/// Number of plant mixtures of a lawn, each with more of some kinds and less of others; the last is sparse.
inline constexpr int kTurfMixtures = 4;

inline constexpr double kLawnSown = 200;         ///< metres, the square of a lawn that is sown
inline constexpr double kMostPatches = 400'000;  ///< of grass or gravel; each is one POV-Ray object

/// The grass properties of a preset.
struct LawnShape {
  double blade = 0.10;     ///< metres, length of the grass; 0: no blades
  double blades = 900;     ///< per square metre
  double extent = 9;       ///< metres from the middle within which there are single blades
  double flowers = 0.004;  ///< share of blades that bear a flower
  std::vector<Sward> plants{{MeadowPlant::grass, 0.5},
                            {MeadowPlant::fescue, 0.26},
                            {MeadowPlant::cocksfoot, 0.14},
                            {MeadowPlant::panicle, 0.012},
                            {MeadowPlant::clover, 0.09}};
  double bare = 0;  ///< share of patches with a spot of bare earth
  Mask map;         ///< scales the blades over the land
};

/// The colour of grass at a time of the year: its own in May, drier in late summer, straw in winter.
Color grass_at(const Color& summer, double year);

/// Errors for more grass than memory or POV-Ray can hold, at pointers below the scene.
Errors check_grass(const LawnShape& shape);
/// Adds the grass to the estimate.
void estimate_grass(const LawnShape& shape, const Film& film, GroundSizeEstimate& ground);

/// A lawn, level or in low hills, with the pond, the path and the beds of a garden if it has them.
class Lawn final : public Grounds {
 public:
  /// With a garden the distant ground is level.
  Lawn(const Floor& floor, const LawnShape& shape, Quality quality, double reach, Seed seed,
       const Garden* garden = nullptr);

  void strew(TakenSpots& taken) override;
  float seat(Vec2 at, double rock, Seed seed) override;
  Land land(std::vector<Spot> taken) const override;
  bool under_water(Vec2 at) const override { return plot_.pond_distance(at) < 0; }
  std::vector<ScatteredInstances> strewn() const override;
  std::vector<Patches> patches() const override;
  std::vector<Specimen> furnishings() const override;
  LowCover low_cover() const override;
  GroundEdge edge() const override { return {.radius = radius_}; }
  std::size_t bytes() const override;

  /// The pond, the path and the beds; none in a meadow.
  const Plot& plot() const { return plot_; }
  /// Where there is grass, as for kLawnSown metres; empty: all over.
  Mask map() const;

  std::vector<Turf> turf;
  std::vector<Patch> turf_patches;
  std::vector<Surface> gravel, earth;
  std::vector<Patch> gravel_patches, earth_patches;

 private:
  void sow(Seed seed);
  void lay_gravel(Seed seed);
  void lay_earth(Seed seed);

  LawnShape shape_;
  Quality quality_;
  double radius_ = 0;  // metres from the middle to the edge
  Garden garden_;
  Plot plot_;
  Surface water_;  // of the pond, for a quick look
  Seed seed_;
};

}  // namespace frond
