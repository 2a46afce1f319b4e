#include "settings/forest.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/curve.h"
#include "core/linear.h"
#include "images/describe_mask.h"
#include "land/litter.h"
#include "settings/describe_plot.h"
#include "settings/settings.h"

namespace frond {

void describe(Properties& v, StreamShape& s) {
  v.vector("from", s.from, metres(-2000, 2000), "Place x, z where the stream begins");
  v.number("width", s.width, metres(0, 12), "Width of the stream's water on average; 0 is no stream");
  v.number("depth", s.depth, metres(0.05, 2), "Depth of the stream in its middle");
  v.integer("leaves", s.leaves, {.min = 0, .max = 2000}, "How many fallen leaves drift on the stream");
}

void describe(Properties& v, TerrainShape& t) {
  v.number("size", t.size, metres(2, 4000), "Side of the square of land that is sown");
  v.number("hills", t.hills, metres(0, 500), "Height from valley to hilltop");
  v.number("hill_size", t.hill_size, metres(1, 5000), "Distance from one hill to the next");
  v.number("rough", t.rough, kShare, "How broken the land is: 0 rolling, 1 broken");
  v.number("erosion", t.erosion, kShare,
           "How far running water has worn the hills: 1 spurs and gullies of high mountains, with bare rock "
           "where it is steep; 0 is woodland all over");
  v.object("path", t.path, "A path through the wood that is kept clear");
  v.object("stream", t.stream, "A stream that runs down the land and leaves the sown square");
}

void describe(Properties& v, Forest& f) {
  v.animated("hour", f.hour, kHours,
             "Hour of the day, which places the sun: 6 dawn, 12 noon, 19 dusk; with keyframes a day goes by");
  describe_place(v, f.when);
  v.number("mist", f.mist, metres(0, 200), "Height to which mist fills the valleys; 0 is none");
  v.number("brighten", f.brighten, {.min = -4, .max = 6},
           "Stops by which the picture is brighter than of open land, as little light falls below crowns");
  v.object("terrain", f.terrain, "The shape of the land");
  v.color("litter", f.litter, "Colour of fallen leaves and earth");
  v.color("green", f.green, "Colour of moss");
  v.color("air", f.air, "Colour that light takes in the crowns: that of the air between the trunks");
  v.number("moss", f.moss, kShare, "Share of the ground that is green");
  v.object("moss_map", f.moss_map, "A picture that scales moss over the land; a bare file name will do");
}

namespace {

constexpr double kLeafLength = 0.09;  // metres
constexpr double kNoLitter = 0.3;     // metres from the water
constexpr double kNoPath = 1e6;       // metres, where there is none
constexpr std::array<Color, 5> kLeafColors{{{0.72f, 0.55f, 0.16f},
                                            {0.60f, 0.34f, 0.13f},
                                            {0.45f, 0.27f, 0.13f},
                                            {0.66f, 0.44f, 0.15f},
                                            {0.38f, 0.25f, 0.15f}}};

constexpr double kLongestCameraPath = 10'000;  // metres that a camera goes
constexpr double kLeastReach = 30;             // metres from the middle, on however small a land
constexpr double kLeastPathReach = 1200;       // metres from the middle to points of a path, likewise

/// Leaves and moss lie wherever the camera comes near.
void check_litter(Errors& list, const SceneSetup& setup, const Film& film) {
  double length = 0;
  Vec3 last = setup.camera.location.at(film.time(1));
  for (int frame = 2; frame <= film.frames; ++frame) {
    Vec3 at = setup.camera.location.at(film.time(frame));
    length += glm::distance(last, at);
    last = at;
  }
  if (length > kLongestCameraPath)
    list.push_back(error_at("/camera/location",
                            "the camera goes {:.3g} m through the forest; expected {:g} m at most", length,
                            kLongestCameraPath));
}

/// Share of the light that crowns take at a time of the year, against summer.
double canopy(double year) {
  constexpr double kBareCrown = 0.15;  // branches alone
  return std::lerp(kBareCrown, 1.0, leaf_share(year));
}

}  // namespace

ForestGround::ForestGround(const Forest& forest, const Film& film, Seed seed, const AltitudeLines& lines)
    : mountain(forest.terrain.erosion > 0),
      lines_(lines),
      size_(forest.terrain.size),
      moss_(forest.moss),
      moss_map_(forest.moss_map),
      film_(film),
      seed_(seed.child("floor")),
      terrain_(std::make_shared<const Terrain>(forest.terrain, seed.child("terrain"))),
      plot_(terrain_->plot()) {
  Heights heights([terrain = terrain_](double x, double z) { return terrain->height(x, z); });
  lay(terrain_->surface(), std::move(heights));
  auto half = static_cast<float>(size_ / 2);
  for (const Vec3& p : floor().position)
    if (std::max(std::abs(p.x), std::abs(p.z)) <= half) valley = std::min(valley, p.y);
  if (mountain)
    mark_mountain(floor_, floor_land(), lines_, plot_.path(), forest.terrain.path.width);
  else
    mark_floor(floor_, floor_land(), moss_, seed_);
  if (!stream().flows()) return;
  water_ = stream().water(), bed_ = stream().bed();
  for (std::uint64_t k = 0; k < kLeafColors.size(); ++k)
    leaves_.push_back(leaf_surface(kLeafLength, seed_.child("drifting", k)));
}

ForestLand ForestGround::floor_land() const {
  return {[this](Vec2 at) { return heights()(at.x, at.y); },
          [this](Vec2 at) { return plot_.has_path() ? plot_.path_distance(at) : kNoPath; },
          [this](Vec2 at) { return moss_map_.on_land(at, size_); }};
}

void ForestGround::lay_litter(const Camera& camera) {
  cover = strew_floor(film_, camera, floor_land(), moss_, seed_);
  constexpr double kLeastHeath = 0.5;  // share of heath that is no wood any more
  auto bare = [&](const Patch& p) {
    Vec2 at(p.at.x, p.at.z);
    if (mountain && mountain_cover_on(floor_land(), lines_, at) > kLeastHeath * mountain_cover::kHeath)
      return true;
    return stream().distance(at) < kNoLitter;
  };
  for (auto* patches : {&cover.litter_patches, &cover.moss_patches}) std::erase_if(*patches, bare);
}

std::size_t ForestGround::bytes() const {
  std::size_t bytes = Grounds::bytes() + bytes_of(water_) + bytes_of(bed_) + bytes_of(cover.litter_patches) +
                      bytes_of(cover.moss_patches);
  for (const std::vector<Surface>* shapes : {&cover.litter, &cover.moss}) {
    bytes += bytes_of(*shapes);
    for (const Surface& shape : *shapes) bytes += bytes_of(shape);
  }
  return bytes;
}

std::vector<Patches> ForestGround::patches() const {
  std::vector<Patches> list{{{}, &cover.litter_patches}, {{}, &cover.moss_patches}};
  for (const Surface& shape : cover.litter) list[0].shapes.push_back(&shape);
  for (const Surface& shape : cover.moss) list[1].shapes.push_back(&shape);
  return list;
}

std::vector<Specimen> ForestGround::furnishings() const {
  Specimen stones;
  stones.name = "stones of the stream";
  stones.model.solids = stream().stones();
  return stones.model.solids.size() == 0 ? std::vector<Specimen>{} : std::vector{std::move(stones)};
}

std::vector<ScatteredInstances> ForestGround::strewn() const {
  if (!stream().flows()) return {};
  return {{&bed_, {0.36f, 0.31f, 0.25f}, {{}}}, {&water_, {0.30f, 0.36f, 0.34f}, {{}}, true}};
}

std::vector<ScatteredInstances> ForestGround::adrift(double time, double loop) const {
  if (!stream().flows()) return {};
  std::vector<ScatteredInstances> kinds;
  for (std::size_t k = 0; k < leaves_.size(); ++k) kinds.push_back({&leaves_[k], kLeafColors[k], {}});
  for (const Afloat& leaf : stream().leaves(time, loop))
    kinds[static_cast<std::size_t>(leaf.kind) % kinds.size()].at.push_back(
        {leaf.at, glm::angleAxis(leaf.turn, Vec3(0, 1, 0)), Vec3(leaf.size)});
  return kinds;
}

GroundEdge ForestGround::edge() const {
  auto beyond = [terrain = terrain_](Vec2 at) { return terrain->height(at.x, at.y); };
  return {terrain_->reach(), true, false, beyond};
}

Land ForestGround::land(std::vector<Spot> taken) const {
  Land land = sloping_land(size_, std::move(taken));
  if (plot_.has_path()) land.path = clear_of(plot_);
  if (stream().flows())
    land.path = [dry = land.path, terrain = terrain_](Vec2 at) {
      double wet = terrain->stream().distance(at);
      return dry ? std::min(dry(at), wet) : wet;
    };
  return land;
}

SettingRow forest_setting() {
  return setting_row<Forest>(
      "forest", "wooded hills at any hour of the day", "forest",
      "Hour and land, for forest; clouds and haze are the meadow's",
      {"/forest", "/meadow/haze", "/meadow/clouds", "/meadow/turbidity", "/meadow/moon", "/meadow/zenith",
       "/meadow/horizon", "/snow", "/rain", "/air", "/far", "/year"},
      [](const SceneSetup& setup) {
        const TerrainShape& land = setup.block<Forest>().terrain;
        return Extent{.reach = std::max(kLeastReach, land.size), .sown = land.size, .relief = land.hills};
      },
      [](const SceneSetup& setup, const Film& film) {
        const TerrainShape& land = setup.block<Forest>().terrain;
        Errors errors;
        check_path(errors, land.path, "/forest/terrain/path/points",
                   std::max(kLeastPathReach, 2 * land.size));
        check_litter(errors, setup, film);
        return errors;
      },
      [](const SceneSetup& setup, const Film& film) {
        // Litter lies wherever the camera passes by.
        constexpr int kMostLooks = 200;
        constexpr double kFloor = 39'200, kLitter = 13'700;      // triangles
        constexpr double kPatches = 3000, kPatchesAMetre = 170;  // of litter, on the camera's way
        double length = 0;
        for (int frame = 2, step = std::max(1, film.frames / kMostLooks); frame <= film.frames;
             frame += step) {
          Vec3 moved = setup.camera.location.at(film.time(frame)) -
                       setup.camera.location.at(film.time(std::max(1, frame - step)));
          length += std::hypot(moved.x, moved.z);
        }
        return GroundSizeEstimate{kFloor, kLitter, kPatches + kPatchesAMetre * length};
      },
      [](const SceneSetup& setup, const Film& film, double, Seed seed) -> std::unique_ptr<Grounds> {
        AltitudeLines lines = setup.far.value_or(FarLandShape{}).lines();
        lines.shaded = shaded_side(setup);
        return std::make_unique<ForestGround>(setup.block<Forest>(), film, seed, lines);
      },
      [](const SceneSetup& setup) {
        const auto& forest = setup.block<Forest>();
        // Litter lies on moss, too.
        constexpr double kMossSeen = 0.6;  // share
        auto green = static_cast<float>(kMossSeen * forest.moss);
        Sky sky = forest_sky(setup);
        Daylight light =
            daylight(sky, forest.litter, glm::mix(linear(forest.litter), linear(forest.green), green),
                     setup.block<Meadow>().haze);
        // Below crowns air is darker than in the open: by eye.
        light.fog = 0.74f * (0.92f * sky.horizon * linear(forest.air) + 0.07f * sky.zenith);
        light.mist = 0.8f * sky.horizon + 0.06f * sky.zenith;
        return light;
      },
      [](SceneSetup& setup) { return &setup.block<Forest>().hour; });
}

double leaf_share(double year) {
  // Leaves unfold from mid-April to mid-May and fall in October and November.
  static const Curve kLeaves({{0.29, 0}, {0.38, 1}, {0.76, 1}, {0.9, 0}});
  return kLeaves(year - std::floor(year));
}

Sky forest_sky(const SceneSetup& setup) {
  const auto& forest = setup.block<Forest>();
  Moment when = forest.when;
  when.hour = forest.hour.at(0);
  double brighten = forest.brighten * (setup.year ? canopy(setup.year->at(0)) : 1) *
                    (setup.closed ? setup.closed->at(0) : 1);
  return sky_over(setup, sun_at(when), setup.camera.stops() + brighten);
}

}  // namespace frond
