#pragma once

#include <any>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/curve.h"
#include "core/ease.h"
#include "core/mask.h"
#include "core/vec.h"
#include "land/far_land.h"
#include "motion/wind.h"

namespace frond {

enum class Quality { draft, good, best };

/// What a picture shows round what grows.
enum class Background {
  scene,       ///< everything
  ground,      ///< the ground; where the sky, a backdrop or far land would be, it is transparent
  transparent  ///< nothing: what grows and stands there is alone
};

/// A part of a picture, in pixels from its upper left corner.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

struct Film {
  int frames = 72;  ///< 1: a still
  double fps = 24;
  std::array<int, 2> size{480, 270};  ///< width and height, pixels
  Quality quality = Quality::draft;
  /// Whether frames are resolved from raw ones, see resolve/resolve.h. No property of presets.
  bool raw = false;
  /// Whether light that the air scatters is added (SceneSetup::air), which only resolved frames know.
  bool air = false;
  Background background = Background::scene;
  /// Pixels: twigs of large plants that are no longer than that, where the camera comes nearest to them, are
  /// copies of some hundred of them, see draw/twig_plan.h; 0: each is drawn by itself.
  double twigs = 25;
  // How pictures are written, by options of the commands; no properties of presets.
  int depth = 8;                       ///< bits of a channel, 8 or 16
  double dpi = 0;                      ///< pixels an inch, which a still says; 0: it says none
  std::optional<PixelRect> crop = {};  ///< the part that is drawn; none: the whole

  bool transparent() const { return background != Background::scene; }
  /// Whether POV-Ray has to draw all samples: raw frames know neither opacity nor parts.
  bool sampled() const { return transparent() || crop; }
  /// Width and height of its pictures.
  std::array<int, 2> picture_size() const { return crop ? std::array{crop->width, crop->height} : size; }

  double length() const { return frames / fps; }              ///< seconds
  double loop() const { return frames > 1 ? length() : 0; }   ///< after which it repeats; 0: a still
  double time(int frame) const { return (frame - 1) / fps; }  ///< of a frame, the first being 1
  double aspect() const { return static_cast<double>(size[1]) / size[0]; }  ///< height by width
  /// Width and height of what POV-Ray draws: a raw still has four samples a pixel, as it has no other frames.
  std::array<int, 2> drawn_size() const {
    int fine = raw && frames == 1 ? 2 : 1;
    return {fine * size[0], fine * size[1]};
  }
};

inline constexpr std::string_view kFitAll = "all";  ///< instead of names: every organism

/// The focus: a point, or the organism of a name where the camera sees it.
struct Focus {
  Animated<Vec3> point{Vec3(0)};
  std::string organism;  ///< empty: the point is used
};

/// A way round a point while the film lasts.
struct Orbit {
  double turn = 2 * kPi;       ///< radians, to the right as the camera looks at its middle
  double rise = 0;             ///< metres by which it ends higher
  std::optional<Vec3> center;  ///< none: the point that it looks at
};

/// A straight way from where the camera stands while the film lasts.
struct Rail {
  Vec3 to{0, 1, 3};
};

/// The unrest of a camera that is held by hand.
struct Shake {
  double amplitude = radians(0.4);  ///< radians, to each side
  double frequency = 0.7;           ///< swings a second, of the slowest and widest
  bool loop = true;                 ///< whole swings over the film, so that it can be repeated
};

/// See scene/camera_move.h.
struct CameraMove {
  std::optional<Orbit> orbit;
  std::optional<Rail> rail;
  std::optional<Shake> shake;
  Ease ease = Ease::none;  ///< of orbit and rail
};

/// Where light comes from, as the camera sees it.
enum class LightSide : std::uint8_t { as_it_is, back, side, front };
enum class Third : std::uint8_t { left, middle, right };

/// How a picture is composed of what `fit` names, see fitted().
struct Composition {
  LightSide light = LightSide::back;
  Third third =
      Third::right;       ///< of the picture's width, in which it stands; the light comes from the other side
  double height = 0.7;    ///< metres of the lens above the ground
  double headroom = 0.1;  ///< share of the picture's height that is free above
  double foreground = 0.22;  ///< the same below
};

struct Camera {
  Animated<Vec3> location{Vec3(0, 1.0f, 5)};
  Animated<Vec3> look_at{Vec3(0, 0.5f, 0)};
  Animated<double> angle{45.0};        ///< degrees, the width of the view
  std::optional<CameraMove> move;      ///< until the preset is read: it is keyframes then
  bool follow = false;                 ///< heights are relative to the ground below, not to y = 0
  std::vector<std::string> fit;        ///< names of organisms that the camera is moved to show completely
  std::string part;                    ///< of these: the name of an organ, one of which it comes close to
  double margin = 0.06;                ///< free margin at each edge, as a share of the picture's sides
  std::optional<Composition> compose;  ///< until the scene is built, as `fit`
  double exposure = 0;                 ///< stops above the metered exposure
  double highlights = 0;               ///< stops above white that keep their detail, see Tone
  double contrast = 1;                 ///< of the picture, see Tone, as the following are
  double saturation = 1, warmth = 0, vignette = 0;
  /// The f-number of a lens for film 36 mm wide; none: everything is sharp.
  std::optional<double> aperture;
  std::optional<Focus> focus;  ///< none: the point that it looks at
  double shutter = 0;  ///< share of a frame's time for which it is open, beginning at the frame's moment
  std::optional<int> shutter_samples;  ///< number of exposures per frame; none: by quality

  /// The organisms that decide where it stands; empty: it stands where it is put.
  std::vector<std::string> subjects() const {
    return fit.empty() && (compose || !part.empty()) ? std::vector<std::string>{std::string(kFitAll)} : fit;
  }
  /// Stops above the metered exposure, as POV-Ray draws it.
  double stops() const { return exposure - highlights; }
  /// Whether POV-Ray's picture still has to be tone mapped.
  bool toned() const {
    return highlights != 0 || contrast != 1 || saturation != 1 || warmth != 0 || vignette != 0;
  }
};

/// Number of exposures per frame of a film; 1: no motion blur, and always for a still and for raw frames,
/// whose motion is blurred when they are resolved.
inline int exposures(const Film& film, const Camera& camera) {
  constexpr int kExposures[] = {1, 4, 8};
  if (camera.shutter <= 0 || film.frames == 1 || film.raw) return 1;
  return camera.shutter_samples.value_or(kExposures[static_cast<std::size_t>(film.quality)]);
}

/// Time in seconds at which an exposure of a frame is taken, the first being 1: the middle of its share of
/// the open shutter time. For a single exposure it is the frame's own time.
inline double exposure_time(const Film& film, const Camera& camera, int frame, int exposure) {
  int count = exposures(film, camera);
  if (count == 1) return film.time(frame);
  return film.time(frame) + camera.shutter / film.fps * (exposure - 0.5) / count;
}

/// A view of the scene that somebody has named. The studio goes there; no film reads it.
struct NamedView {
  std::string name;
  Vec3 at{0, 1, 5}, to{0, 0.5f, 0};  ///< where one stands and looks
  double angle = 45;                 ///< degrees, the width of the view
};

/// Low dunes or a lawn, and the loose stones on it.
struct Floor {
  double relief = 0.14, scale = 3.2;  ///< metres, see Dunes
  int stones = 50;                    ///< loose stones
  double stone_size = 0.22;           ///< metres, of the largest of them
  double extent = 7;                  ///< metres round the origin in which they lie
};

/// Snow that lies, falls and comes down from boughs, and hoarfrost.
struct Snow {
  Animated<double> depth{0.0};    ///< metres, on open level ground
  Animated<double> frost{0.0};    ///< 0 none .. 1: how white hoarfrost makes what is thin
  double wind = 0;                ///< radians, where the wind comes from: 0 from +z, 90 degrees from +x
  double drift = 0.4;             ///< 0 calm .. 1: how much of it the wind carries to where there is lee
  Mask depth_map;                 ///< scales the depth over the land
  Animated<double> falling{0.0};  ///< mm/h of water, see motion/snowfall.h
  double shed = 2;                ///< boughs in a hundred that drop their snow in a minute of calm air

  /// The largest depth of a film, metres.
  double deepest() const;
  bool constant() const { return depth.constant() && frost.constant(); }
};

/// Rain: what falls in the film, and what has fallen.
struct Rain {
  Animated<double> rate{5.0};    ///< mm/h, see motion/rain.h
  Animated<double> fallen{4.0};  ///< mm, which make things wet and fill puddles
  Animated<double> mist{0.0};    ///< metres of its height above the ground
};

/// Droplets or dust in the air, which scatter the light of the sun once; what hides it casts shafts.
struct Air {
  Animated<double> visibility{400.0};  ///< metres below `level` through which a fiftieth of light passes
  double level = 0, height = 12;       ///< metres: y of that, and the rise above it in which it thins to 1/e
  double forward = 0.7;                ///< mean cosine of the angle by which light is turned aside
};

/// Everything but the organisms. Each setting has a block of parameters that is read only by it and by
/// settings based on it.
struct SceneSetup {
  SceneSetup();  ///< all blocks have their default values

  std::size_t setting = 0;  ///< index of a row of settings()
  Camera camera;
  std::vector<NamedView> views;
  std::optional<Wind> wind;  ///< over the land; none: what sways has waves of its own
  Floor floor;
  std::optional<FarLandShape> far;         ///< none: as the setting has it
  Snow snow;                               ///< read by settings under the open sky
  std::optional<Rain> rain;                ///< read by the same; none: it is dry
  std::optional<Air> air;                  ///< read by the same; none: clear but for the setting's haze
  std::optional<Animated<double>> year;    ///< the time of the year, see Seasons; none: it is always summer
  std::optional<Animated<double>> closed;  ///< share of the sky that a stand's crowns hide; none: as a wood's
  std::vector<std::any> blocks;            ///< one per setting

  /// The block of that type, which belongs to one of the settings.
  template <class Block>
  const Block& block() const {
    for (const std::any& held : blocks)
      if (const auto* found = std::any_cast<Block>(&held)) return *found;
    throw std::bad_any_cast();
  }
  template <class Block>
  Block& block() {
    return const_cast<Block&>(std::as_const(*this).template block<Block>());
  }
};

}  // namespace frond
