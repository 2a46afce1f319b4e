#include "land/snow.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/noise.h"
#include "core/parallel.h"
#include "land/from_above.h"
#include "land/ground.h"

namespace frond {

namespace {

constexpr float kSink = 0.004f;  // metres below what it lies on, at which snow of no depth is
constexpr float kReach = 8;      // metres to the sides from which something shelters a place

/// A direction that snow falls from, and how much of it.
struct SnowFall {
  Vec3 from;
  float weight;
};

/// Most snow falls steeply: the weights by the tilt, degrees, are by eye.
std::vector<SnowFall> falls() {
  constexpr int kAround = 8;
  std::vector<SnowFall> list{{Vec3(0, 1, 0), 1.5f}};
  for (auto [tilt, weight] : {std::pair(25.0, 1.0f), std::pair(45.0, 0.7f), std::pair(60.0, 0.35f)})
    for (int i = 0; i < kAround; ++i) {
      double turn = 2 * kPi * i / kAround;
      list.push_back({Vec3(std::sin(radians(tilt)) * std::cos(turn), std::cos(radians(tilt)),
                           std::sin(radians(tilt)) * std::sin(turn)),
                      weight});
    }
  return list;
}

/// Values on a square about a point, between which one goes over.
struct SquareField {
  Vec2 low{0};
  float cell = 0.1f;
  int side = 0;
  std::vector<float> value;

  Vec2 at(int column, int row) const { return low + cell * Vec2(column, row); }
  float& of(int column, int row) { return value[static_cast<std::size_t>(row * side + column)]; }
  float of(int column, int row) const { return value[static_cast<std::size_t>(row * side + column)]; }
  /// Without a jump to 1 beyond its edge.
  float operator()(Vec2 p) const {
    constexpr float kRim = 10;  // cells
    Vec2 x = (p - low) / cell;
    float inside =
        std::min({x.x, x.y, static_cast<float>(side - 1) - x.x, static_cast<float>(side - 1) - x.y});
    if (inside <= 0) return 1;
    glm::ivec2 i(glm::min(glm::floor(x), Vec2(static_cast<float>(side - 2))));
    Vec2 f = x - Vec2(i);
    float here = glm::mix(glm::mix(of(i.x, i.y), of(i.x + 1, i.y), f.x),
                          glm::mix(of(i.x, i.y + 1), of(i.x + 1, i.y + 1), f.x), f.y);
    return glm::mix(1.0f, here, std::min(1.0f, inside / kRim));
  }
};

void blur(SquareField& field, int times) {
  SquareField next = field;
  for (; times > 0; --times, std::swap(field, next))
    parallel_for(static_cast<std::size_t>(field.side), [&](std::size_t r) {
      auto row = static_cast<int>(r);
      for (int column = 0; column < field.side; ++column) {
        float sum = 0;
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x)
            sum +=
                field.of(std::clamp(column + x, 0, field.side - 1), std::clamp(row + y, 0, field.side - 1));
        next.of(column, row) = sum / 9;
      }
    });
}

/// How much the wind lays down or takes at a place, as a factor: by the steepest rise of what stands before
/// the wind, and behind it.
float drifted(const SnowLand& land, const CoverGrid& bodies, const SnowWind& wind, Vec2 at) {
  // Places that are looked at: metres to the first and the farthest, and from each to the next a factor.
  constexpr float kFirstPlace = 0.3f, kLee = 5, kNextPlace = 1.25f;
  // Rise over run of what begins to stop the wind and of what stops it, and how much snow that lays down or
  // takes: by eye.
  constexpr double kLeeFrom = 0.05, kLeeFull = 0.7, kLaid = 1.1;
  constexpr double kBeforeFrom = 0.1, kBeforeFull = 1.2, kTaken = 0.7;
  if (wind.drift <= 0) return 1;
  auto height = static_cast<float>(land.height(at));
  auto steepest = [&](Vec2 toward) {
    float most = 0;
    for (float far = kFirstPlace; far < kLee; far *= kNextPlace) {
      Vec2 there = at + far * toward;
      most = std::max(most, (bodies.top(there, height) - height) / far);
    }
    return static_cast<double>(most);
  };
  double lee = smooth_step(kLeeFrom, kLeeFull, steepest(-wind.toward)),
         before = smooth_step(kBeforeFrom, kBeforeFull, steepest(wind.toward));
  return static_cast<float>(1 + wind.drift * (kLaid * lee - kTaken * before));
}

/// 1, and toward 0 at the foot of a trunk.
float hollow(const std::vector<SnowTrunk>& trunks, Vec2 at) {
  constexpr float kLeastWide = 0.12f, kByTrunk = 0.9f;  // metres, and more by the trunk's radius
  constexpr float kHollowDepth = 0.75f;                 // share of the depth
  float share = 1;
  for (const SnowTrunk& trunk : trunks) {
    float far = glm::distance(trunk.at, at) - trunk.radius, wide = kLeastWide + kByTrunk * trunk.radius;
    if (far < 3 * wide) share *= 1 - kHollowDepth * std::exp(-std::max(far, 0.0f) / wide);
  }
  return share;
}

}  // namespace

double lying_share(double up) {
  constexpr double kNone = 55, kAll = 30;  // degrees of slope
  return smooth_step(std::cos(radians(kNone)), std::cos(radians(kAll)), up);
}

CoverGrid::CoverGrid(Vec2 center, float side, float cell)
    : low_(center - side / 2),
      cell_(cell),
      side_(std::max(1, static_cast<int>(std::ceil(side / cell)))),
      block_(static_cast<int>(std::ceil(kReach / cell))),
      blocks_((side_ - 1) / block_ + 1),
      highest_(kBare) {
  auto count = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
  bottom_.assign(count, -kBare);
  top_.assign(count, kBare);
  highest_of_.assign(static_cast<std::size_t>(blocks_) * static_cast<std::size_t>(blocks_), kBare);
}

bool CoverGrid::find(Vec2 at, std::size_t& index) const {
  glm::ivec2 cell(glm::floor((at - low_) / cell_));
  if (cell.x < 0 || cell.y < 0 || cell.x >= side_ || cell.y >= side_) return false;
  index = static_cast<std::size_t>(cell.y * side_ + cell.x);
  return true;
}

void CoverGrid::add(const Surface& body) {
  auto add = [&](std::size_t cell, float low, float high) {
    bottom_[cell] = std::min(bottom_[cell], low), top_[cell] = std::max(top_[cell], high);
    highest_ = std::max(highest_, high);
    auto at = static_cast<int>(cell);
    float& of_block =
        highest_of_[static_cast<std::size_t>(at / side_ / block_ * blocks_ + at % side_ / block_)];
    of_block = std::max(of_block, high);
  };
  for (const auto& t : body.triangle) {
    std::array<Vec3, 3> p = corners_of(body, t);
    rasterize(p, low_ + cell_ / 2, cell_, glm::ivec2(side_), [&](int column, int row, float height) {
      add(static_cast<std::size_t>(row * side_ + column), height, height);
    });
    // What is upright or smaller than a cell is where its corners are.
    for (const Vec3& at : p)
      if (std::size_t cell = 0; find({at.x, at.z}, cell)) add(cell, at.y, at.y);
  }
}

float CoverGrid::top(Vec2 at, float none) const {
  std::size_t index = 0;
  return find(at, index) && top_[index] > kBare ? top_[index] : none;
}

float CoverGrid::highest_near(Vec2 at) const {
  glm::ivec2 block(glm::floor(glm::floor((at - low_) / cell_) / static_cast<float>(block_)));
  float highest = kBare;
  for (int row = std::max(block.y - 1, 0); row <= std::min(block.y + 1, blocks_ - 1); ++row)
    for (int column = std::max(block.x - 1, 0); column <= std::min(block.x + 1, blocks_ - 1); ++column)
      highest = std::max(highest, highest_of_[static_cast<std::size_t>(row * blocks_ + column)]);
  return highest;
}

float CoverGrid::openness(Vec3 at) const {
  static const std::vector<SnowFall> kFalls = falls();
  constexpr float kOff = 0.02f;                   // metres over the place: what is lower shelters nothing
  constexpr float kFirst = 1.2f, kStride = 0.7f;  // cells from the place, and from sample to sample
  float highest = highest_near({at.x, at.z});
  if (at.y + kOff > highest) return 1;
  float open = 0, all = 0;
  for (const SnowFall& fall : kFalls) {
    float level = glm::length(Vec2(fall.from.x, fall.from.z)), rise = fall.from.y / std::max(level, 1e-3f);
    all += fall.weight;
    bool blocked = false;
    std::size_t cell = 0;
    if (level < 1e-3f) {
      blocked = find({at.x, at.z}, cell) && top_[cell] > at.y + kOff;
    } else {
      Vec2 step = Vec2(fall.from.x, fall.from.z) / level;
      for (float far = kFirst * cell_; far < kReach && !blocked; far += kStride * cell_) {
        float from = at.y + kOff + (far - kStride * cell_) * rise, to = at.y + kOff + far * rise;
        if (from > highest || !find(Vec2(at.x, at.z) + far * step, cell)) break;
        blocked = from < top_[cell] && to > bottom_[cell];
      }
    }
    if (!blocked) open += fall.weight;
  }
  return open / all;
}

bool CoverGrid::shelters(Vec3 at, Vec3 fall) const {
  float stride = cell_ / std::max(glm::length(Vec2(fall.x, fall.z)), -fall.y / 4);  // seconds
  for (std::size_t cell = 0; at.y < highest_ && find({at.x, at.z}, cell); at -= stride * fall)
    if (at.y < top_[cell] && at.y - stride * fall.y > bottom_[cell]) return true;
  return false;
}

Surface snow_surface(const SnowSheet& sheet, double depth) {
  // Metres, below which it goes in patches, as floors are drawn less exactly than that.
  constexpr double kThin = 0.05;
  auto sink = static_cast<float>(kSink + kThin * (1 - smooth_step(0.0, kThin, depth)));
  Surface surface{sheet.bare, {}, sheet.triangle, {}};
  for (std::size_t i = 0; i < sheet.bare.size(); ++i)
    surface.position[i].y += static_cast<float>(depth) * sheet.share[i] - sink;
  set_normals(surface);
  return surface;
}

SnowSheet snow_on_ground(const SnowLand& land, const CoverGrid& bodies, const SnowWind& wind, Seed seed) {
  Surface mesh = ground_surface(land.height, land.center, {land.radius, land.rings});
  constexpr float kHalfField = 12, kFieldCell = 0.08f;  // metres round the middle
  constexpr int kFieldSide = 301, kBlurs = 4;           // places on a side of 24 m
  SquareField field{land.center - kHalfField, kFieldCell, kFieldSide, {}};
  field.value.resize(static_cast<std::size_t>(field.side) * static_cast<std::size_t>(field.side));
  parallel_for(static_cast<std::size_t>(field.side), [&](std::size_t r) {
    auto row = static_cast<int>(r);
    for (int column = 0; column < field.side; ++column) {
      Vec2 at = field.at(column, row);
      Vec3 ground(at.x, land.height(at), at.y);
      field.of(column, row) = bodies.openness(ground) * drifted(land, bodies, wind, at);
    }
  });
  blur(field, kBlurs);
  Vec3 shift(seed.range(-99, 99), 0, seed.child(1).range(-99, 99));
  constexpr float kWaveAlong = 1.1f, kWaveAcross = 2.6f;  // metres of wind-blown waves
  constexpr double kCalmWaves = 0.08, kDriftWaves = 0.3;  // height by the depth; and more in a strong wind
  constexpr double kLeastDepth = 0.2;                     // share of the depth
  Vec2 across(-wind.toward.y, wind.toward.x);
  SnowSheet sheet{mesh.position, std::vector<float>(mesh.position.size()), std::move(mesh.triangle)};
  parallel_for(sheet.bare.size(), [&](std::size_t i) {
    Vec2 at(sheet.bare[i].x, sheet.bare[i].z);
    Vec3 p(glm::dot(at, wind.toward) / kWaveAlong, 0, glm::dot(at, across) / kWaveAcross);
    double waves = 1 + (kCalmWaves + kDriftWaves * wind.drift) * 0.6 * fractal_noise(p + shift, 3);
    sheet.share[i] = field(at) * hollow(land.trunks, at) * static_cast<float>(std::max(kLeastDepth, waves));
    if (land.kept) sheet.share[i] *= static_cast<float>(land.kept(at));
  });
  return sheet;
}

}  // namespace frond
