#include "land/snow.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/bounds.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "land/ground.h"

namespace frond {

namespace {

constexpr float kBare = -1e30f;               // height where there is nothing
constexpr float kSink = 0.004f;               // metres below what it lies on, at which snow of no depth is
constexpr std::size_t kCapCells = 1'500'000;  // of a grid at most

/// Calls `at(column, row, height)` for each point of a grid under a triangle, points `cell` apart from `low`.
template <class At>
void rasterize(const std::array<Vec3, 3>& t, Vec2 low, float cell, glm::ivec2 size, const At& at) {
  const auto& [p, q, r] = t;
  float area = (q.x - p.x) * (r.z - p.z) - (q.z - p.z) * (r.x - p.x);
  if (std::abs(area) < 1e-12f) return;
  Vec3 least = glm::min(p, glm::min(q, r)), most = glm::max(p, glm::max(q, r));
  auto first = [&](float x, float from) {
    return std::max(0, static_cast<int>(std::ceil((x - from) / cell)));
  };
  auto last = [&](float x, float from, int count) {
    return std::min(count - 1, static_cast<int>(std::floor((x - from) / cell)));
  };
  for (int row = first(least.z, low.y); row <= last(most.z, low.y, size.y); ++row)
    for (int column = first(least.x, low.x); column <= last(most.x, low.x, size.x); ++column) {
      float dx = low.x + static_cast<float>(column) * cell - p.x,
            dz = low.y + static_cast<float>(row) * cell - p.z;
      float s = (dx * (r.z - p.z) - dz * (r.x - p.x)) / area;
      float u = ((q.x - p.x) * dz - (q.z - p.z) * dx) / area;
      if (s < -1e-4f || u < -1e-4f || s + u > 1.0001f) continue;
      at(column, row, p.y + s * (q.y - p.y) + u * (r.y - p.y));
    }
}

std::array<Vec3, 3> corners(const Surface& surface, const std::array<std::uint32_t, 3>& t) {
  return {surface.position[t[0]], surface.position[t[1]], surface.position[t[2]]};
}

/// A direction that snow falls from, and how much of it.
struct SnowFall {
  Vec3 from;
  float weight;
};

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

}  // namespace

double lying_share(double up) { return smooth_step(std::cos(radians(55.0)), std::cos(radians(30.0)), up); }

Overhead::Overhead(Vec2 center, float side, float cell)
    : low_(center - side / 2),
      cell_(cell),
      side_(std::max(1, static_cast<int>(std::ceil(side / cell)))),
      highest_(kBare) {
  auto count = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
  bottom_.assign(count, -kBare);
  top_.assign(count, kBare);
}

bool Overhead::find(Vec2 at, std::size_t& index) const {
  glm::ivec2 cell(glm::floor((at - low_) / cell_));
  if (cell.x < 0 || cell.y < 0 || cell.x >= side_ || cell.y >= side_) return false;
  index = static_cast<std::size_t>(cell.y * side_ + cell.x);
  return true;
}

bool Overhead::holds(Vec2 at) const {
  std::size_t index = 0;
  return find(at, index);
}

void Overhead::take(const Surface& body) {
  auto add = [&](std::size_t cell, float low, float high) {
    bottom_[cell] = std::min(bottom_[cell], low), top_[cell] = std::max(top_[cell], high);
    highest_ = std::max(highest_, high);
  };
  for (const auto& t : body.triangle) {
    std::array<Vec3, 3> p = corners(body, t);
    rasterize(p, low_ + cell_ / 2, cell_, glm::ivec2(side_), [&](int column, int row, float height) {
      add(static_cast<std::size_t>(row * side_ + column), height, height);
    });
    // What is upright or smaller than a cell is where its corners are.
    for (const Vec3& at : p)
      if (std::size_t cell = 0; find({at.x, at.z}, cell)) add(cell, at.y, at.y);
  }
}

float Overhead::top(Vec2 at, float none) const {
  std::size_t index = 0;
  return find(at, index) && top_[index] > kBare ? top_[index] : none;
}

float Overhead::openness(Vec3 at) const {
  static const std::vector<SnowFall> kFalls = falls();
  constexpr float kReach = 8;  // metres to the sides
  constexpr float kOff = 0.02f;
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
      for (float far = 1.2f * cell_; far < kReach && !blocked; far += 0.7f * cell_) {
        float from = at.y + kOff + (far - 0.7f * cell_) * rise, to = at.y + kOff + far * rise;
        if (from > highest_ || !find(Vec2(at.x, at.z) + far * step, cell)) break;
        blocked = from < top_[cell] && to > bottom_[cell];
      }
    }
    if (!blocked) open += fall.weight;
  }
  return open / all;
}

Surface snow_surface(const SnowSheet& sheet, double depth) {
  Surface surface{sheet.bare, {}, sheet.triangle, {}};
  for (std::size_t i = 0; i < sheet.bare.size(); ++i)
    surface.position[i].y += static_cast<float>(depth) * sheet.share[i] - kSink;
  set_normals(surface);
  return surface;
}

namespace {

/// The top of a body on a grid of points, and the snow there.
struct CapGrid {
  Vec2 low{0};
  float cell = 0.02f;
  glm::ivec2 size{0};
  float depth = 0.1f;                   // of the snow; it bridges steps of nearly half of that
  std::vector<float> top, share, edge;  // edge: metres to where it ends or drops

  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * size.x + column); }
  bool inside(int column, int row) const {
    return column >= 0 && row >= 0 && column < size.x && row < size.y;
  }
  bool there(int column, int row) const { return inside(column, row) && top[index(column, row)] > kBare; }
  Vec3 at(int column, int row) const {
    return {low.x + static_cast<float>(column) * cell, top[index(column, row)],
            low.y + static_cast<float>(row) * cell};
  }
  /// Height by which neighbours count as parts of one face.
  float step() const { return std::max(1.5f * cell, 0.45f * depth); }

  template <class Each>
  void each(const Each& each) const {
    for (int row = 0; row < size.y; ++row)
      for (int column = 0; column < size.x; ++column)
        if (there(column, row)) each(column, row);
  }
};

CapGrid cap_grid(const Surface& body, float depth, float cell) {
  Bounds box = bounds_of(body.position);
  Vec3 wide = box.size();
  cell = std::max(cell, std::sqrt(wide.x * wide.z / static_cast<float>(kCapCells)));
  CapGrid grid{Vec2(box.low.x, box.low.z) - cell,
               cell,
               glm::ivec2(static_cast<int>(wide.x / cell) + 3, static_cast<int>(wide.z / cell) + 3),
               depth,
               {},
               {},
               {}};
  grid.top.assign(static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y), kBare);
  for (const auto& t : body.triangle)
    rasterize(corners(body, t), grid.low, cell, grid.size, [&](int column, int row, float height) {
      float& top = grid.top[grid.index(column, row)];
      top = std::max(top, height);
    });
  return grid;
}

constexpr std::array<std::array<int, 2>, 8> kNeighbours{
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

/// Distance to the edge, by chamfering as far as `most`.
void find_edges(CapGrid& grid, float most) {
  grid.edge.assign(grid.top.size(), most);
  grid.each([&](int column, int row) {
    float own = grid.top[grid.index(column, row)];
    for (auto [x, y] : kNeighbours)
      if (!grid.there(column + x, row + y) || grid.top[grid.index(column + x, row + y)] < own - grid.step())
        grid.edge[grid.index(column, row)] = grid.cell / 2;
  });
  auto relax = [&](int column, int row) {
    if (!grid.there(column, row)) return;
    std::size_t i = grid.index(column, row);
    for (auto [x, y] : kNeighbours) {
      if (!grid.there(column + x, row + y)) continue;
      std::size_t k = grid.index(column + x, row + y);
      if (grid.top[k] > grid.top[i] + grid.step()) continue;  // a wall is no edge of what lies at its foot
      float far = (x != 0 && y != 0 ? 1.4142f : 1.0f) * grid.cell;
      grid.edge[i] = std::min(grid.edge[i], grid.edge[k] + far);
    }
  };
  for (int row = 0; row < grid.size.y; ++row)
    for (int column = 0; column < grid.size.x; ++column) relax(column, row);
  for (int row = grid.size.y; row-- > 0;)
    for (int column = grid.size.x; column-- > 0;) relax(column, row);
}

/// Cosine of the slope at a point, over the width that snow evens out: an edge does not tilt it.
float upward(const CapGrid& grid, int column, int row) {
  int far = std::max(1, static_cast<int>(0.4f * grid.depth / grid.cell));
  float wide = static_cast<float>(far) * grid.cell, own = grid.top[grid.index(column, row)];
  auto slope = [&](int x, int y) {
    float sum = 0;
    int count = 0;
    for (int side : {-1, 1}) {
      int c = column + side * far * x, r = row + side * far * y;
      if (!grid.there(c, r)) continue;
      float rise = grid.top[grid.index(c, r)] - own;
      if (std::abs(rise) <= grid.step() + 1.5f * wide) sum += rise * static_cast<float>(side) / wide, ++count;
    }
    return count > 0 ? sum / static_cast<float>(count) : 0;
  };
  float x = slope(1, 0), z = slope(0, 1);
  return 1 / std::sqrt(1 + x * x + z * z);
}

/// Snow fills pits and rounds what is rough: its top is that of its neighbourhood.
void round_off(CapGrid& grid, float depth) {
  constexpr int kTimes = 4;
  std::vector<float> top(grid.top.size(), kBare), next;
  grid.each([&](int column, int row) {
    std::size_t i = grid.index(column, row);
    top[i] = grid.top[i] + depth * grid.share[i];
  });
  for (int time = 0; time < kTimes; ++time) {
    next = top;
    grid.each([&](int column, int row) {
      std::size_t i = grid.index(column, row);
      if (grid.edge[i] < grid.cell) return;
      float sum = 2 * top[i], weight = 2;
      for (auto [x, y] : kNeighbours)
        if (grid.there(column + x, row + y)) {
          std::size_t k = grid.index(column + x, row + y);
          if (std::abs(grid.top[k] - grid.top[i]) <= grid.step()) sum += top[k], weight += 1;
        }
      next[i] = sum / weight;
    });
    std::swap(top, next);
  }
  // Where none may lie there is none.
  grid.each([&](int column, int row) {
    std::size_t i = grid.index(column, row);
    if (grid.share[i] > 0) grid.share[i] = std::max(0.0f, (top[i] - grid.top[i]) / depth);
  });
}

/// Lets the rim of a sheet down to what it lies on.
void add_skirt(SnowSheet& sheet) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (auto [a, b, c] : sheet.triangle) sides.insert({{a, b}, {b, c}, {c, a}});
  std::map<std::uint32_t, std::uint32_t> below;
  auto foot = [&](std::uint32_t i) {
    auto [at, fresh] = below.try_emplace(i, static_cast<std::uint32_t>(sheet.bare.size()));
    if (fresh) sheet.bare.push_back(Vec3(sheet.bare[i])), sheet.share.push_back(0);
    return at->second;
  };
  for (auto [a, b] : sides) {
    if (sides.contains({b, a})) continue;
    std::uint32_t under_a = foot(a), under_b = foot(b);
    sheet.triangle.push_back({b, a, under_a});
    sheet.triangle.push_back({b, under_a, under_b});
  }
}

SnowSheet sheet_of(const CapGrid& grid) {
  SnowSheet sheet;
  std::vector<std::uint32_t> number(grid.top.size(), UINT32_MAX);
  auto corner = [&](int column, int row) {
    std::uint32_t& own = number[grid.index(column, row)];
    if (own == UINT32_MAX) {
      own = static_cast<std::uint32_t>(sheet.bare.size());
      sheet.bare.push_back(grid.at(column, row));
      sheet.share.push_back(grid.share[grid.index(column, row)]);
    }
    return own;
  };
  auto joined = [&](std::initializer_list<glm::ivec2> points) {
    float low = -kBare, high = kBare;
    bool any = false;
    for (glm::ivec2 p : points) {
      if (!grid.there(p.x, p.y)) return false;
      std::size_t i = grid.index(p.x, p.y);
      low = std::min(low, grid.top[i]), high = std::max(high, grid.top[i]);
      any = any || grid.share[i] > 0;
    }
    return any && high - low <= 2 * grid.step();
  };
  auto add = [&](glm::ivec2 a, glm::ivec2 b, glm::ivec2 c) {
    if (joined({a, b, c})) sheet.triangle.push_back({corner(a.x, a.y), corner(b.x, b.y), corner(c.x, c.y)});
  };
  for (int row = 0; row + 1 < grid.size.y; ++row)
    for (int column = 0; column + 1 < grid.size.x; ++column) {
      glm::ivec2 a(column, row), b(column + 1, row), c(column, row + 1), d(column + 1, row + 1);
      add(a, c, b);
      add(b, c, d);
    }
  add_skirt(sheet);
  return sheet;
}

}  // namespace

SnowSheet snow_on_body(const Surface& body, double depth, float cell, const OpennessAt& openness) {
  if (body.triangle.empty() || depth <= 0) return {};
  auto deep = static_cast<float>(depth);
  CapGrid grid = cap_grid(body, deep, cell);
  find_edges(grid, deep);
  grid.share.assign(grid.top.size(), 0);
  parallel_for(static_cast<std::size_t>(grid.size.y), [&](std::size_t r) {
    auto row = static_cast<int>(r);
    for (int column = 0; column < grid.size.x; ++column) {
      if (!grid.there(column, row)) continue;
      std::size_t i = grid.index(column, row);
      auto stays = static_cast<float>(lying_share(static_cast<double>(upward(grid, column, row))));
      if (stays <= 0) continue;
      float in = 1 - grid.edge[i] / deep;
      grid.share[i] = stays * openness(grid.at(column, row)) * std::sqrt(std::max(0.0f, 1 - in * in));
    }
  });
  round_off(grid, deep);
  return sheet_of(grid);
}

namespace {

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
    Vec2 x = (p - low) / cell;
    float inside =
        std::min({x.x, x.y, static_cast<float>(side - 1) - x.x, static_cast<float>(side - 1) - x.y});
    if (inside <= 0) return 1;
    glm::ivec2 i(glm::min(glm::floor(x), Vec2(static_cast<float>(side - 2))));
    Vec2 f = x - Vec2(i);
    float here = glm::mix(glm::mix(of(i.x, i.y), of(i.x + 1, i.y), f.x),
                          glm::mix(of(i.x, i.y + 1), of(i.x + 1, i.y + 1), f.x), f.y);
    return glm::mix(1.0f, here, std::min(1.0f, inside / 10));
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
float drifted(const SnowLand& land, const Overhead& bodies, const SnowWind& wind, Vec2 at) {
  constexpr float kLee = 5;  // metres
  if (wind.drift <= 0) return 1;
  auto height = static_cast<float>(land.height(at));
  auto steepest = [&](Vec2 toward) {
    float most = 0;
    for (float far = 0.3f; far < kLee; far *= 1.25f) {
      Vec2 there = at + far * toward;
      most = std::max(most, (bodies.top(there, height) - height) / far);
    }
    return static_cast<double>(most);
  };
  double lee = smooth_step(0.05, 0.7, steepest(-wind.toward)),
         before = smooth_step(0.1, 1.2, steepest(wind.toward));
  return static_cast<float>(1 + wind.drift * (1.1 * lee - 0.7 * before));
}

/// 1, and toward 0 at the foot of a trunk.
float hollow(const std::vector<SnowTrunk>& trunks, Vec2 at) {
  float share = 1;
  for (const SnowTrunk& trunk : trunks) {
    float far = glm::distance(trunk.at, at) - trunk.radius, wide = 0.12f + 0.9f * trunk.radius;
    if (far < 3 * wide) share *= 1 - 0.75f * std::exp(-std::max(far, 0.0f) / wide);
  }
  return share;
}

}  // namespace

SnowSheet snow_on_ground(const SnowLand& land, const Overhead& bodies, const SnowWind& wind, Seed seed) {
  Surface mesh = ground_surface(land.height, land.center, land.radius, land.rings);
  SquareField field{land.center - 12.0f, 0.08f, 301, {}};
  field.value.resize(static_cast<std::size_t>(field.side) * static_cast<std::size_t>(field.side));
  parallel_for(static_cast<std::size_t>(field.side), [&](std::size_t r) {
    auto row = static_cast<int>(r);
    for (int column = 0; column < field.side; ++column) {
      Vec2 at = field.at(column, row);
      Vec3 ground(at.x, static_cast<float>(land.height(at)), at.y);
      field.of(column, row) = bodies.openness(ground) * drifted(land, bodies, wind, at);
    }
  });
  blur(field, 4);
  Vec3 shift(static_cast<float>(seed.range(-99, 99)), 0, static_cast<float>(seed.child(1).range(-99, 99)));
  Vec2 across(-wind.toward.y, wind.toward.x);
  SnowSheet sheet{mesh.position, std::vector<float>(mesh.position.size()), std::move(mesh.triangle)};
  parallel_for(sheet.bare.size(), [&](std::size_t i) {
    Vec2 at(sheet.bare[i].x, sheet.bare[i].z);
    Vec3 p(glm::dot(at, wind.toward) / 1.1f, 0, glm::dot(at, across) / 2.6f);
    double waves = 1 + (0.08 + 0.3 * wind.drift) * 0.6 * fractal_noise(p + shift, 3);
    sheet.share[i] = field(at) * hollow(land.trunks, at) * static_cast<float>(std::max(0.2, waves));
  });
  return sheet;
}

}  // namespace frond
