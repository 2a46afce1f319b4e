#include "settings/lawn.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "core/noise.h"

namespace frond {

namespace {

constexpr double kRadius = 150;            // metres, at least
constexpr double kEven = 600;              // metres to which what is near is as fine as without a far camera
constexpr double kBeyond = 50;             // metres from what stands farthest out to the edge, at least
constexpr double kMostBlades = 1'000'000;  // in all shapes of patches of one mixture
constexpr int kPatchBlades = 5;            // side of a patch of grass by the length of a blade
constexpr double kDraftBlades = 0.6;       // share of the blades in a draft
constexpr int kPatchStones = 10;           // side of a patch of stones by their size
constexpr double kNoEdge = 1e6;            // metres, where there is no such edge

/// The size of the squares that a piece of ground is covered with: halved up to `kHalvings` times where an
/// edge runs through.
constexpr int kHalvings = 2;
constexpr double kCover = 1.05;  // blades that stand for one

/// Lays squares of `side` metres, in sizes down to side / 2^kHalvings, wherever `edge` (metres to the edge,
/// below 0 inside) says so. Shapes are numbered: kTurfShapes of each of `mixtures`, and those of each size,
/// the largest first.
struct Paving {
  const Heights& heights;
  Seed seed;
  std::function<double(Vec2)> edge;
  std::vector<Patch>& into;
  int mixtures = 1;
  std::function<int(Vec2, const Seed&)> mixture_at = {};
  const Mask* map = nullptr;  // of what lies there; not given: all of it

  /// Whether the map differs over a square, or is grey there.
  bool is_mixed(Vec2 at, double side) const {
    if (!map || map->empty()) return false;
    double least = 1, most = 0;
    for (int i = 0; i < 25; ++i) {
      Vec2 aside(i % 5 - 2, i / 5 - 2);
      double here = map->on_land(at + aside * static_cast<float>(side / 4), kLawnSown);
      least = std::min(least, here), most = std::max(most, here);
    }
    return most > 0 && least < 1;
  }

  void lay(Vec2 at, double side, int halved, Seed own) {
    constexpr double kHalfDiagonal = 0.71;
    double away = edge(at), reach = kHalfDiagonal * side;
    if (away > reach) return;
    if ((away > -reach || is_mixed(at, side)) && halved < kHalvings) {
      float quarter = static_cast<float>(side / 4);
      for (std::uint64_t k = 0; k < 4; ++k)
        lay(at + Vec2(k % 2 ? quarter : -quarter, k / 2 ? quarter : -quarter), side / 2, halved + 1,
            own.child(2 + k));
      return;
    }
    if (away > 0 || (map && own.child(8).unit() >= map->on_land(at, kLawnSown))) return;
    double step = side / 2;
    Vec2 slope((heights(at.x + step, at.y) - heights(at.x - step, at.y)) / side,
               (heights(at.x, at.y + step) - heights(at.x, at.y - step)) / side);
    int shape = kTurfShapes * (mixtures * halved + (mixture_at ? mixture_at(at, own) : 0)) +
                static_cast<int>(own.child(0).bits() % kTurfShapes);
    double turn = kPi / 2 * static_cast<double>(own.child(1).bits() % 4);
    into.push_back({shape, Vec3(at.x, heights(at.x, at.y), at.y), turn, slope});
  }
};

constexpr int kMeadowRings = 110, kPlotRings = 150;  // a plot's ground has edges

/// The mesh of the lawn, `rings` of it where it is as small as can be.
GroundDisc disc_for(double radius, int rings) { return GroundDisc{kRadius, rings}.reaching(radius, kEven); }

/// The level of a pond, as far as its shore may reach.
Surface water_of(const PondShape& pond) {
  constexpr std::uint32_t kSides = 48;
  constexpr float kShore = 1.35f;  // the uneven shore against the ellipse
  Surface water;
  water.position.push_back(Vec3(pond.center.x, pond.level, pond.center.y));
  for (std::uint32_t i = 0; i < kSides; ++i) {
    double turn = 2 * kPi * i / kSides;
    water.position.push_back(water.position[0] +
                             kShore * Vec3(pond.size.x * std::cos(turn), 0, pond.size.y * std::sin(turn)));
    water.triangle.push_back({0, 1 + (i + 1) % kSides, 1 + i});
  }
  water.normal.assign(water.position.size(), Vec3(0, 1, 0));
  return water;
}

/// What grows in one of the mixtures: some kinds gather there, others keep away, and on the whole there is as
/// much of each as was asked for.
std::vector<Sward> mixture(std::vector<Sward> plants, int which, const Seed& seed) {
  constexpr double kGathered = 1.1;  // how unlike mixtures are, 0 alike: by eye
  for (std::size_t i = 0; i < plants.size(); ++i) {
    double all = 0, here = 0;
    for (int k = 0; k < kTurfMixtures; ++k) {
      double weight =
          std::exp(kGathered * seed.child("liking", i).child(static_cast<std::uint64_t>(k)).range(-1, 1));
      all += weight / kTurfMixtures;
      if (k == which) here = weight;
    }
    plants[i].share *= here / all;
  }
  return plants;
}

constexpr double kDryStones = 0.1;  // metres from stones and clods to the water

/// Patches of stones of about `stone` metres, in all sizes of squares.
std::vector<Surface> stone_patches(double stone, Seed seed) {
  constexpr double kOverlap = 1.06;  // side of what the stones cover by that of the square
  std::vector<Surface> shapes;
  for (int i = 0; i < kTurfShapes * (kHalvings + 1); ++i)
    shapes.push_back(gravel_surface(kOverlap * kPatchStones * stone / (1 << i / kTurfShapes), stone,
                                    seed.child("shape").child(static_cast<std::uint64_t>(i))));
  return shapes;
}

/// Covers what of the box of `points` and `margin` metres round them is inside of the paving's edge.
void pave(Paving paving, std::span<const Vec2> points, double margin, double side) {
  Vec2 low = points[0], high = low;
  for (Vec2 at : points) low = glm::min(low, at), high = glm::max(high, at);
  auto columns = static_cast<int>(std::ceil((high.x - low.x + 2 * margin) / side)),
       rows = static_cast<int>(std::ceil((high.y - low.y + 2 * margin) / side));
  for (int i = 0; i <= rows * columns; ++i) {
    Vec2 at(low.x - margin + (i % columns) * side, low.y - margin + (i / columns) * side);
    paving.lay(at, side, 0, paving.seed.child("patch", static_cast<std::uint64_t>(i)));
  }
}

/// The corners of the areas of a kind.
std::vector<Vec2> corners_of(const Plot& plot, GroundArea::Kind kind) {
  std::vector<Vec2> corners;
  for (const GroundArea& area : plot.areas())
    if (area.kind == kind) std::ranges::copy(area.box(), std::back_inserter(corners));
  return corners;
}

}  // namespace

Color grass_at(const Color& summer, double year) {
  // The share of straw by the time of the year: by eye.
  static const Curve kDry({{-0.1, 0.45},
                           {0.1, 0.7},
                           {0.22, 0.5},
                           {0.36, 0},
                           {0.5, 0.08},
                           {0.66, 0.34},
                           {0.78, 0.15},
                           {0.9, 0.45},
                           {1.1, 0.7}});
  constexpr Color kStraw{0.60f, 0.54f, 0.36f};
  return mixed(summer, kStraw, static_cast<float>(kDry(year - std::floor(year))));
}

Errors check_grass(const LawnShape& meadow) {
  Errors list;
  if (meadow.blade <= 0 || meadow.blades <= 0) return list;
  constexpr double kBlended = 1.12;  // side of what a patch covers, with its edges that blend into the next
  double side = kPatchBlades * meadow.blade, patches = kPi * std::pow(meadow.extent / side, 2);
  double blades = kTurfShapes * meadow.blades * std::pow(kBlended * side, 2);
  if (patches > kMostPatches)
    list.push_back(error_at("/meadow/blade",
                            "grass of {:g} m takes {:.2g} patches as far as {:g} m; expected {:g} at most, "
                            "by longer blades or a smaller extent",
                            meadow.blade, patches, meadow.extent, kMostPatches));
  if (blades > kMostBlades)
    list.push_back(error_at("/meadow/blades",
                            "patches of grass of {:g} m would hold {:.2g} blades; expected {:g} at most, by "
                            "fewer or shorter ones",
                            meadow.blade, blades, kMostBlades));
  return list;
}

void estimate_grass(const LawnShape& shape, const Film& film, GroundSizeEstimate& ground) {
  if (shape.blade <= 0 || shape.blades <= 0) return;
  constexpr int kBladeTriangles = 12;    // on the average: a blade has 5, flowers have more
  constexpr double kBlendedArea = 1.25;  // of what a patch covers, by that of its square
  double side = kPatchBlades * shape.blade, thin = film.quality == Quality::draft ? kDraftBlades : 1;
  ground.grass +=
      kBladeTriangles * kTurfMixtures * kTurfShapes * kBlendedArea * side * side * shape.blades * thin;
  ground.placed += kPi * std::pow(shape.extent / side + 0.5, 2);
}

Lawn::Lawn(const Floor& floor, const LawnShape& shape, Quality quality, double reach, Seed seed,
           const Garden* garden)
    : shape_(shape), quality_(quality), radius_(std::max(kRadius, reach + kBeyond)), seed_(seed) {
  Ground dunes{seed.child("ground"), floor.relief, floor.scale};
  if (!garden) {
    lay(ground_surface(dunes, Vec2(0), disc_for(radius_, kMeadowRings)));
    return;
  }
  garden_ = *garden;
  plot_ = Plot(garden_.pond, garden_.path, seed.child("plot"), garden_.areas);
  auto height = [&](Vec2 at) {
    constexpr double kHilly = 0.6;  // share of the radius; from there on the ground becomes level
    double lawn =
        ground_height(dunes, at.x, at.y) * (1 - smooth_step(kHilly, 1.0, glm::length(at) / radius_));
    return plot_.height(at, lawn);
  };
  lay(ground_surface(height, Vec2(0), disc_for(radius_, kPlotRings)));
  if (plot_.has_pond()) water_ = water_of(plot_.pond());
}

void Lawn::strew(TakenSpots&) {
  sow(seed_.child("turf"));
  lay_gravel(seed_.child("gravel"));
  lay_earth(seed_.child("earth"));
}

/// Covers the middle with patches of grass.
void Lawn::sow(Seed seed) {
  if (shape_.blade <= 0 || shape_.blades <= 0) return;
  // How far a patch blends into the next, by its side: whole ones, and smaller ones at edges.
  constexpr double kBlend = 0.4, kBlendAtEdges = 0.12;
  double thin = quality_ == Quality::draft ? kDraftBlades : 1.0, side = kPatchBlades * shape_.blade;
  bool whole = !plot_.has_pond() && !plot_.has_path() && !plot_.has_earth() && shape_.map.empty();
  int sizes = whole ? 1 : kHalvings + 1;
  for (int i = 0; i < kTurfShapes * kTurfMixtures * sizes; ++i) {
    int which = i / kTurfShapes % kTurfMixtures;
    int halved = i / (kTurfShapes * kTurfMixtures);
    double own_side = side / (1 << halved);
    TurfShape shape{.side = own_side,
                    .blend = (halved ? kBlendAtEdges : kBlend) * own_side,
                    .blade = shape_.blade,
                    .density = kCover * shape_.blades * thin,
                    .flowers = shape_.flowers / thin,
                    .sward = mixture(shape_.plants, which, seed.child("mixture")),
                    .thin = which == kTurfMixtures - 1};
    turf.push_back(turf_surface(shape, seed.child("shape").child(static_cast<std::uint64_t>(i))));
  }
  // Kinds gather in wide spots, with ragged rims: by eye.
  constexpr float kSpotPatches = 6;                     // patches from spot to spot
  constexpr double kRagged = 0.35, kMiddleSpots = 0.2;  // of values from -1 to 1
  Vec3 shift(seed.child("gathering").range(0, 1000), 0, 0);
  auto mixture_at = [&](Vec2 at, const Seed& own) {
    if (own.child(6).unit() < shape_.bare) return kTurfMixtures - 1;
    double spot = fractal_noise(Vec3(at.x, 0, at.y) / (kSpotPatches * static_cast<float>(side)) + shift, 2) +
                  own.child(7).range(-kRagged, kRagged);
    return spot < -kMiddleSpots ? 0 : spot < kMiddleSpots ? 1 : 2;
  };
  constexpr double kToWater = 0.02;  // metres
  auto edge = [&](Vec2 at) {
    double path = plot_.has_path() ? plot_.path_distance(at) : kNoEdge;
    double bed = plot_.has_earth() ? plot_.earth_distance(at) : kNoEdge;
    return std::max({-path, -bed, kToWater - plot_.pond_distance(at)});
  };
  Paving paving{heights(), seed, edge, turf_patches, kTurfMixtures, mixture_at, &shape_.map};
  int reach = static_cast<int>(std::ceil(shape_.extent / side));
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      double x = column * side, z = row * side;
      if (x * x + z * z > shape_.extent * shape_.extent) continue;
      Seed own = seed.child("patch").child(
          static_cast<std::uint64_t>((row + reach) * (2 * reach + 1) + column + reach));
      paving.lay(Vec2(x, z), side, 0, own);
    }
  }
}

/// Covers the path with gravel.
void Lawn::lay_gravel(Seed seed) {
  if (!plot_.has_path()) return;
  gravel = stone_patches(garden_.gravel, seed);
  std::vector<Vec2> points = corners_of(plot_, GroundArea::Kind::gravel);
  points.insert(points.end(), plot_.path().begin(), plot_.path().end());
  // A path that leads across the pond, over a bridge, ends at the shores.
  auto edge = [&](Vec2 at) {
    return std::max(plot_.path_distance(at), kDryStones - plot_.pond_distance(at));
  };
  pave({heights(), seed, edge, gravel_patches}, points, garden_.path.width, kPatchStones * garden_.gravel);
}

/// Covers the beds with clods, where no path leads across.
void Lawn::lay_earth(Seed seed) {
  if (!plot_.has_earth()) return;
  earth = stone_patches(garden_.clods, seed);
  auto edge = [&](Vec2 at) {
    return std::max(
        {plot_.earth_distance(at), -plot_.path_distance(at), kDryStones - plot_.pond_distance(at)});
  };
  pave({heights(), seed, edge, earth_patches}, corners_of(plot_, GroundArea::Kind::earth), garden_.clods,
       kPatchStones * garden_.clods);
}

Mask Lawn::map() const {
  Mask map = shape_.map;
  auto half = static_cast<float>(kLawnSown / 2);
  if (map.area.empty()) map.area = {Vec2(-half), Vec2(half)};
  return map;
}

float Lawn::seat(Vec2 at, double, Seed) {
  // Over a pond things stand on the water.
  return under_water(at) ? std::max(static_cast<float>(plot_.pond().level), height(at)) : height(at);
}

Land Lawn::land(std::vector<Spot> taken) const {
  Land land = sloping_land(kLawnSown, std::move(taken));
  if (plot_.has_path() || plot_.has_pond()) land.path = clear_of(plot_);
  return land;
}

std::vector<ScatteredInstances> Lawn::strewn() const {
  if (water_.triangle.empty()) return {};
  return {{&water_, Color{0.20f, 0.29f, 0.27f}, {{}}, true}};
}

std::vector<Patches> Lawn::patches() const {
  std::vector<Patches> list;
  for (Surface Turf::*part : {&Turf::blades, &Turf::leaves, &Turf::flowers}) {
    list.push_back({{}, &turf_patches});
    for (const Turf& one : turf) list.back().shapes.push_back(&(one.*part));
  }
  list.push_back({{}, &gravel_patches, garden_.gravel_color});
  for (const Surface& one : gravel) list.back().shapes.push_back(&one);
  if (earth.empty()) return list;
  list.push_back({{}, &earth_patches, garden_.earth_color});
  for (const Surface& one : earth) list.back().shapes.push_back(&one);
  return list;
}

LowCover Lawn::low_cover() const {
  constexpr double kWidth = 0.004;  // metres, of a blade
  return {shape_.blade, shape_.blades * shape_.blade * kWidth};
}

std::size_t Lawn::bytes() const {
  std::size_t bytes = Grounds::bytes() + bytes_of(turf) + bytes_of(turf_patches) + bytes_of(gravel) +
                      bytes_of(gravel_patches) + bytes_of(earth) + bytes_of(earth_patches) + bytes_of(water_);
  for (const Turf& one : turf) bytes += bytes_of(one.blades) + bytes_of(one.leaves) + bytes_of(one.flowers);
  for (const Surface& stones : gravel) bytes += bytes_of(stones);
  for (const Surface& shape : earth) bytes += bytes_of(shape);
  return bytes;
}

std::vector<Specimen> Lawn::furnishings() const {
  Solids lilies = water_lilies(plot_, garden_.lilies, seed_.child("lilies"));
  if (lilies.size() == 0) return {};
  Specimen pads;
  pads.name = "water lilies";
  pads.model.solids = std::move(lilies);
  return {std::move(pads)};
}

}  // namespace frond
