#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/curve.h"
#include "core/result.h"
#include "organisms/organism.h"

namespace frond {

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

enum class Setting { underwater };

struct Stage {
  Setting setting = Setting::underwater;
  Camera camera;
  Water water;
  Floor floor;
};

/// A preset as the user wrote it: checked, typed, with every default and override in its place (C4).
struct Preset {
  std::string title;
  std::uint64_t seed = 1;
  Film film;
  Stage stage;
  std::vector<Organism> organisms;

  std::string text;  ///< what it was read from, overrides included, as canonical JSON; for hashes
};

/// Reads a preset. `file_name` is for messages; `sets` are `/json/pointer=value` overrides, applied in order.
/// All faults are reported.
Result<Preset> read_preset(std::string_view text, const std::string& file_name,
                           const std::vector<std::string>& sets);

/// The JSON Schema (draft-07) of presets.
std::string preset_schema();

}  // namespace frond
