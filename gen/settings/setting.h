#pragma once

#include <any>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/seed.h"
#include "land/ground.h"
#include "land/plot.h"
#include "land/scatter.h"
#include "land/sow.h"
#include "model/bytes.h"
#include "preset/reader.h"
#include "preset/schema.h"
#include "settings/sky.h"
#include "settings/stage.h"
#include "world/specimen.h"

// Settings
// ========
// A setting is a row in settings/settings.h and a pair of files: settings/x.cpp says what it lays and how
// things stand in it (its Grounds), emit/setting_x.cpp how it is written. Both leave nothing unanswered, or
// do not compile.

namespace frond {

/// The box of something that stands in a scene.
struct Occupied {
  std::string name;
  Vec3 low{0}, high{0};
};

/// What a setting offers to what is put there, metres.
struct Extent {
  double reach = 30;   ///< from the middle within which things may be put
  double sown = 0;     ///< side of the square that is sown
  double relief = 0;   ///< by how much the land rises
  bool rocks = false;  ///< whether corals and plants are given rocks to stand on
};

/// What the ground of a setting takes, within about a factor of two.
struct GroundSizeEstimate {
  double triangles = 0;
  double grass = 0;   ///< triangles that share few corners
  double placed = 0;  ///< placements of stones and patches
  double pixels = 0;  ///< of the pictures that each frame has of its own
};

/// The light of a setting and what its air does to colours: the one table that POV-Ray's text, the soft
/// light, the quick look and the studio's page take them from. Light is linear, as a white matt surface shows
/// it; colours are sRGB, as in presets.
struct Daylight {
  Vec3 sun{0, 1, 0};                  ///< toward the main light, of length 1
  Vec3 sunlight{1};                   ///< what it gives to what faces it
  float brightest = 1;                ///< what it gives there at its brightest, by which a camera is set
  bool soft = false;                  ///< whether light comes from all around, too, and not from lamps alone
  Vec3 above{0}, aside{0}, below{0};  ///< that light: of the sky, and of what is lower than all that stands
  Vec3 thrown_back{0.2f};             ///< share of light that the land throws back
  Color zenith = {}, horizon = {}, fog = {}, ground = {};  ///< as they are seen
  double fade = 0;  ///< metres in which two thirds of a colour are lost to that of the fog; 0: none
};

/// Bodies of one shape that lie about, for a quick look.
struct Strewn {
  const Surface* shape = nullptr;  ///< of the grounds, and lives as long
  Color color;
  struct At {
    Vec3 place{0};
    Quat turn{1, 0, 0, 0};
    Vec3 size{1};
  };
  std::vector<At> at;
};

/// Grass or litter all over the ground.
struct LowCover {
  double height = 0;  ///< metres that it stands high; 0: none
  double area = 0;    ///< m2 of it on a square metre
};

/// What a setting lays, and how things stand on it. Metres.
class Grounds {
 public:
  virtual ~Grounds() = default;

  /// The floor, empty where there is none to be drawn, and how high it lies.
  const Surface& floor() const { return floor_; }
  const Heights& heights() const { return heights_; }
  float height(Vec2 at) const { return static_cast<float>(heights_(at.x, at.y)); }

  /// Lays what lies about, clear of what is taken, and takes its own places.
  virtual void strew(TakenSpots& taken) = 0;
  /// Lays what is so fine that it lies only where the camera comes near, when all has grown.
  virtual void lay_litter(const Camera&) {}
  /// How high something stands there; lays the rock that is under it, `rock` metres wide, 0 none.
  virtual float seat(Vec2 at, double rock, Seed seed) = 0;
  /// The land as sowing asks for it.
  virtual Land land(std::vector<Spot> taken) const = 0;
  /// What belongs to the setting itself and grows or floats.
  virtual std::vector<Specimen> furnishings() const = 0;
  /// What lies about and is large enough to matter to a quick look.
  virtual std::vector<Strewn> strewn() const { return {}; }
  virtual LowCover low_cover() const { return {}; }
  /// Of memory, about.
  virtual std::size_t bytes() const { return bytes_of(floor_) + heights_.bytes(); }
  /// What the user should know of how all that stands there fits in. `things` makes the list of them.
  virtual std::vector<std::string> remarks(const std::function<std::vector<Occupied>()>& things,
                                           const Camera& camera, double film_end) const = 0;

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

/// The light of day under a sky, over a ground that is seen in that colour; `matt`: its linear colour as far
/// as it throws light back.
Daylight daylight(const Sky& sky, const Color& ground, Vec3 matt, double haze);

/// A linear colour as sRGB, as far as that goes.
Color seen_color(Vec3 light);

/// Up from the ground, of length 1.
Vec3 ground_normal(const Heights& heights, Vec2 at);

/// Metres to the edge of a plot's path; in its pond far below 0, for there nothing comes up, however near to
/// a path it may.
std::function<double(Vec2)> clear_of(const Plot& plot);

/// What a setting answers for its parameters.
struct SettingAnswers {
  /// The properties below the scene that it reads: "/meadow" a whole block, "/meadow/haze" one of it.
  std::vector<std::string_view> reads;
  Extent (*extent)(const Stage&);
  /// Faults that only show when all is read; each `where` is a JSON pointer below the scene.
  Errors (*check)(const Stage&, const Film&);
  GroundSizeEstimate (*estimate_size)(const Stage&, const Film&);
  /// Lays the ground so that it reaches past `reach` metres from the middle.
  std::unique_ptr<Grounds> (*lay)(const Stage&, const Film&, double reach, Seed);
  Daylight (*daylight)(const Stage&);
};

/// A row of the table of settings.
struct SettingRow {
  std::string_view name, doc;
  std::string_view block, block_doc;  ///< the property of its parameters
  std::any initial;                   ///< the parameters as they are where a preset does not say
  bool (*read)(Reader&, const Value&, std::any&);
  std::string (*schema)();
  SettingAnswers answers;
};

/// The row of a setting with the described struct of its parameters; nothing may be left out.
template <class Block>
SettingRow setting_row(std::string_view name, std::string_view doc, std::string_view block,
                       std::string_view block_doc, std::vector<std::string_view> reads,
                       decltype(SettingAnswers::extent) extent, decltype(SettingAnswers::check) check,
                       decltype(SettingAnswers::estimate_size) estimate_size,
                       decltype(SettingAnswers::lay) lay, decltype(SettingAnswers::daylight) daylight) {
  return {name,
          doc,
          block,
          block_doc,
          Block{},
          [](Reader& reader, const Value& value, std::any& held) {
            Block read{};
            bool fine = reader.object_at(value, read);
            held = std::move(read);
            return fine;
          },
          [] {
            SchemaWriter writer;
            Block sample{};
            describe(writer, sample);
            return serialize(writer.object_schema());
          },
          {std::move(reads), extent, check, estimate_size, lay, daylight}};
}

}  // namespace frond
