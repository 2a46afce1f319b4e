#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve.h"
#include "core/result.h"
#include "geometry/plot.h"
#include "land/terrain.h"
#include "organisms/organism.h"

namespace frond {

struct Value;

enum class Quality { draft, good, best };

struct Film {
  int frames = 72;  ///< 1: a still
  double fps = 24;
  std::array<int, 2> size{480, 270};  ///< width and height, pixels
  Quality quality = Quality::draft;

  double length() const { return frames / fps; }              ///< seconds
  double time(int frame) const { return (frame - 1) / fps; }  ///< of a frame, the first being 1
};

struct Camera {
  Animated<Vec3> location{Vec3(0, 1.0f, 5)};
  Animated<Vec3> look_at{Vec3(0, 0.5f, 0)};
  Animated<double> angle{45.0};  ///< degrees, the width of the view
  bool follow = false;           ///< heights count from the ground below, not from y = 0
};

/// The water round a reef.
struct Water {
  Color near{0.06f, 0.46f, 0.62f};  ///< what distance fades to
  Color deep{0.02f, 0.22f, 0.38f};  ///< looking down into the depth
  double visibility = 11;           ///< metres in which two thirds of the light are lost
  Vec3 sun{0.35f, 1, 0.35f};        ///< towards the sun
  double caustics = 1;              ///< strength of the light's dance, 0 none
  double shafts = 0.8;              ///< strength of the beams of light, 0 none
  int particles = 60;               ///< specks that drift before the camera
};

struct Floor {
  double relief = 0.14, scale = 3.2;  ///< metres, see Ground
  int stones = 50;                    ///< loose stones
  double stone_size = 0.22;           ///< metres, of the largest of them
  double extent = 7;                  ///< metres round the origin in which they lie
};

/// Clear light indoors.
struct Studio {
  Color wall{0.87f, 0.86f, 0.83f};  ///< of wall and floor
  double distance = 1.5;            ///< metres from the middle of the scene to the wall behind it
  Vec3 key{-0.6f, 0.9f, 0.8f};      ///< toward the main light
  double softness = 1;              ///< of its shadows, 0 hard .. 3
};

/// A summer's day outdoors.
struct Meadow {
  Color zenith{0.22f, 0.45f, 0.78f};   ///< of the sky above
  Color horizon{0.80f, 0.88f, 0.93f};  ///< of the sky far off, and of the haze
  Color grass{0.43f, 0.53f, 0.17f};
  Vec3 sun{0.5f, 0.75f, 0.6f};  ///< toward the sun
  double haze = 200;            ///< metres in which two thirds of a colour are lost
  double clouds = 0.45;         ///< 0 none .. 1 overcast
  double blade = 0.10;          ///< metres, length of the grass; 0: none stands
  double blades = 900;          ///< of grass on a square metre
  double extent = 9;            ///< metres round the middle in which single blades stand
  double flowers = 0.004;       ///< share of blades that bear a flower
};

/// What a garden has beside the lawn and the sky of a meadow, whose colours the hour gives here.
struct Garden {
  double hour = 10;  ///< of the day: 6 dawn, 12 noon, 19 dusk
  double south = 0;  ///< radians; where the sun stands at noon: 0 toward +z, to the right from there
  PondShape pond;
  PathShape path;
  int lilies = 0;        ///< leaves of water lilies on the pond
  double gravel = 0.05;  ///< metres, the stones of the path
  Color gravel_color{0.62f, 0.57f, 0.49f};
};

/// A wood on hilly land; sky and haze are the meadow's, whose colours the hour gives here.
struct Forest {
  double hour = 10;  ///< of the day: 6 dawn, 12 noon, 19 dusk
  double south = 0;  ///< radians; where the sun stands at noon: 0 toward +z, to the right from there
  double mist = 0;   ///< metres above the valleys that morning mist reaches; 0: none
  TerrainShape terrain;
  Color litter{0.43f, 0.35f, 0.26f};  ///< of fallen leaves and earth
  double moss = 0.4;                  ///< share of the ground that is green, 0..1
};

enum class Setting { underwater, studio, meadow, garden, forest };

struct Stage {
  Setting setting = Setting::underwater;
  Camera camera;
  Water water;
  Studio studio;
  Meadow meadow;
  Garden garden;
  Forest forest;
  Floor floor;
};

/// A preset as the user wrote it: checked, typed, with every default and override in its place (C4).
struct Preset {
  std::string title;
  std::string base;  ///< a preset that this one is laid over, as seen from its folder; empty: none
  std::uint64_t seed = 1;
  Film film;
  Stage stage;
  std::vector<Organism> organisms;

  std::string text;  ///< what it was read from, overrides included, as canonical JSON; for hashes
  std::shared_ptr<const Value> written;  ///< the same with its places, defaults merged into the organisms
  Errors notes;                          ///< no faults, but what the user should know
};

/// Reads a preset, and the one that it builds on. `file_name` is for messages and tells the folder; `sets`
/// are `/json/pointer=value` overrides, applied in order; `only` is that of Assets. All faults are reported.
Result<Preset> read_preset(std::string_view text, const std::string& file_name,
                           const std::vector<std::string>& sets,
                           const std::optional<std::filesystem::path>& only = {});

/// What is found wrong with the value at a JSON pointer after reading, with its place.
Error fault_at(const Preset& preset, const std::string& pointer, std::string what);

/// The JSON Schema (draft-07) of presets.
std::string preset_schema();

}  // namespace frond
