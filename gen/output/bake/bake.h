#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "images/raster.h"
#include "model/solid.h"

/// Materials as pictures for other programs: POV-Ray itself draws them, from the macros of povinc/.
///
/// A flat piece of the material is drawn in ambient light alone, which gives its colours, and lit from three
/// sides, which gives the normals of its relief whatever its colours are (photometric stereo, Woodham 1980).
/// So no macro needs to know of this, and nothing else describes what a material looks like.
namespace frond {

/// A piece of a material.
struct Swatch {
  std::vector<std::string_view> includes;  ///< files of povinc/, as `stone` for frond_stone.inc
  std::string before;                      ///< declarations that the texture needs
  std::string texture;                     ///< `texture{...}`
  std::array<int, 2> pixels{512, 512};     ///< even numbers
  double wide = 1;                         ///< metres; its height follows from the pixels
  Vec3 corner{0};       ///< metres, POV-Ray's axes: where its lower left corner is in the texture
  Vec3 light{1};        ///< linear factor of the colours
  bool repeats = true;  ///< its edges are blended so that it goes on over them
  bool relief = true;   ///< whether its normals are wanted
  bool spread = false;  ///< texture coordinates go from 0 to 1 over it; otherwise they are `uv` everywhere
  Vec2 uv{1, 0};
  Surface body = {};  ///< where given, drawn instead of a flat piece, as its uv spread it; without normals
  std::vector<Vec2> place;  ///< of the body's vertices on the picture; without, their uv
};

/// A piece of a body's material, as many widths of its pattern as its row says; that row's `widths` must be
/// above 0.
Swatch body_swatch(const Material& material, int pixels);

/// PNG files; those of normals and of roughness are empty where they are not wanted.
struct BakedPictures {
  std::string colors;              ///< sRGB
  std::string normals;             ///< tangent space: x to the right, y up
  std::string roughness;           ///< in green, of half as many pixels
  std::optional<Color> mean = {};  ///< of the colours of a swatch
};

struct BakeOptions {
  std::filesystem::path home = {};   ///< the folder that holds povinc/ and scripts/povray.ini
  std::filesystem::path cache = {};  ///< where pictures are kept by what they are made of; empty: nowhere
  std::string povray = "povray";
};

/// The files of pictures that are there, with the roughness that follows from the normals; `rough` is that of
/// what is smooth, 0..1. The mean is not told.
Result<BakedPictures> picture_files(const Raster& colors, const Raster& normals, double rough);

/// A small scene for POV-Ray, complete but for povinc/ and some files beside it.
struct SmallScene {
  std::string text;
  std::array<int, 2> pixels{160, 160};
  bool smooth = true;                                           ///< antialiased
  int rows = 0;                                                 ///< only so many from the top; 0: all
  std::vector<std::pair<std::string, std::string>> files = {};  ///< names and bytes
};
/// Its picture as a PNG in sRGB. For looking at; nothing is kept.
Result<std::string> small_picture(const SmallScene& scene, const BakeOptions& options);

/// The scene that a swatch is drawn by.
std::string swatch_scene(const Swatch& swatch);

/// Draws a swatch; `rough` is the roughness of what is smooth, 0..1. An error where POV-Ray is missing or
/// fails.
Result<BakedPictures> bake(const Swatch& swatch, double rough, const BakeOptions& options);

}  // namespace frond
