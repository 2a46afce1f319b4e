#pragma once

#include <memory>

#include "land/terrain.h"
#include "settings/forest_floor.h"
#include "settings/meadow.h"

namespace frond {

/// A wood on hilly land; sky and haze are those of the meadow, with the sun of the hour.
struct Forest {
  Animated<double> hour{10.0};
  Moment when;             ///< its own hour counts for nothing
  double mist = 0;         ///< metres above the valleys, top of the morning mist; 0: none
  double brighten = 0.75;  ///< stops above the exposure of the open land: little light falls below crowns
  TerrainShape terrain;
  Color litter{0.43f, 0.35f, 0.26f};  ///< of fallen leaves and earth
  Color green{0.37f, 0.42f, 0.13f};   ///< of moss
  Color air{0.83f, 0.906f, 0.762f};   ///< of what hangs between the trunks, lit through the crowns
  double moss = 0.4;                  ///< share of the ground that is mossy, 0..1
  Mask moss_map;                      ///< scales that over the land
};

/// Share of the leaves of summer that woods bear at a time of the year, 0..1.
double leaf_share(double year);

/// Hilly land, with litter wherever the camera comes near during the film.
class ForestGround final : public Grounds {
 public:
  /// The lines count where the land is worn to mountains.
  ForestGround(const Forest& forest, const Film& film, Seed seed, const AltitudeLines& lines = {});

  void strew(TakenSpots&) override {}
  void lay_litter(const Camera& camera) override;
  float seat(Vec2 at, double, Seed) override { return height(at); }
  Land land(std::vector<Spot> taken) const override;
  std::vector<Specimen> furnishings() const override;
  std::vector<ScatteredInstances> strewn() const override;
  std::vector<ScatteredInstances> adrift(double time, double loop) const override;
  std::vector<Patches> patches() const override;
  LowCover low_cover() const override { return {.height = 0.05, .area = 0.5}; }
  /// The wood hides what is far off: there is none unless a preset asks for it.
  GroundEdge edge() const override;
  std::size_t bytes() const override;

  const StreamCourse& stream() const { return terrain_->stream(); }
  /// The surfaces of the stream's water and of its bed.
  const Surface& water() const { return water_; }
  const Surface& bed() const { return bed_; }

  /// The path.
  const Plot& plot() const { return plot_; }

  bool mountain = false;  ///< whether `uv` of the floor is that of mark_mountain()
  ForestCover cover;
  float valley = 0;  ///< metres, the lowest height of the sown land, at most 0

 private:
  ForestLand floor_land() const;

  AltitudeLines lines_;
  double size_, moss_;
  Mask moss_map_;
  Film film_;
  Seed seed_;
  std::shared_ptr<const Terrain> terrain_;
  Plot plot_;
  Surface water_, bed_;
  std::vector<Surface> leaves_;  // that drift on it
};

}  // namespace frond
