#pragma once

#include <optional>
#include <vector>

#include "rocks/stone.h"
#include "settings/setting.h"
#include "settings/water_optics.h"

namespace frond {

/// Flashes or lamps of a diver, which go with the camera.
struct Strobe {
  int count = 2;       ///< 1: above the camera; 2: left and right of it
  double apart = 1.2;  ///< metres between two
  double power = 1;    ///< brightness of a white surface at `reach`, of one in full sun at the surface
  double reach = 2;    ///< metres
  double angle = 100;  ///< degrees, width of the beam
  Color color{1, 1, 1};
};

/// The water round a reef.
struct Water {
  std::optional<WaterType> type = {};  ///< what follows from it: the next three otherwise
  Color near{0.06f, 0.46f, 0.62f};     ///< colour of distant objects
  Color deep{0.02f, 0.22f, 0.38f};     ///< colour seen when looking down
  double visibility = 11;              ///< metres in which two thirds of the light are lost
  double depth = 0;                    ///< metres of water above, which absorb red light
  Vec3 sun{0.35f, 1, 0.35f};           ///< towards the sun
  double caustics = 1;                 ///< strength of the caustics, 0 none
  double shafts = 0.8;                 ///< strength of the light beams, 0 none
  int particles = 60;                  ///< number of floating specks before the camera
  double daylight = 1;                 ///< share of it, 0 at night
  double fill = 1;                     ///< factor of what the water scatters to sides that face no light
  double balance = 0;                  ///< 0 .. 1: white balance of the camera for daylight at `depth`
  std::optional<Strobe> strobe = {};
};

/// Brightness that the sun gives a white surface under the water's surface, before exposure: by eye.
inline constexpr Vec3 kSunAtSurface = 2.25f * Vec3(1.00f, 0.98f, 0.88f);

/// By which the camera's white balance scales each colour; 1 without a type. A sensor sees some red in the
/// blue of deep water, so that it need not raise its red by as much as a screen's, which lamps show.
struct WhiteBalance {
  Vec3 daylight{1}, lamps{1};
};
WhiteBalance white_balance(const Water& water);

/// Share of the contrast of caustics and light beams that is left at the water's depth; 1 without a type.
double caustic_contrast(const Water& water);

/// Width and height of the picture of caustics.
inline int caustic_pixels(Quality quality) { return 224 + 64 * static_cast<int>(quality); }

/// A placed stone.
struct StoneInstance {
  int shape = 0;  ///< index into SeaFloor::stones
  Vec3 at{0};
  Vec3 size{1};     ///< factors along the stone's own axes, metres
  double turn = 0;  ///< radians about the vertical
  int look = 0;     ///< index of the rock texture
};

/// Sand with loose stones, and rocks under corals.
class SeaFloor final : public Grounds {
 public:
  SeaFloor(const Floor& floor, Quality quality, double reach, Seed seed);

  void strew(TakenSpots& taken) override;
  float seat(Vec2 at, double rock, Seed seed) override;
  Land land(std::vector<Spot> taken) const override;
  std::vector<ScatteredInstances> strewn() const override;
  std::size_t bytes() const override;

  std::vector<Surface> stones;
  std::vector<StoneInstance> stone_instances;

 private:
  float lay_stone(Vec2 at, float width, float sunk, Seed seed);

  Floor loose_;
  Seed seed_;
  std::vector<Stone> shapes_;
};

}  // namespace frond
