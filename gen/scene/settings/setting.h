#pragma once

#include <any>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/seed.h"
#include "land/far_land.h"
#include "land/ground.h"
#include "land/plot.h"
#include "land/scatter.h"
#include "land/sow.h"
#include "model/bytes.h"
#include "preset/keys.h"
#include "settings/scene_setup.h"
#include "settings/sky.h"
#include "world/specimen.h"

// Settings
// ========
// A setting is a row in settings/settings.h and two files: settings/x.cpp defines its ground and how things
// stand on it (its Grounds), emit/setting_x.cpp how it is written. A missing function does not compile.

namespace frond {

/// The bounding box of an object in a scene.
struct Occupied {
  std::string name;
  Vec3 low{0}, high{0};
};

/// The dimensions of a setting, metres.
struct Extent {
  double reach = 30;   ///< largest distance from the middle at which things may be placed
  double sown = 0;     ///< side of the sown square
  double relief = 0;   ///< height range of the land
  bool rocks = false;  ///< whether corals and plants are given rocks to stand on
};

/// Predicted size of a setting's ground, within about a factor of two.
struct GroundSizeEstimate {
  double triangles = 0;
  double grass = 0;   ///< triangles that share few vertices
  double placed = 0;  ///< number of placed stones and patches
  double pixels = 0;  ///< of the pictures made for each frame
};

/// A lamp that hangs in a setting and goes with the camera. Lengths are distances from the camera to what it
/// looks at, at least a metre.
struct Lamp {
  enum class Shadows { none, coarse, fine };
  Vec3 from{0, 1, 0};  ///< where it hangs, seen from what the camera looks at
  Vec3 light{1};       ///< brightness of a surface that faces it
  double width = 0;    ///< of its disc; 0: a point
  Shadows shadows = Shadows::none;
};

/// What stands behind everything from one height on, until the next: between them it goes over.
struct BackdropStop {
  double height = 0;  ///< sine of the angle above the horizon
  Vec3 light{0};
};

/// What a view that traces no light takes for all that the main light does not give: from above, from the
/// side and from below, and more on what faces the viewer.
struct FillLight {
  Vec3 above{0}, aside{0}, below{0}, eye{0};
};

/// The light of a setting and how its air changes colours: the common source for POV-Ray's text, the soft
/// light, the quick look and the studio's page. Light is linear, as the brightness of a white matt surface;
/// colours are sRGB, as in presets.
struct Daylight {
  Vec3 sun{0, 1, 0};    ///< toward the main light, of length 1
  Vec3 sunlight{1};     ///< brightness that it gives to a surface facing it
  float brightest = 1;  ///< the maximum of that, used to set the exposure
  bool soft = false;    ///< whether there is diffuse light from all around, besides lamps
  Vec3 above{0}, aside{0},
      below{0};            ///< the diffuse light: of the sky above and at the horizon, and from below it
  Vec3 thrown_back{0.2f};  ///< share of light reflected by the land
  std::vector<Lamp> lamps = {};                  ///< where there are any, the first is the main light
  Color zenith = {}, horizon = {}, ground = {};  ///< as the camera sees them
  std::vector<BackdropStop> backdrop{{}};  ///< from the horizon up; at least one, at most kBackdropStops
  Vec3 fog{0};                             ///< light of the air, to which far things fade
  double fade = 0;                         ///< metres in which two thirds of a colour are lost to it; 0: none
  Vec3 mist{0};                            ///< light of the mist in valleys, where there is any
  FillLight fill = {};
};

inline constexpr std::size_t kBackdropStops = 6;

/// The light of the backdrop in a direction of length 1 that rises by `height`.
Vec3 backdrop_at(const Daylight& light, float height);

/// Copies of one shape on the ground, for a quick look.
struct ScatteredInstances {
  const Surface* shape = nullptr;  ///< owned by the grounds
  Color color;
  struct At {
    Vec3 place{0};
    Quat turn{1, 0, 0, 0};
    Vec3 size{1};
  };
  std::vector<At> at;
  bool water = false;  ///< a surface that reflects and lets light through
};

/// A placed patch of grass, gravel or litter.
struct Patch {
  int shape = 0;  ///< index of the patch's surface
  Vec3 at{0};
  double turn = 0;  ///< radians about the vertical
  Vec2 slope{0};    ///< of the ground, along x and z

  /// Its axes: turned, then sheared along the slope.
  glm::mat3 axes() const;
};

/// Patches of one kind, with their surfaces; owned by the grounds.
struct Patches {
  std::vector<const Surface*> shapes;
  const std::vector<Patch>* at = nullptr;
  std::optional<Color> color =
      {};  ///< of stones and clods, for the studio's view; none: it shows none of them
};

/// Grass or litter that covers the ground.
struct LowCover {
  double height = 0;  ///< metres, its height; 0: none
  double area = 0;    ///< m2 of it per square metre
};

/// The ground of a setting, and how things stand on it. Metres.
class Grounds {
 public:
  virtual ~Grounds() = default;

  /// The floor, empty if none is drawn, and its height.
  const Surface& floor() const { return floor_; }
  const Heights& heights() const { return heights_; }
  float height(Vec2 at) const { return static_cast<float>(heights_(at.x, at.y)); }

  /// Places loose objects outside the taken spots, and adds their own spots.
  virtual void strew(TakenSpots& taken) = 0;
  /// Places fine litter, only where the camera comes near; called when everything has grown.
  virtual void lay_litter(const Camera&) {}
  /// The height at which an object stands; places a rock below it, `rock` metres wide, 0 none.
  virtual float seat(Vec2 at, double rock, Seed seed) = 0;
  /// The land for sowing.
  virtual Land land(std::vector<Spot> taken) const = 0;
  /// Whether water lies there that has nothing to do with rain.
  virtual bool under_water(Vec2) const { return false; }
  /// Growing or floating parts that belong to the setting itself.
  virtual std::vector<Specimen> furnishings() const { return {}; }
  /// Loose objects large enough to show in a quick look.
  virtual std::vector<ScatteredInstances> strewn() const { return {}; }
  /// What drifts over it at a time, seconds; in a film that loops after `loop` seconds, 0 it does not, the
  /// same after that.
  virtual std::vector<ScatteredInstances> adrift(double /*time*/, double /*loop*/) const { return {}; }
  /// What covers the ground, as meshes.
  virtual std::vector<Patches> patches() const { return {}; }
  virtual LowCover low_cover() const { return {}; }
  /// Where the far land begins; by default there is none.
  virtual GroundEdge edge() const { return {}; }
  /// Approximate memory, bytes.
  virtual std::size_t bytes() const { return bytes_of(floor_) + heights_.bytes(); }
  /// Messages for the user about how the objects fit into the setting. `things` returns the list of objects.
  virtual std::vector<std::string> remarks(const std::function<std::vector<Occupied>()>& /*things*/,
                                           const Camera& /*camera*/, double /*film_end*/) const {
    return {};
  }

 protected:
  void lay(Surface floor) {
    heights_ = Heights(floor);
    floor_ = std::move(floor);
  }
  void lay(Surface floor, Heights heights) {
    floor_ = std::move(floor);
    heights_ = std::move(heights);
  }
  /// Land of `size` metres with the altitudes and slopes of the floor.
  Land sloping_land(double size, std::vector<Spot> taken) const;

  Surface floor_;

 private:
  Heights heights_;
};

/// The ground of a setting whose type is known; std::bad_cast, our own mistake, where it is another.
template <class Known>
const Known& ground_as(const Grounds& ground) {
  return dynamic_cast<const Known&>(ground);
}

/// The daylight of a sky, over a ground of that visible colour; `matt`: the linear colour that it reflects;
/// `haze`: metres in which two thirds of a colour are lost in clear air.
Daylight daylight(const Sky& sky, const Color& ground, Vec3 matt, double haze);

/// A linear colour as sRGB, clamped.
Color seen_color(Vec3 light);

/// The upward normal of the ground, of length 1.
Vec3 ground_normal(const Heights& heights, Vec2 at);

/// Metres to the edge of a plot's path; far below 0 in its pond, where nothing grows, even beside a path.
std::function<double(Vec2)> clear_of(const Plot& plot);

/// The functions of a setting for its parameters.
struct SettingAnswers {
  /// The properties of the scene that it reads: "/meadow" a whole block, "/meadow/haze" one of it.
  std::vector<std::string_view> reads;
  Extent (*extent)(const SceneSetup&);
  /// Errors that show only after reading everything; each `where` is a JSON pointer below the scene.
  Errors (*find_faults)(const SceneSetup&, const Film&);
  GroundSizeEstimate (*estimate_size)(const SceneSetup&, const Film&);
  /// Makes the ground, larger than `reach` metres from the middle.
  std::unique_ptr<Grounds> (*lay)(const SceneSetup&, const Film&, double reach, Seed);
  Daylight (*daylight)(const SceneSetup&);
  Animated<double>* (*hour)(SceneSetup&);  ///< of the day; null where it says nothing
};

/// A row of the table of settings.
struct SettingRow {
  std::string_view name, doc;
  std::string_view block, block_doc;  ///< the property of its parameters
  std::any initial;                   ///< the default parameters
  bool (*read)(Reader&, const Value&, std::any&);
  std::string (*schema)();
  Keys (*keys)(const std::any&);
  SettingAnswers answers;
};

/// The row of a setting with its described parameter struct; no function may be omitted.
template <class Block>
SettingRow setting_row(std::string_view name, std::string_view doc, std::string_view block,
                       std::string_view block_doc, std::vector<std::string_view> reads,
                       decltype(SettingAnswers::extent) extent,
                       decltype(SettingAnswers::find_faults) find_faults,
                       decltype(SettingAnswers::estimate_size) estimate_size,
                       decltype(SettingAnswers::lay) lay, decltype(SettingAnswers::daylight) daylight,
                       decltype(SettingAnswers::hour) hour = nullptr) {
  return {name,
          doc,
          block,
          block_doc,
          Block{},
          [](Reader& reader, const Value& value, std::any& held) {
            Block read{};
            bool fine = read_object(reader, value, read);
            held = std::move(read);
            return fine;
          },
          [] {
            Block sample{};
            return schema_json(sample);
          },
          [](const std::any& held) { return keys_of(std::any_cast<Block>(held)); },
          {std::move(reads), extent, find_faults, estimate_size, lay, daylight, hour}};
}

}  // namespace frond
